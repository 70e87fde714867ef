// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"
#include "fe/load_rule.hpp"
#include "fe/set_shares.hpp"

#include <functional>
#include <vector>

/// Loads round a tip at the points that they are integrated at (fe/load_rule.hpp), so that G and K
/// see what the solution has seen.
namespace spricka::crack {

/// A force per volume with what its rule and its set need. Refers to the loads of a tip.
struct BodyForceField {
  const ActingLoad* acting = nullptr;
  fe::SetShares shares;
  fe::FieldScale scale;
};

/// The forces per volume round a tip.
std::vector<BodyForceField> body_force_fields(const TipSetting& set);

/// Visits the points of an element with nodes X: reference point, weight and the forces per volume
/// b there [force/length^3].
using BodyForceVisit =
    std::function<void(const shape::Point<2>& r, double weight, const base::Vec2& b)>;
/// Goes through the points of all body forces that act on element `e`, one force after the other,
/// each with its own rule; shares of cut sets and load factors are in b.
void for_body_forces(const TipSetting& set, const std::vector<BodyForceField>& fields,
                     base::ElementId e, const PlaneVectors& X, const BodyForceVisit& visit);

/// Scale of a load on faces, for fe::load_rule.
inline fe::FieldScale face_scale(const TipSetting& set, const ActingLoad& acting) {
  return acting.faces.empty() || !acting.load->faces.valid()
             ? fe::FieldScale()
             : fe::load_scale(set.mesh, *acting.load);
}

} // namespace spricka::crack
