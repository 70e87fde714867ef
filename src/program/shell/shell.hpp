// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/run_options.hpp"

namespace spricka::program {

struct ShellOptions {
  RunOptions deck; ///< its deck, defines, threads, quiet and log format
  bool strict = false;
};

/// Reads commands about a deck until they end: from a terminal with line editing, else plain lines
/// from stdin. Data goes to stdout, messages to stderr. Returns 0, or with `strict` the code of the
/// first command that failed, behind which nothing is read; or why the deck cannot be opened.
base::ProgramOutcome run_shell(const ShellOptions& options);

} // namespace spricka::program
