// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::program {

/// The whole program: reads the command line, runs the command and returns the exit code. Mistakes
/// in the command line go to stderr, with what was probably meant. --version tells the digest of
/// the sources that the program is made of (cmake/source_digest).
int run_command_line(int argc, const char* const* argv, const std::string& source_digest);

} // namespace spricka::program
