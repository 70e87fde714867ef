// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification.hpp"

#include "base/exit_codes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string many(std::size_t n, const char* word) {
  return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
}

void count_check(const results::CheckResult& check, VerificationCounts& counts) {
  if (has_recorded_reference(check)) {
    ++counts.recorded;
    counts.recorded_missed += check.passed ? 0 : 1;
    return;
  }
  ++counts.checks;
  counts.missed += check.passed ? 0 : 1;
  if (std::isfinite(check.bar)) {
    ++counts.bars;
    const double off = std::abs(check.found - check.wanted);
    const std::optional<double> accuracy = reference_accuracy(check);
    if (off <= check.bar) {
      ++counts.within_bars;
    } else if (!accuracy) {
      ++counts.of_no_accuracy;
    } else if (off <= check.bar + *accuracy) {
      ++counts.within_accuracy;
    }
  }
}

} // namespace

std::size_t VerifiedDeck::missed_check_count() const {
  std::ptrdiff_t passed = 0;
  std::size_t all = 0;
  for (const VerifiedPoint& point : points) {
    passed += std::ranges::count_if(point.checks, &results::CheckResult::passed);
    all += point.checks.size();
  }
  return all - static_cast<std::size_t>(passed);
}

std::optional<double> reference_accuracy(const results::CheckResult& check) {
  const std::size_t sign = check.source.find("+- ");
  if (sign == std::string::npos) {
    return std::nullopt;
  }
  const char* const begin = check.source.data() + sign + 3;
  const char* const end = check.source.data() + check.source.size();
  double value = 0.0;
  const auto [rest, status] = std::from_chars(begin, end, value);
  if (status != std::errc() || !std::string_view(rest, end).starts_with(" %")) {
    return std::nullopt;
  }
  return 0.01 * value * std::abs(check.wanted);
}

bool has_recorded_reference(const results::CheckResult& check) {
  return check.source == "RECORDED";
}

bool has_reference(const VerifiedDeck& deck) {
  return std::ranges::any_of(deck.points, [](const VerifiedPoint& point) {
    return std::ranges::any_of(
        point.checks, [](const results::CheckResult& c) { return !has_recorded_reference(c); });
  });
}

VerificationCounts count(const Verification& verification) {
  VerificationCounts counts;
  for (const VerifiedDeck& deck : verification.decks) {
    const std::size_t recorded = counts.recorded;
    for (const VerifiedPoint& point : deck.points) {
      ++counts.points;
      for (const results::CheckResult& check : point.checks) {
        count_check(check, counts);
      }
    }
    if (has_reference(deck)) {
      ++counts.with_reference;
    } else if (counts.recorded > recorded) {
      ++counts.recorded_only;
    } else if (!deck.failed()) {
      ++counts.unchecked;
    }
    counts.failed += deck.failed() ? 1 : 0;
    counts.cpu += deck.cpu;
    counts.memory = std::max(counts.memory, deck.memory);
  }
  return counts;
}

base::Outcome worst_outcome(const Verification& verification) {
  base::Outcome worst = base::Outcome::done;
  for (const VerifiedDeck& deck : verification.decks) {
    const base::Outcome own = deck.late ? base::Outcome::stopped
                                        : base::outcome_of_exit_code(deck.exit_code)
                                              .value_or(base::Outcome::defect); // a signal
    worst = std::max(worst, own);
  }
  return worst;
}

std::vector<std::string> summary(const Verification& verification) {
  const VerificationCounts counts = count(verification);
  std::vector<std::string> lines{
      fmt::format("{} with a reference, {}, {}: {} passed, {} missed.",
                  many(counts.with_reference, "deck"), many(counts.points, "run"),
                  many(counts.checks, "check"), counts.checks - counts.missed, counts.missed)};
  if (counts.recorded > 0 || counts.unchecked > 0) {
    lines.push_back(fmt::format(
        "Apart from these: {} with a value that this program has recorded, {} missed; {} with "
        "nothing else, {} without a check, which prove that they run.",
        many(counts.recorded, "check"), counts.recorded_missed, many(counts.recorded_only, "deck"),
        counts.unchecked));
  }
  if (counts.failed > 0) {
    lines.push_back(fmt::format("{} did not end with exit code 0.", many(counts.failed, "deck")));
  }
  if (counts.bars > 0) {
    const std::size_t beyond =
        counts.bars - counts.within_bars - counts.within_accuracy - counts.of_no_accuracy;
    lines.push_back(fmt::format(
        "K against {}: {} within the printed error bar, {} within it and the accuracy that the "
        "source states of itself, {} beyond both; of {} the source states none.",
        many(counts.bars, "reference"), counts.within_bars, counts.within_accuracy, beyond,
        counts.of_no_accuracy));
  }
  return lines;
}

} // namespace spricka::program
