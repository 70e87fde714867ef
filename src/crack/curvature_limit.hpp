// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/extension.hpp"

#include <map>

namespace spricka::crack {

/// How far domains may reach where a front bends. Elements that a domain strains reach farther than
/// the nodes that it moves: to where places along the front run together, or across to where
/// another part of it is nearer.
class DomainCurvatureLimit {
public:
  /// `closed`: the last point joins the first. Mesh and front must outlive it.
  DomainCurvatureLimit(const model::Mesh& mesh, const mesh::CrackFront& front, bool closed)
      : mesh_(mesh), front_(front), closed_(closed) {}

  /// Whether the elements of a point's domain come near the centre of curvature, or the front turns
  /// too much within one of them.
  [[nodiscard]] bool is_exceeded(std::size_t point, const VirtualExtensionField& field);

private:
  /// How a node lies to the place of the front nearest to it.
  struct NodeFrontPosition {
    base::Vec3 m = base::Vec3::UnitX();
    double to_centre = 0.0; ///< part of the way to the centre of curvature, below 0 away from it
  };
  const NodeFrontPosition& place_at(base::NodeId n);
  [[nodiscard]] double turn_beside(std::size_t point) const;

  const model::Mesh& mesh_;
  const mesh::CrackFront& front_;
  bool closed_;
  std::map<base::NodeId, NodeFrontPosition> near_front_;
};

} // namespace spricka::crack
