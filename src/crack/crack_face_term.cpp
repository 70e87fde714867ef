// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/crack_face_term.hpp"

#include "crack/tip_fields.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

using geometry::ElementSide;
using geometry::SideValues;

namespace {

// The near-tip fields jump across the crack's line: they are taken this part of the distance to the
// tip inside the body.
constexpr double into_body = 1e-9;

// A point of a face: what integrals along it need.
struct CrackFacePoint {
  double w = 0.0;   ///< weight by xi
  double ds = 0.0;  ///< |dx/dxi|
  base::Vec2 along; ///< unit tangent
  base::Vec2 x;
  SideValues N, dN;
};

std::vector<CrackFacePoint> points_of(const TipContext& tip, const ElementSide& edge) {
  std::vector<CrackFacePoint> points;
  for (const auto& [r, weight] : tip_side_quadrature(tip, edge)) {
    CrackFacePoint& p = points.emplace_back();
    p.N = edge.N(r);
    p.dN = edge.dN(r).col(0);
    p.x = (edge.X * p.N).head<2>();
    const base::Vec2 dx = (edge.X * p.dN).head<2>();
    p.w = weight;
    p.ds = dx.norm();
    p.along = dx / p.ds;
  }
  return points;
}

using NodeAreas = std::map<base::NodeId, double>;

// What stands behind a point of the faces.
double depth_of(const TipContext& tip, const CrackFacePoint& p) {
  return tip.is_axisymmetric() ? 2.0 * std::numbers::pi * p.x.x() : tip.property.thickness;
}

// A_i of (crack.33) with what stands behind it, sums over the edges of a node.
NodeAreas areas_of(const std::vector<ElementSide>& edges, const TipContext& tip) {
  NodeAreas area;
  for (const ElementSide& edge : edges) {
    for (const CrackFacePoint& p : points_of(tip, edge)) {
      for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
        area[edge.nodes[i]] += p.w * p.ds * p.N[static_cast<Eigen::Index>(i)] * depth_of(tip, p);
      }
    }
  }
  return area;
}

// Where a middle node has all of an edge's pressure at the axis: its end there has no area.
bool is_on_axis(const ElementSide& edge, Eigen::Index end) {
  return edge.is_quadratic() && edge.X(0, end) <= 1e-9 * edge.X(0, 1 - end);
}

// Where the pressure of a node acts on an edge: its own function, with that of the tip added to its
// neighbour's, as no force between the faces is known there. At the axis likewise.
SideValues pressed(const ElementSide& edge, const SideValues& N, const TipContext& tip) {
  SideValues own = N;
  for (const Eigen::Index end : {Eigen::Index{0}, Eigen::Index{1}}) {
    if (edge.nodes[static_cast<std::size_t>(end)] == tip.tip_node ||
        (tip.is_axisymmetric() && is_on_axis(edge, end))) {
      own[edge.is_quadratic() ? 2 : 1 - end] += N[end];
      own[end] = 0.0;
    }
  }
  return own;
}

// Calls add(edge, i, point, weight / area) for the nodes i of all face edges that the field moves:
// weight is that of the integral of q times the node's function.
template <class Add>
void for_faces(const TipContext& tip, const VirtualExtensionField& field,
               const std::vector<model::Face>& faces, Add&& add) {
  std::vector<ElementSide> edges;
  edges.reserve(faces.size());
  for (const model::Face& face : faces) {
    edges.push_back(model::element_side(tip.mesh, face));
  }
  const NodeAreas area = areas_of(edges, tip);
  const std::map<base::NodeId, double> q = field.extension_by_node();
  for (const ElementSide& edge : edges) {
    SideValues moved = SideValues::Zero(static_cast<Eigen::Index>(edge.nodes.size()));
    for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
      moved[static_cast<Eigen::Index>(i)] = extension_of_node(q, edge.nodes[i]);
    }
    if (!(moved.array() > 0.0).any()) {
      continue;
    }
    for (const CrackFacePoint& p : points_of(tip, edge)) {
      const double here = p.N.dot(moved);
      const SideValues own = pressed(edge, p.N, tip);
      for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
        if (const double part = own[static_cast<Eigen::Index>(i)]; part != 0.0) {
          // (crack.33): the force of a node over its area is its traction.
          add(edge, i, p,
              p.w * p.ds * tip.relative_depth(p.x) * here * part / area.at(edge.nodes[i]));
        }
      }
    }
  }
}

} // namespace

CrackFaceWeights crack_face_weights(const TipContext& tip, const VirtualExtensionField& field,
                                    const std::vector<model::Face>& faces) {
  CrackFaceWeights weights;
  for_faces(tip, field, faces,
            [&](const ElementSide& edge, std::size_t i, const CrackFacePoint& p, double weight) {
              const auto [at, fresh] = weights.try_emplace(
                  edge.nodes[i], std::array<base::Vec2, 2>{base::Vec2::Zero(), base::Vec2::Zero()});
              // Edges run with the body on their left.
              const base::Vec2 inward(-p.along.y(), p.along.x());
              const base::Vec2 x = p.x + into_body * (p.x - tip.tip.x).norm() * inward;
              for (std::size_t mode = 1; mode <= 2; ++mode) {
                at->second[mode - 1] -=
                    weight * (auxiliary_field_gradient(tip, polar_coordinates(tip.tip, x), mode) *
                              tip.tip.e1);
              }
            });
  return weights;
}

std::array<double, 3> crack_face_term(const TipContext& tip, const VirtualExtensionField& field,
                                      const ForcesBetweenCrackFaces& crack_faces,
                                      const base::Vector& u) {
  const auto at = [](const base::Vector& nodal, base::NodeId n) -> base::Vec2 {
    return nodal.segment<2>(2 * static_cast<Eigen::Index>(n.index()));
  };
  std::array<double, 3> sum{};
  for (const auto& [node, weight] : crack_face_weights(tip, field, crack_faces.faces)) {
    sum[1] += weight[0].dot(at(crack_faces.force, node));
    sum[2] += weight[1].dot(at(crack_faces.force, node));
  }
  for_faces(tip, field, crack_faces.faces,
            [&](const ElementSide& edge, std::size_t i, const CrackFacePoint& p, double weight) {
              base::Vec2 along = base::Vec2::Zero(); // du/ds
              for (std::size_t k = 0; k < edge.nodes.size(); ++k) {
                along += p.dN[static_cast<Eigen::Index>(k)] / p.ds * at(u, edge.nodes[k]);
              }
              // (crack.31) with the components along e1 only: u1,1 is du1/ds with the sign by which
              // the face runs along e1.
              sum[0] -= weight * at(crack_faces.force, edge.nodes[i]).dot(tip.tip.e1) *
                        along.dot(tip.tip.e1) * p.along.dot(tip.tip.e1);
            });
  return sum;
}

} // namespace spricka::crack
