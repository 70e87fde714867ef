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

/// The messages as format() of diagnostics.hpp gives them; on a terminal with the severity and the
/// carets in colour.
std::string format(const Sources& sources, const Diagnostics& diagnostics, Colour colour,
                   std::size_t limit = 20);

} // namespace spricka::base
