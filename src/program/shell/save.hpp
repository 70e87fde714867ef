// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/shell/session.hpp"

#include <filesystem>
#include <string>

namespace spricka::program {

/// The deck with what is set now, its includes in it: the cards as they were changed, loads and
/// fits in steps at the end, the last of them with the name NOW (or the next that is free). $GROW,
/// $SWEEP, $RESTART and $TEST become comments, $CHECK where cards have other values. `folder`:
/// where the text will be, for the names of files in it. Trouble where the order of steps cannot be
/// kept.
base::OptionalFailure make_saved_deck_text(const ShellSession& session,
                                           const std::filesystem::path& folder, std::string& text);

} // namespace spricka::program
