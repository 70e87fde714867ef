// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string_view>

namespace spricka::base {

/// How the program ends, for scripts. The table of manual/exit_codes.md is this one.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int check_failed = 1;
inline constexpr int usage = 2;
inline constexpr int deck_error = 3;
inline constexpr int not_solvable = 4;
inline constexpr int not_converged = 5;
inline constexpr int stopped = 6;
inline constexpr int file_trouble = 7;
inline constexpr int defect = 70; ///< EX_SOFTWARE: a defect of the program, never of the deck
} // namespace exit_code

struct ExitText {
  int code;
  std::string_view meaning;
};

inline constexpr std::array exit_texts{
    ExitText{exit_code::done, "done; every $CHECK passed"},
    ExitText{exit_code::check_failed,
             "done, but a $CHECK failed; format --check: the layout would change"},
    ExitText{exit_code::usage, "the command line is wrong"},
    ExitText{exit_code::deck_error, "the deck has mistakes; each is printed with its place"},
    ExitText{exit_code::not_solvable,
             "the model cannot be solved, or has a card this version does not have"},
    ExitText{exit_code::not_converged, "the solution did not converge"},
    ExitText{exit_code::stopped,
             "stopped by --time or a signal, what is finished is kept; run --restart goes on"},
    ExitText{exit_code::file_trouble,
             "trouble with a file: the deck itself, the run folder or a restart file"},
    ExitText{exit_code::defect, "a defect of the program: please report it, with the deck"},
};

} // namespace spricka::base
