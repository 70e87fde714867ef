// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/units_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace spricka::report {

void ColumnUnits::add_column(base::QuantityKind kind, const std::string& words) {
  auto found = std::ranges::find(kinds_, kind, &ColumnUnitGroup::kind);
  if (found == kinds_.end()) {
    found = kinds_.insert(found, ColumnUnitGroup{kind, {}});
  }
  if (std::ranges::find(found->words, words) == found->words.end()) {
    found->words.push_back(words);
  }
}

std::string ColumnUnits::units_text(const base::UnitSystem& units) const {
  std::string text;
  std::string numbers;
  for (const ColumnUnitGroup& of : kinds_) {
    if (of.kind == base::QuantityKind::number) {
      numbers = fmt::format(", {} [1]", fmt::join(of.words, " and "));
      continue;
    }
    text += fmt::format("{}{} [{}]", text.empty() ? "" : ", ", fmt::join(of.words, " "),
                        base::output_unit(units, of.kind).name);
  }
  return text + numbers;
}

} // namespace spricka::report
