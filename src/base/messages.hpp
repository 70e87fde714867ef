// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Diagnostics on their way out: order, words and colour.
namespace spricka::base {

/// "error", "warning" or "note".
std::string_view display_word(Severity severity);

/// The worst first: errors, warnings by their doubt, notes; of alike those without a place, then by
/// file and place.
std::vector<const Diagnostic*> messages_by_severity(const Diagnostics& diagnostics);

enum class MessageColour { none, terminal };

/// The messages as text: `file:line:col: error E108: text`, source line, carets under the whole
/// token, hint. In that order; at most `limit` errors and warnings, then a count of the rest.
std::string format_messages(const SourceTexts& sources, const Diagnostics& diagnostics,
                            std::size_t limit = 20);

/// The same; on a terminal with the severity and the carets in colour.
std::string format_messages(const SourceTexts& sources, const Diagnostics& diagnostics,
                            MessageColour colour, std::size_t limit = 20);

} // namespace spricka::base
