// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace spricka::report {

/// What an axis or the colours of a picture show, and the unit that their numbers are written in:
/// they are given in units of the deck. Words alone have none.
struct MeasureTitle {
  MeasureTitle() = default;
  MeasureTitle(const char* words) : text(words) {}
  MeasureTitle(std::string words, base::OutputUnit of_numbers = {})
      : text(std::move(words)), unit(std::move(of_numbers)) {}

  std::string text;
  base::OutputUnit unit;
};

/// "K₁  [MPa √mm]": of an axis; the name alone where the unit has none.
MeasureTitle axis_title(std::string_view name, const base::OutputUnit& unit);
/// "von Mises, MPa": of colours.
MeasureTitle legend_title(std::string_view name, const base::OutputUnit& unit);

} // namespace spricka::report
