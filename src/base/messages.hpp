// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Diagnostics on their way out: order, words and colour.
namespace spricka::base {

/// "error", "warning" or "note".
std::string_view word_of(Severity severity);

/// In order of file and place; those without a place first.
std::vector<const Diagnostic*> in_order(const Diagnostics& diagnostics);

enum class Colour { none, terminal };

/// The messages as text: `file:line:col: error E108: text`, source line, carets under the whole
/// token, hint. In order of file and place; at most `limit` errors, then a count of the rest.
std::string format(const Sources& sources, const Diagnostics& diagnostics, std::size_t limit = 20);

/// The same; on a terminal with the severity and the carets in colour.
std::string format(const Sources& sources, const Diagnostics& diagnostics, Colour colour,
                   std::size_t limit = 20);

} // namespace spricka::base
