// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/plane_side.hpp"

namespace spricka::crack {

SideVectors PlaneSide::positions_from_tip(const base::Vec2& tip) const {
  return X.topRows<2>().colwise() - tip;
}

SideVectors PlaneSide::gather(const base::Vector& u) const {
  SideVectors U(2, shape.nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    U.col(static_cast<Eigen::Index>(i)) =
        u.segment<2>(2 * static_cast<Eigen::Index>(nodes[i].index()));
  }
  return U;
}

} // namespace spricka::crack
