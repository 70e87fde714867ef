// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"
#include "fe/load_rule.hpp"
#include "fe/set_shares.hpp"
#include "model/loads.hpp"

#include <algorithm>

/// Loads round a tip at the points that they are integrated at (fe/load_rule.hpp), so that G and K
/// see what the solution has seen.
namespace spricka::crack {

/// A force per volume with what its rule and its set need. Refers to the loads of a tip.
struct BodyField {
  const ActingLoad* acting = nullptr;
  fe::SetShares shares;
  fe::FieldScale scale;
};

/// The forces per volume round a tip.
std::vector<BodyField> body_fields(const TipSetting& set);

/// Calls visit(r, weight, b) with forces per volume b [force/length^3] at reference points of an
/// element with nodes X.
template <shape::PlaneShape S, class Visit>
void for_body_forces(const std::vector<BodyField>& fields, base::ElementId e,
                     const fe::NodeVectors<S>& X, Visit&& visit) {
  for (const BodyField& field : fields) {
    const ActingLoad& acting = *field.acting;
    if (!std::ranges::binary_search(acting.elements, e)) {
      continue;
    }
    const fe::ElementShare* share = field.shares.of(e);
    for (const auto& point : fe::body_load_rule<S>(X, *acting.load, field.scale).points) {
      base::Vec3 x = base::Vec3::Zero();
      x.template head<2>() = X * S::N(point.r);
      const double factor = share == nullptr ? acting.factor : acting.factor * (*share)(x);
      visit(point.r, point.weight,
            base::Vec2(factor * fe::load_value(*acting.load, x).template head<2>()));
    }
  }
}

/// Scale of a load on faces, for fe::load_rule.
inline fe::FieldScale face_scale(const TipSetting& set, const ActingLoad& acting) {
  return acting.faces.empty() || !acting.load->faces.valid()
             ? fe::FieldScale()
             : fe::load_scale(set.mesh, *acting.load);
}

} // namespace spricka::crack
