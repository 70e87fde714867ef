// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/problems.hpp"

#include "base/input_file.hpp"
#include "program/trials/csv_rows.hpp"

#include <sstream>

namespace spricka::program {

namespace {

std::vector<std::string> blank_separated(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    words.push_back(word);
  }
  return words;
}

} // namespace

std::vector<BenchmarkProblem> read_problems(const std::filesystem::path& folder) {
  std::vector<BenchmarkProblem> problems;
  if (!std::filesystem::exists(folder / problems_name)) {
    return problems;
  }
  const auto rows = csv_rows(base::read_file(folder / problems_name, base::largest_number_file));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<std::string> row = rows[i];
    row.resize(5);
    problems.push_back({.name = row[0],
                        .title = row[1],
                        .decks = blank_separated(row[2]),
                        .tests = blank_separated(row[3]),
                        .remark = row[4]});
  }
  return problems;
}

} // namespace spricka::program
