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

std::string markdown(const report::Table& table, bool code_first) {
  std::string names = "|";
  std::string rule = "|";
  for (const report::Table::Column& column : table.columns) {
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

Every deck in `decks/` carries its reference values and the error that is allowed (`$CHECK`). This chapter is
what they find, made by [`spricka verify all --markdown`](verify.md); the tests run the same decks. A source
`RECORDED` is a value of this program itself and proves nothing but that it stayed the same.

)";
  for (const std::string& line : summary(verification)) {
    out += line + "\n";
  }
  return out + fmt::format("Times and memory: {}, one thread, {} decks at a time.\n\n",
                           verification.machine, verification.at_once);
}

std::string problem_sections(const Verification& verification,
                             const std::vector<Problem>& problems) {
  if (problems.empty()) {
    return {};
  }
  std::string out = "## Problems of the open collections\n\n" +
                    markdown(problem_table(verification, problems), false);
  const report::Table missing = uncovered_table(problems);
  if (!missing.rows.empty()) {
    out += "## Not covered\n\n" + markdown(missing, false);
  }
  return out;
}

} // namespace

std::string verification_chapter(const Verification& verification,
                                 const std::vector<Problem>& problems) {
  std::string out = head(verification) + problem_sections(verification, problems);
  std::string unchecked;
  for (const VerifiedDeck& deck : verification.decks) {
    bool any = false;
    for (const VerifiedPoint& point : deck.points) {
      const report::Table table = check_table(point);
      if (!table.rows.empty()) {
        out += fmt::format("## {}\n\n{}.\n\n{}", heading_of(deck, point), cost_of(deck, point),
                           markdown(table, true));
        any = true;
      }
    }
    if (!any) {
      unchecked += fmt::format("{}`{}`", unchecked.empty() ? "" : ", ", deck.name);
    }
  }
  if (!unchecked.empty()) {
    out += "## Decks without a check\n\n" + unchecked + "\n";
  }
  out.erase(out.find_last_not_of('\n') + 1);
  return out + "\n";
}

} // namespace spricka::program
