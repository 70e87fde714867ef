// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/tip_result.hpp"

#include "results/output_word.hpp"

#include <algorithm>

namespace spricka::results {

bool TipQuantity::is_given(const TipResult& tip) const {
  switch (given) {
  case TipQuantityCondition::in_one_material:
    return !tip.two_materials;
  case TipQuantityCondition::with_bar:
    return tip.no_bar.empty();
  case TipQuantityCondition::with_opening:
    return tip.K_opening.has_value();
  case TipQuantityCondition::always:
    break;
  }
  return true;
}

std::string TipQuantity::check_word() const {
  std::string word = output_column_name(name);
  std::ranges::replace(word, '_', '.');
  return word;
}

const TipQuantity* find_tip_quantity(std::string_view check_word) {
  const std::string_view word = check_word == "K" ? "K1" : check_word;
  const auto* const found = std::ranges::find_if(tip_quantities, [&](const TipQuantity& q) {
    return q.appears_in(in_check) && q.check_word() == word;
  });
  return found == tip_quantities.end() ? nullptr : found;
}

} // namespace spricka::results
