// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

/// What the word that begins at `begin` of a line typed so far may become; empty: a file, or
/// nothing is known. Names are in the case of the word's beginning.
std::vector<std::string> complete_shell_line(const ShellSession& session, std::string_view line,
                                             std::size_t begin);

} // namespace spricka::program
