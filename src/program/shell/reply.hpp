// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// What a line of the shell gives back.
struct ShellReply {
  std::string out;      ///< data
  std::string messages; ///< notes, warnings and errors
  base::ProgramOutcome outcome = base::ProgramOutcome::done;
  double cpu = 0.0; ///< [s]
  bool quit = false;
};

/// What has been typed so far, for `history`.
using ShellHistory = std::vector<std::string>;

} // namespace spricka::program
