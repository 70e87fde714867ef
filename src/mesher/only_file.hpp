// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace spricka::mesher {

/// Makes the one file that the process can open once it is locked in: a text in memory. Then
/// whoever in the process asks the kernel for a file, gmsh or what it uses, gets this one, for
/// reading, if the name is right, else "permission denied". False if the kernel does not let us.
bool make_memory_file();

/// Gives the file a name and a text.
bool set_memory_file(const std::string& file, std::string_view text);

} // namespace spricka::mesher
