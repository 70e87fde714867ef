// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/point_support.hpp"

#include "fe/element.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::estimate {

namespace {

/// Forces that hold a node of the elements, and how soft the body is.
struct HeldNode {
  base::Matrix force;   ///< [2, goals]
  double modulus = 0.0; ///< E' times thickness
};

HeldNode hold(const CornerSearchInput& setting, const SingularCorner& corner,
              const base::Matrix& z) {
  HeldNode held{base::Matrix::Zero(2, z.cols()), 0.0};
  const model::Mesh& mesh = setting.mesh;
  for (const base::ElementId e : corner.elements) {
    const fe::ConstitutiveLaw law = fe::constitutive_law(setting.model, mesh, e);
    const fe::AnyElement<2>& element = shape::reference_element<2>(mesh.type[e.index()]);
    const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
    // On an axis a ring as wide as the elements stands for the point.
    const fe::AnyNodeVectors<2> X = fe::element_coordinates(element, mesh, e);
    const double x = std::max(mesh.x[corner.node.index()].x(), X.row(0).mean());
    // E' of (fe.4) by Lame's constants; with the reduced lambda of plane stress it is E.
    held.modulus =
        law.depth(x) * 4.0 * law.mu * (law.lambda + law.mu) / (law.lambda + 2.0 * law.mu);
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
      fe::AnyNodeVectors<2> U(2, element.nodes);
      for (int i = 0; i < element.nodes; ++i) {
        U.col(i) = z.col(k).segment<2>(
            2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(i)].index()));
      }
      // What the elements at the node ask of it in the adjoint: its reaction R_z (estimate.18).
      const fe::AnyNodeVectors<2> F = fe::element_force(element, X, law, U);
      for (int i = 0; i < element.nodes; ++i) {
        if (nodes[static_cast<std::size_t>(i)] == corner.node) {
          held.force.col(k) += F.col(i);
        }
      }
    }
  }
  return held;
}

} // namespace

PointSupportRefinementChange
point_support_refinement_change(const CornerSearchInput& setting,
                                const std::vector<SingularCorner>& corners,
                                const base::Vector& reaction, const base::Matrix& z) {
  PointSupportRefinementChange giving{base::Vector::Zero(z.cols()), {}};
  double most = -1.0;
  for (const SingularCorner& corner : corners) {
    if (!corner.held_alone[0] && !corner.held_alone[1]) {
      continue;
    }
    const HeldNode held = hold(setting, corner, z);
    // Flamant: u = 2 P / (pi E' t) log r under a force on the edge of a half plane
    const double soft = 2.0 * std::numbers::ln2 / (std::numbers::pi * held.modulus);
    double largest = 0.0;
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
      double change = 0.0;
      for (Eigen::Index c = 0; c < 2; ++c) {
        if (corner.held_alone[static_cast<std::size_t>(c)]) {
          change += soft * reaction[2 * static_cast<Eigen::Index>(corner.node.index()) + c] *
                    held.force(c, k);
        }
      }
      giving.change[k] += std::abs(change);
      largest = std::max(largest, std::abs(change));
    }
    if (largest > most) {
      most = largest;
      giving.node = corner.node;
    }
  }
  return giving;
}

} // namespace spricka::estimate
