// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <cstdint>
#include <string>

namespace spricka::report {

/// The name of a deck's file as a report shows it: seen from the deck's own folder, so that it is
/// the same wherever the deck lies and the program is started. "" for a file that is not there.
std::string relative_deck_file_name(const base::SourceTexts& sources, std::int32_t file);

} // namespace spricka::report
