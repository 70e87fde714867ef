// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verification_csv.hpp"

#include "base/input_file.hpp"
#include "program/trials/csv_rows.hpp"
#include "program/verify/deck_list.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// In the order of the file.
constexpr std::array columns{"deck",     "title", "point",  "quantity",  "reference", "source",
                             "result",   "error", "kind",   "allowed",   "bar",       "passed",
                             "freedoms", "cpu",   "memory", "exit_code", "program",   "machine"};

std::string number_or_none(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string check_fields(const results::CheckResult* check) {
  if (check == nullptr) {
    return ",,,,,,,,";
  }
  const bool found = check->trouble.empty();
  return fmt::format("{},{},{},{},{},{},{},{},{:d}", csv_field(check->text),
                     number_or_none(check->wanted),
                     csv_field(found ? check->source : check->source + " (" + check->trouble + ")"),
                     found ? number_or_none(check->found) : "",
                     found ? number_or_none(check->error) : "", check->relative ? "REL" : "ABS",
                     number_or_none(check->tolerance), number_or_none(check->bar), check->passed);
}

class Writer {
public:
  explicit Writer(const Verification& verification)
      : origin_(csv_field(verification.program) + "," + csv_field(verification.machine)) {}

  void add(const VerifiedDeck& deck, const VerifiedPoint* point,
           const results::CheckResult* check) {
    text += fmt::format("{},{},{},{},{},{:.3f},{:.1f},{},{}\n", csv_field(deck.name),
                        csv_field(deck.title), csv_field(point == nullptr ? "" : point->values),
                        check_fields(check),
                        point == nullptr ? "" : std::to_string(point->unknowns), deck.cpu,
                        static_cast<double>(deck.memory) / bytes_of_MB, deck.exit_code, origin_);
  }

  std::string text;

private:
  std::string origin_;
};

double number_in(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

using Row = std::vector<std::string>;

const std::string& cell(const Row& row, const char* name) {
  static const std::string none;
  const auto at = static_cast<std::size_t>(std::ranges::find(columns, std::string_view(name)) -
                                           columns.begin());
  return at < row.size() ? row[at] : none;
}

void take_row(const Row& row, Verification& out) {
  if (out.decks.empty() || out.decks.back().name != cell(row, "deck")) {
    VerifiedDeck& deck = out.decks.emplace_back();
    deck.name = cell(row, "deck");
    deck.title = cell(row, "title");
    deck.cpu = number_in(cell(row, "cpu"));
    deck.memory = static_cast<std::size_t>(bytes_of_MB * number_in(cell(row, "memory")));
    deck.exit_code = static_cast<int>(number_in(cell(row, "exit_code")));
  }
  VerifiedDeck& deck = out.decks.back();
  if (cell(row, "quantity").empty()) {
    return;
  }
  if (deck.points.empty() || deck.points.back().values != cell(row, "point")) {
    deck.points.push_back({.values = cell(row, "point"), .unknowns = 0, .checks = {}});
  }
  results::CheckResult& check = deck.points.back().checks.emplace_back();
  check.text = cell(row, "quantity");
  check.error = number_in(cell(row, "error"));
  check.tolerance = number_in(cell(row, "allowed"));
  check.passed = cell(row, "passed") == "1";
}

} // namespace

std::string verification_csv(const Verification& verification) {
  Writer writer(verification);
  writer.text = fmt::format("# quantities in the units of their deck; error and allowed of kind "
                            "REL are parts of the reference; cpu in s, memory in MB, of the whole "
                            "deck\n{}\n",
                            fmt::join(columns, ","));
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const VerifiedPoint& point : deck.points) {
      for (const results::CheckResult& check : point.checks) {
        writer.add(deck, &point, &check);
        any = true;
      }
    }
    if (!any) {
      writer.add(deck, deck.points.empty() ? nullptr : &deck.points.front(), nullptr);
    }
  }
  return std::move(writer.text);
}

std::optional<Verification> read_verification_csv(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    return std::nullopt;
  }
  const std::vector<Row> rows = csv_rows(base::read_file(file, base::largest_number_file));
  if (rows.size() < 2 || !std::ranges::equal(rows.front(), columns)) {
    return std::nullopt;
  }
  Verification out;
  out.program = cell(rows[1], "program");
  out.machine = cell(rows[1], "machine");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    take_row(rows[i], out);
  }
  return out;
}

} // namespace spricka::program
