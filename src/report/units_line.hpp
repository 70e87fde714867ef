// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// The columns of a table by what they measure.
class ColumnUnits {
public:
  /// A column, or words for several of them; the same words again are left out.
  void add_column(base::QuantityKind kind, const std::string& words);
  /// "x y [mm], theta [deg], p_lumped [MPa], increment [1]": kinds in the order in which they came,
  /// plain numbers last.
  [[nodiscard]] std::string units_text(const base::UnitSystem& units) const;

private:
  struct ColumnUnitGroup {
    base::QuantityKind kind;
    std::vector<std::string> words;
  };
  std::vector<ColumnUnitGroup> kinds_;
};

} // namespace spricka::report
