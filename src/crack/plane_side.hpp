// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/jacobian.hpp"
#include "model/mesh_side.hpp"

#include <vector>

namespace spricka::crack {

/// Values at the nodes of a side, and vectors in the section.
using SideValues = fe::NodeValues<fe::AnyElement<1>>;
using SideVectors = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, shape::most_nodes<1>>;

/// A side of an element of a section.
struct PlaneSide : geometry::ElementSide {
  const fe::AnyElement<1>& shape; ///< of one local coordinate

  PlaneSide(const model::Mesh& mesh, const model::Face& face)
      : ElementSide(model::element_side(mesh, face)), shape(reference<1>()) {}

  /// Nodes as seen from the tip: of points much nearer to it than sixteen digits of their
  /// coordinates tell, as a rule has them where a load jumps at the tip, the distance is right even
  /// so.
  [[nodiscard]] SideVectors positions_from_tip(const base::Vec2& tip) const;
  /// Displacements of the nodes.
  [[nodiscard]] SideVectors gather(const base::Vector& u) const;
};

} // namespace spricka::crack
