// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification.hpp"

#include "base/csv.hpp"
#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "program/verify/deck_list.hpp"

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
    const std::optional<double> accuracy = stated_reference_accuracy(check);
    if (off <= check.bar) {
      ++counts.within_bars;
    } else if (!accuracy) {
      ++counts.of_no_accuracy;
    } else if (off <= check.bar + *accuracy) {
      ++counts.within_accuracy;
    }
  }
}

// In the order of the file.
constexpr std::string_view columns =
    "deck,title,point,quantity,reference,source,result,error,kind,allowed,bar,passed,freedoms,cpu,"
    "memory,exit_code,program,machine";

const double none = std::nan("");

base::CsvRow check_fields(const results::CheckResult& check) {
  const bool found = check.trouble.empty();
  return {{"quantity", check.text},
          {"reference", check.wanted},
          {"source", found ? check.source : check.source + " (" + check.trouble + ")"},
          {"result", found ? check.found : none},
          {"error", found ? check.error : none},
          {"kind", check.relative ? "REL" : "ABS"},
          {"allowed", check.tolerance},
          {"bar", check.bar},
          {"passed", check.passed}};
}

base::CsvRow deck_fields(const Verification& verification, const VerifiedDeck& deck,
                         const DeckRunChecks* point) {
  return {{"deck", deck.name},
          {"title", deck.title},
          {"point", point == nullptr ? "" : point->values},
          {"freedoms", point == nullptr ? std::nullopt : std::optional(point->unknowns)},
          {"cpu", fmt::format("{:.3f}", deck.cpu)},
          {"memory", fmt::format("{:.1f}", megabytes(deck.peak_memory))},
          {"exit_code", deck.exit_code},
          {"program", verification.program},
          {"machine", verification.machine}};
}

void read_row(const base::CsvRecord& row, Verification& out) {
  if (out.decks.empty()) {
    out.program = row.text("program");
    out.machine = row.text("machine");
  }
  if (out.decks.empty() || out.decks.back().name != row.text("deck")) {
    VerifiedDeck& deck = out.decks.emplace_back();
    deck.name = row.text("deck");
    deck.title = row.text("title");
    deck.cpu = row.number("cpu", none);
    deck.peak_memory = bytes_from_megabytes(row.number("memory", 0.0));
    deck.exit_code = static_cast<int>(row.number("exit_code", 0.0));
  }
  VerifiedDeck& deck = out.decks.back();
  if (row.text("quantity").empty()) {
    return;
  }
  if (deck.points.empty() || deck.points.back().values != row.text("point")) {
    deck.points.push_back({.values = row.text("point")});
  }
  results::CheckResult& check = deck.points.back().checks.emplace_back();
  check.text = row.text("quantity");
  check.error = row.number("error", none);
  check.tolerance = row.number("allowed", none);
  check.passed = row.text("passed") == "1";
}

} // namespace

std::vector<results::CheckResult> checks_at_all_points(const VerifiedDeck& deck) {
  std::vector<results::CheckResult> checks;
  for (const DeckRunChecks& point : deck.points) {
    checks.insert(checks.end(), point.checks.begin(), point.checks.end());
  }
  return checks;
}

std::size_t VerifiedDeck::missed_check_count() const {
  return static_cast<std::size_t>(
      std::ranges::count(checks_at_all_points(*this), false, &results::CheckResult::passed));
}

std::optional<double> stated_reference_accuracy(const results::CheckResult& check) {
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

bool has_check_with_reference(const VerifiedDeck& deck) {
  return !std::ranges::all_of(checks_at_all_points(deck), has_recorded_reference);
}

VerificationCounts count_checks_and_costs(const Verification& verification) {
  VerificationCounts counts;
  for (const VerifiedDeck& deck : verification.decks) {
    const std::size_t recorded = counts.recorded;
    counts.points += deck.points.size();
    for (const results::CheckResult& check : checks_at_all_points(deck)) {
      count_check(check, counts);
    }
    if (has_check_with_reference(deck)) {
      ++counts.with_reference;
    } else if (counts.recorded > recorded) {
      ++counts.recorded_only;
    } else if (!deck.failed()) {
      ++counts.unchecked;
    }
    counts.failed += deck.failed() ? 1 : 0;
    counts.cpu += deck.cpu;
    counts.memory = std::max(counts.memory, deck.peak_memory);
  }
  return counts;
}

base::ProgramOutcome worst_outcome(const Verification& verification) {
  base::ProgramOutcome worst = base::ProgramOutcome::done;
  for (const VerifiedDeck& deck : verification.decks) {
    const base::ProgramOutcome own = deck.late
                                         ? base::ProgramOutcome::stopped
                                         : base::outcome_of_exit_code(deck.exit_code)
                                               .value_or(base::ProgramOutcome::defect); // a signal
    worst = std::max(worst, own);
  }
  return worst;
}

std::vector<std::string> verification_summary(const Verification& verification) {
  const VerificationCounts counts = count_checks_and_costs(verification);
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

std::string verification_csv(const Verification& verification) {
  base::CsvTable csv(columns,
                     "# quantities in the units of their deck; error and allowed of kind REL are "
                     "parts of the reference; cpu in s, memory in MB, of the whole deck");
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const DeckRunChecks& point : deck.points) {
      for (const results::CheckResult& check : point.checks) {
        csv.add_row(deck_fields(verification, deck, &point), check_fields(check));
        any = true;
      }
    }
    if (!any) {
      csv.add_row(
          deck_fields(verification, deck, deck.points.empty() ? nullptr : &deck.points.front()));
    }
  }
  return csv.text();
}

std::optional<Verification> read_verification_csv(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    return std::nullopt;
  }
  const std::string text = base::read_file(file, base::largest_number_file);
  const std::vector<std::vector<std::string>> rows = base::parse_csv_rows(text);
  if (rows.size() < 2 || fmt::format("{}", fmt::join(rows.front(), ",")) != columns) {
    return std::nullopt;
  }
  Verification out;
  for (const base::CsvRecord& row : base::parse_csv_records(text)) {
    read_row(row, out);
  }
  return out;
}

} // namespace spricka::program
