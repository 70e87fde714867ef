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

/// Whether a suggestion for one more error is worth its search through all names: who has made so
/// many mistakes does not read them, and with as many names it takes for ever.
inline bool is_worth_a_hint(const Diagnostics& diagnostics) {
  constexpr std::size_t many = 100;
  return diagnostics.error_count() < many;
}

enum class Colour { none, terminal };

/// The messages as format() of diagnostics.hpp gives them; on a terminal with the severity and the
/// carets in colour.
std::string format(const Sources& sources, const Diagnostics& diagnostics, Colour colour,
                   std::size_t limit = 20);

} // namespace spricka::base
