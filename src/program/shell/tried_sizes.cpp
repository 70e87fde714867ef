// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/tried_sizes.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <utility>

namespace spricka::program {

CrackSize crack_size(const model::Model& model, const results::LoadStepResult& state,
                     std::size_t crack) {
  const model::CrackDefinition& card = model.cracks[crack];
  if (card.kind == model::CrackDefinitionKind::ellipse) {
    return {card.plane.a, card.plane.c};
  }
  for (const results::FrontResult& front : state.fronts) {
    if (front.name == card.name || front.name == card.name + ".1") {
      return {front.a, 0.0};
    }
  }
  return {card.a0.value_or(0.0), 0.0};
}

void TriedSizes::add(const std::string& setting, FrontsAtSize found) {
  const auto same_size = [](const auto& one, const auto& other) {
    return one.a == other.a && one.length == other.length;
  };
  std::erase_if(known_, [&](const TriedSize& k) {
    return k.setting == setting && std::ranges::equal(k.found.fronts, found.fronts, same_size);
  });
  known_.push_back({setting, std::move(found)});
}

std::vector<FrontsAtSize> TriedSizes::at(const std::string& setting) const {
  std::vector<FrontsAtSize> out;
  for (const TriedSize& known : known_) {
    if (known.setting == setting) {
      out.push_back(known.found);
    }
  }
  std::ranges::stable_sort(out, {}, [](const FrontsAtSize& t) {
    return std::pair(t.size.c > 0.0 ? t.size.a : t.a, t.size.c);
  });
  return out;
}

} // namespace spricka::program
