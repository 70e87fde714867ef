// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_loads.hpp"

#include "model/loads.hpp"

#include <algorithm>

namespace spricka::crack {

namespace {

base::Vec2 components(const model::Load& load, const base::Vec2& x) {
  const base::Vec3 at(x.x(), x.y(), 0.0);
  base::Vec2 value = base::Vec2::Zero();
  for (std::size_t k = 0; k < std::min<std::size_t>(2, load.value.size()); ++k) {
    value[static_cast<Eigen::Index>(k)] = load.value[k](at);
  }
  return value;
}

} // namespace

bool TipLoads::has_element_loads() const {
  return temperature.size() > 0 ||
         std::ranges::any_of(loads, [](const ActingLoad& a) { return !a.elements.empty(); });
}

base::Vec2 traction(const ActingLoad& acting, const base::Vec2& x, const base::Vec2& n) {
  const base::Vec2 value = components(*acting.load, x);
  return acting.load->type == model::LoadType::pressure ? base::Vec2(-acting.factor * value.x() * n)
                                                        : base::Vec2(acting.factor * value);
}

} // namespace spricka::crack
