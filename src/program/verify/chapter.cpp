// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/chapter.hpp"

#include "program/verify/verification_tables.hpp"

#include <fmt/format.h>

namespace spricka::program {

namespace {

// A cell of a table: a bar of its own would end it.
std::string cell_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '|' ? "\\|" : std::string(1, c);
  }
  return out;
}

std::string markdown(const report::ReportTable& table, bool code_first) {
  std::string names = "|";
  std::string rule = "|";
  for (const report::ReportTable::ReportColumn& column : table.columns) {
    names += fmt::format(" {} |", column.name);
    rule += column.words ? "---|" : "---:|";
  }
  std::string out = names + "\n" + rule + "\n";
  for (const std::vector<std::string>& row : table.rows) {
    out += "|";
    for (std::size_t c = 0; c < row.size(); ++c) {
      out += c == 0 && code_first ? fmt::format(" `{}` |", row[c])
                                  : fmt::format(" {} |", cell_text(row[c]));
    }
    out += "\n";
  }
  return out + "\n";
}

std::string head(const Verification& verification) {
  std::string out = R"(# Verification

Every deck in `decks/` carries its reference values and the error that is allowed (`$CHECK`). This page is what the
decks find; [`spricka verify all --markdown FILE`](verify.md) writes it. The tests run the same decks. A check whose
source is `RECORDED` compares with an earlier value of this program and proves only that the value has not changed.

)";
  for (const std::string& line : summary(verification)) {
    out += line + "\n";
  }
  return out + fmt::format("Times and memory: {}, one thread, {} decks at a time.\n\n",
                           verification.machine, verification.at_once);
}

std::string deck_section(const Verification& verification, const std::string& table_name) {
  return fmt::format(R"(## Decks

The table has a row for each deck, and for a deck with a sweep a row for each run. The column "error / allowed" has
the largest error of the run's checks over the error that is allowed. CPU time and memory are those of the whole deck.

All single checks are in the file [{0}]({0}), a row for each check: the run, the
quantity with its crack and step, the value found, its reference, the error, the allowed error, the error bar of K and
the source. The page [verify](verify.md#what-it-writes) explains the columns.

)",
                     table_name) +
         markdown(deck_table(verification), true);
}

std::string problem_sections(const Verification& verification,
                             const std::vector<BenchmarkProblem>& problems) {
  if (problems.empty()) {
    return {};
  }
  std::string out = "## Problems of the open collections\n\n" +
                    markdown(problem_table(verification, problems), false);
  const report::ReportTable missing = uncovered_table(problems);
  if (!missing.rows.empty()) {
    out += "## Not covered\n\n" + markdown(missing, false);
  }
  return out;
}

} // namespace

std::string verification_chapter(const Verification& verification,
                                 const std::vector<BenchmarkProblem>& problems,
                                 const std::string& table_name) {
  std::string out = head(verification) + problem_sections(verification, problems) +
                    deck_section(verification, table_name);
  out.erase(out.find_last_not_of('\n') + 1);
  return out + "\n";
}

} // namespace spricka::program
