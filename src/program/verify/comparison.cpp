// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/comparison.hpp"

#include "report/drawing/columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double another_error = 1.1;
constexpr double part_of_allowed = 0.01;
constexpr double slower_by = 1.5;
constexpr double noise_of_starts = 4.0;
constexpr double larger_by = 1.2;

using Errors = std::map<std::string, const results::CheckResult*>;

// Checks by point and text; one that stands there twice is told apart by a number.
Errors errors_of(const VerifiedDeck& deck) {
  Errors all;
  for (const DeckRunChecks& point : deck.points) {
    for (const results::CheckResult& check : point.checks) {
      const std::string name =
          point.values.empty() ? check.text : fmt::format("{}, {}", check.text, point.values);
      std::string unique = name;
      for (int n = 2; !all.emplace(unique, &check).second; ++n) {
        unique = fmt::format("{} ({})", name, n);
      }
    }
  }
  return all;
}

void compare_errors(const VerifiedDeck& now, const VerifiedDeck& before,
                    VerificationComparison& out) {
  const Errors earlier = errors_of(before);
  for (const auto& [what, check] : errors_of(now)) {
    const auto found = earlier.find(what);
    if (found == earlier.end()) {
      continue;
    }
    const double a = std::abs(found->second->error);
    const double b = std::abs(check->error);
    const bool counts = std::abs(b - a) > part_of_allowed * check->tolerance;
    const VerificationChange change{now.name, what, a, b};
    if (check->passed != found->second->passed) {
      (check->passed ? out.passed : out.failed).push_back(change);
    } else if (counts && b > another_error * a) {
      out.worse.push_back(change);
    } else if (counts && a > another_error * b) {
      out.better.push_back(change);
    }
  }
}

using Pairs = std::vector<std::pair<const VerifiedDeck*, const VerifiedDeck*>>;

double median_ratio(const Pairs& pairs) {
  std::vector<double> ratios;
  for (const auto& [now, before] : pairs) {
    if (now->cpu > 0.0 && before->cpu > 0.0) {
      ratios.push_back(now->cpu / before->cpu);
    }
  }
  if (ratios.empty()) {
    return 1.0;
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  return *middle;
}

void compare_costs(const Pairs& pairs, VerificationComparison& out) {
  out.pace = median_ratio(pairs);
  double start = pairs.empty() ? 0.0 : pairs.front().first->cpu;
  for (const auto& [now, before] : pairs) {
    start = std::min(start, now->cpu);
  }
  for (const auto& [now, before] : pairs) {
    const double expected = out.pace * before->cpu;
    const VerificationChange cpu{now->name, {}, before->cpu, now->cpu};
    if (now->cpu > slower_by * expected && now->cpu - expected > noise_of_starts * start) {
      out.slower.push_back(cpu);
    } else if (expected > slower_by * now->cpu && expected - now->cpu > noise_of_starts * start) {
      out.faster.push_back(cpu);
    }
    if (static_cast<double>(now->peak_memory) >
        larger_by * static_cast<double>(before->peak_memory)) {
      out.larger.push_back({now->name,
                            {},
                            static_cast<double>(before->peak_memory),
                            static_cast<double>(now->peak_memory)});
    }
  }
}

} // namespace

VerificationComparison compare_verifications(const Verification& now, const Verification& before) {
  VerificationComparison out;
  out.program = before.program;
  out.machine = before.machine;
  out.same_machine = now.machine == before.machine;
  Pairs pairs;
  for (const VerifiedDeck& deck : now.decks) {
    const auto found = std::ranges::find(before.decks, deck.name, &VerifiedDeck::name);
    if (found != before.decks.end()) {
      compare_errors(deck, *found, out);
      pairs.emplace_back(&deck, &*found);
    }
  }
  if (out.same_machine) {
    compare_costs(pairs, out);
  }
  return out;
}

bool VerificationComparison::is_unchanged() const {
  return std::ranges::all_of(
      change_kinds, [this](const ChangeKind& kind) { return (this->*kind.changes).empty(); });
}

std::string comparison_summary(const VerificationComparison& comparison) {
  std::string text;
  for (const ChangeKind& kind : change_kinds) {
    if (const std::size_t n = (comparison.*kind.changes).size(); n > 0) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", kind.in_summary, n);
    }
  }
  return text.empty() ? "nothing has changed" : text;
}

report::ReportTable verification_change_table(const VerificationComparison& comparison) {
  using Row = std::pair<const ChangeKind*, VerificationChange>;
  std::vector<Row> rows;
  for (const ChangeKind& kind : change_kinds) {
    for (const VerificationChange& change : comparison.*kind.changes) {
      rows.emplace_back(&kind, change);
    }
  }
  return report::Columns<Row>()
      .words("what", [](const Row& row) { return row.first->in_table; })
      .words("deck", [](const Row& row) { return row.second.deck; })
      .words("check", [](const Row& row) { return row.second.what; })
      .number(
          "before", "", [](const Row& row) { return row.first->unit * row.second.before; },
          "{:.3g}")
      .number(
          "now", "", [](const Row& row) { return row.first->unit * row.second.now; }, "{:.3g}")
      .table("", rows);
}

} // namespace spricka::program
