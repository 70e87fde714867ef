// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <functional>
#include <vector>

namespace spricka::contact {

/// A force at a point of a face.
struct FacePointForce {
  base::Vec2 r = base::Vec2::Zero(); ///< on the face
  base::Vec3 force = base::Vec3::Zero();
};

/// Forces at points of a face that a contact presses on.
struct FaceTraction {
  model::Face face;
  std::vector<FacePointForce> points;
};

/// What the multipliers of a pair of solid surfaces [normal rows, then tangential ones; stress]
/// press on the faces of both sides that `wanted` names, point by point: the sum of a face's node
/// functions times the forces is what the rows put on the nodes. Empty where rows are made of
/// single nodes (PAIRING=NODE).
std::vector<FaceTraction>
solid_pair_tractions(const PairConstraints& pair, const base::Vector& lambda,
                     const std::function<bool(const model::Face&)>& wanted);

/// What a unit of each row's multiplier presses at a point of a face.
struct FacePointRowForces {
  base::Vec2 r = base::Vec2::Zero(); ///< on the face
  struct RowForce {
    std::size_t row = 0; ///< of the pair: normal ones, then tangential ones
    base::Vec3 force = base::Vec3::Zero();
  };
  std::vector<RowForce> rows;
};
struct UnitFaceTraction {
  model::Face face;
  std::vector<FacePointRowForces> points;
};

/// The same by row: solid_pair_tractions() is their sum times the multipliers.
std::vector<UnitFaceTraction>
solid_pair_unit_tractions(const PairConstraints& pair,
                          const std::function<bool(const model::Face&)>& wanted);

} // namespace spricka::contact
