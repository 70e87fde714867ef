// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>

namespace spricka::base {

/// A file or folder that ships with the program, by its path in an installation:
/// "share/spricka/decks", "libexec/spricka/spricka-mesher". It is looked for beside the file that
/// holds this code, the program or the shared library, in its folder and in those above: so it is
/// found in /usr, in an archive unpacked anywhere, and in a build tree. Links are followed. Empty:
/// it is not there.
std::filesystem::path find_shipped_file(const std::filesystem::path& relative);

} // namespace spricka::base
