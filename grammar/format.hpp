// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"

#include <optional>
#include <string>

namespace spricka::grammar {

/// One file of a deck in canonical layout. Cards, keys and words of the language in capitals, names
/// as written; one blank between the parameters of a header, none round = and commas; data lines
/// indented by two, what stands in a net by two more; rows of tables ($COOR, $ELEMENT) and the
/// spacing inside data lines as they are; at least two blanks before a trailing comment, which
/// keeps its column if it can; a comment line is indented as the line below it; at most one blank
/// line, no blank at the end of a line, line feeds only. The cards mean the same before and after,
/// and a second time changes nothing. Empty after a syntax error, which is reported.
std::optional<std::string> format_deck(const base::SourceTexts& sources, std::int32_t file,
                                       base::Diagnostics& diagnostics);

} // namespace spricka::grammar
