// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>

namespace spricka::program {

/// The decks that ship with the running program: share/spricka/decks beside its bin, or for a
/// program of a build tree those of its source. Empty if there are none.
std::filesystem::path shipped_decks();

} // namespace spricka::program
