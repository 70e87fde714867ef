// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_csv.hpp"

#include "base/csv.hpp"
#include "base/input_file.hpp"
#include "program/trials/child_run.hpp"
#include "program/verify/deck_list.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace spricka::program {

namespace {

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
                         const VerifiedPoint* point) {
  return {{"deck", deck.name},
          {"title", deck.title},
          {"point", point == nullptr ? "" : point->values},
          {"freedoms", point == nullptr ? std::nullopt : std::optional(point->unknowns)},
          {"cpu", fmt::format("{:.3f}", deck.cpu)},
          {"memory", fmt::format("{:.1f}", megabytes(deck.memory))},
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
    deck.memory = bytes_of(row.number("memory", 0.0));
    deck.exit_code = static_cast<int>(row.number("exit_code", 0.0));
  }
  VerifiedDeck& deck = out.decks.back();
  if (row.text("quantity").empty()) {
    return;
  }
  if (deck.points.empty() || deck.points.back().values != row.text("point")) {
    deck.points.push_back({.values = row.text("point"), .unknowns = 0, .checks = {}});
  }
  results::CheckResult& check = deck.points.back().checks.emplace_back();
  check.text = row.text("quantity");
  check.error = row.number("error", none);
  check.tolerance = row.number("allowed", none);
  check.passed = row.text("passed") == "1";
}

} // namespace

std::string verification_csv(const Verification& verification) {
  base::CsvTable csv(columns,
                     "# quantities in the units of their deck; error and allowed of kind REL are "
                     "parts of the reference; cpu in s, memory in MB, of the whole deck");
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const VerifiedPoint& point : deck.points) {
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
