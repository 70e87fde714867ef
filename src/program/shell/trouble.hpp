// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/exit_codes.hpp"

#include <optional>
#include <string>
#include <utility>

namespace spricka::program {

/// Why a command of the shell has no answer, with the exit code that a run would end with.
struct ShellTrouble {
  int exit_code = base::exit_code::usage;
  std::string why;
  std::string hint;      ///< what was probably meant; may be empty
  bool complete = false; ///< `why` is whole messages with their places, ended by a newline
};

/// Empty: done.
using ShellResult = std::optional<ShellTrouble>;

} // namespace spricka::program
