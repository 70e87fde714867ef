// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

/// What scripts see of an outcome: numbers, for the command line and for what it prints. The table
/// of manual/exit_codes.md is this one.
namespace spricka::base {

struct ExitCodeEntry {
  ProgramOutcome outcome;
  int code;
  std::string_view meaning;
};

/// [ProgramOutcome]
inline constexpr std::array exit_code_table{
    ExitCodeEntry{ProgramOutcome::done, 0, "done; every $CHECK passed"},
    ExitCodeEntry{ProgramOutcome::check_failed, 1,
                  "done, but a $CHECK failed; format --check: the layout would change"},
    ExitCodeEntry{ProgramOutcome::usage, 2, "the command line is wrong"},
    ExitCodeEntry{ProgramOutcome::deck_error, 3,
                  "the deck has mistakes; each is printed with its place"},
    ExitCodeEntry{ProgramOutcome::not_solvable, 4,
                  "the model cannot be solved, or has a card this version does not have"},
    ExitCodeEntry{ProgramOutcome::not_converged, 5, "the solution did not converge"},
    ExitCodeEntry{ProgramOutcome::stopped, 6,
                  "stopped by --time or a signal, what is finished is kept; run --restart goes on"},
    ExitCodeEntry{ProgramOutcome::file_trouble, 7,
                  "trouble with a file: the deck itself, the run folder or a restart file"},
    ExitCodeEntry{ProgramOutcome::defect, 70, // EX_SOFTWARE
                  "a defect of the program: please report it, with the deck"},
};

/// The exit status of the process for an outcome.
constexpr int exit_code(ProgramOutcome outcome) {
  return exit_code_table.at(static_cast<std::size_t>(outcome)).code;
}

/// Empty: a number with which the program does not end.
constexpr std::optional<ProgramOutcome> outcome_of_exit_code(int code) {
  const auto* const found = std::ranges::find(exit_code_table, code, &ExitCodeEntry::code);
  return found == exit_code_table.end() ? std::nullopt : std::optional(found->outcome);
}

} // namespace spricka::base
