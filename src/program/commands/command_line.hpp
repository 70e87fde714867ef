// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::program {

/// The whole program: reads the command line, runs the command and returns the exit code. Mistakes
/// in the command line go to stderr, with what was probably meant.
int run_command_line(int argc, const char* const* argv);

} // namespace spricka::program
