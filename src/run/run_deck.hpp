// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::run {

/// Exit codes, documented in manual/exit_codes.md.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int check_failed = 1;
inline constexpr int usage = 2;
inline constexpr int deck_error = 3;
inline constexpr int not_solvable = 4;
inline constexpr int not_converged = 5;
inline constexpr int stopped = 6;
inline constexpr int file_trouble = 7;
} // namespace exit_code

struct RunOptions {
  std::filesystem::path deck;
  std::filesystem::path out; ///< empty: the deck's name with .run, in the working directory
  std::vector<std::pair<std::string, std::string>> defines;
  int threads = -1; ///< below 0: as $CONTROL says; 0: all cores
  bool quiet = false;
  bool check_only = false;
};

/// Reads, checks and (unless check_only) solves a deck and writes its run folder; messages go to
/// stderr, the table of results to stdout. Returns the exit code.
int run_deck(const RunOptions& options);

} // namespace spricka::run
