// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace spricka::program {

/// The table beside the decks that says which of them stands for which problem of the open
/// collections: problem,title,decks,tests,remark.
inline constexpr const char* problems_name = "problems.csv";

/// A problem of the open collections.
struct BenchmarkProblem {
  std::string name; ///< "C03"
  std::string title;
  std::vector<std::string> decks; ///< by name
  std::vector<std::string> tests; ///< other than decks: names of CTest's
  std::string remark;             ///< of one that has neither: why it is not covered

  [[nodiscard]] bool is_covered() const { return !decks.empty() || !tests.empty(); }
};

/// The problems of a folder of decks, in the order of the table; none where there is no table.
/// Throws std::system_error.
std::vector<BenchmarkProblem> read_problems(const std::filesystem::path& folder);

} // namespace spricka::program
