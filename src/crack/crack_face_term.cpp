// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/crack_face_term.hpp"

#include "mesh/plane_edge.hpp"
#include "shape/quadrature.hpp"

#include <cmath>
#include <numbers>

namespace spricka::crack {

using mesh::PlaneEdge;

namespace {

// Of the quadrature. With xi + 1 = 2 t^2 from the tip on, products with 1/sqrt(r) are polynomials
// in t on straight edges, with and without a quarter point.
constexpr int degree = 9;
// The near-tip fields jump across the crack's line: they are taken this part of the distance to the
// tip inside the body.
constexpr double inside = 1e-9;

std::size_t nodes_of(const PlaneEdge& edge) {
  return static_cast<std::size_t>(edge.count);
}

// A point of a face: what integrals along it need.
struct CrackFacePoint {
  double w = 0.0;   ///< weight by xi
  double ds = 0.0;  ///< |dx/dxi|
  base::Vec2 along; ///< unit tangent
  base::Vec2 x;
  std::array<double, 3> N, dN;
};

std::vector<CrackFacePoint> points_of(const PlaneEdge& edge, base::NodeId tip) {
  std::vector<CrackFacePoint> points;
  for (const auto& [r, weight] : shape::line_rule(degree)) {
    double xi = r[0];
    double w = weight;
    if (edge.nodes[0] == tip || edge.nodes[1] == tip) {
      const double t = 0.5 * (1.0 + r[0]);
      const double from = edge.nodes[0] == tip ? 1.0 : -1.0;
      xi = from * (2.0 * t * t - 1.0);
      // d xi = 4 t dt, and dt is half of dr.
      w = 2.0 * t * weight;
    }
    CrackFacePoint p;
    p.N = edge_N(edge, xi);
    p.dN = edge_dN(edge, xi);
    p.x = base::Vec2::Zero();
    base::Vec2 dx = base::Vec2::Zero();
    for (std::size_t i = 0; i < nodes_of(edge); ++i) {
      p.x += p.N[i] * edge.x[i];
      dx += p.dN[i] * edge.x[i];
    }
    p.w = w;
    p.ds = dx.norm();
    p.along = dx / p.ds;
    points.push_back(p);
  }
  return points;
}

using NodeAreas = std::map<base::NodeId, double>;

// What stands behind a point of the faces.
double depth_of(const TipBody& tip, const CrackFacePoint& p) {
  return tip.is_axisymmetric() ? 2.0 * std::numbers::pi * p.x.x() : tip.thickness;
}
// The same for a unit of the front.
double depth_per_front(const TipBody& tip, const CrackFacePoint& p) {
  return tip.is_axisymmetric() ? p.x.x() / tip.frame.x.x() : 1.0;
}

// A_i of (crack.33) with what stands behind it, sums over the edges of a node.
NodeAreas areas_of(const std::vector<PlaneEdge>& edges, const TipBody& tip) {
  NodeAreas area;
  for (const PlaneEdge& edge : edges) {
    for (const CrackFacePoint& p : points_of(edge, tip.node)) {
      for (std::size_t i = 0; i < nodes_of(edge); ++i) {
        area[edge.nodes[i]] += p.w * p.ds * p.N[i] * depth_of(tip, p);
      }
    }
  }
  return area;
}

// Where a middle node has all of an edge's pressure at the axis: its end there has no area.
bool is_on_axis(const PlaneEdge& edge, std::size_t end) {
  return edge.count == 3 && edge.x[end].x() <= 1e-9 * edge.x[1 - end].x();
}

// Where the pressure of a node acts on an edge: its own function, with that of the tip added to its
// neighbour's, as no force between the faces is known there. At the axis likewise.
std::array<double, 3> pressed(const PlaneEdge& edge, const std::array<double, 3>& N,
                              const TipBody& tip) {
  std::array<double, 3> own = N;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    if (edge.nodes[end] == tip.node || (tip.is_axisymmetric() && is_on_axis(edge, end))) {
      own[edge.count == 3 ? 2 : 1 - end] += N[end];
      own[end] = 0.0;
    }
  }
  return own;
}

// Calls add(edge, i, point, weight / area) for the nodes i of all face edges that the field moves:
// weight is that of the integral of q times the node's function.
template <class Add>
void for_faces(const model::Mesh& mesh, const TipBody& tip, const ExtensionField& field,
               const std::vector<model::Face>& faces, Add&& add) {
  std::vector<PlaneEdge> edges;
  edges.reserve(faces.size());
  for (const model::Face& face : faces) {
    edges.push_back(mesh::plane_edge(mesh, face));
  }
  const NodeAreas area = areas_of(edges, tip);
  const std::map<base::NodeId, double> q = field.extension_by_node();
  for (const PlaneEdge& edge : edges) {
    std::array<double, 3> moved{};
    bool moves = false;
    for (std::size_t i = 0; i < nodes_of(edge); ++i) {
      const auto at = q.find(edge.nodes[i]);
      moved[i] = at == q.end() ? 0.0 : at->second;
      moves = moves || moved[i] > 0.0;
    }
    if (!moves) {
      continue;
    }
    for (const CrackFacePoint& p : points_of(edge, tip.node)) {
      double here = 0.0;
      for (std::size_t i = 0; i < nodes_of(edge); ++i) {
        here += p.N[i] * moved[i];
      }
      const std::array<double, 3> own = pressed(edge, p.N, tip);
      for (std::size_t i = 0; i < nodes_of(edge); ++i) {
        if (own[i] != 0.0) {
          // (crack.33): the force of a node over its area is its traction.
          add(edge, i, p,
              p.w * p.ds * depth_per_front(tip, p) * here * own[i] / area.at(edge.nodes[i]));
        }
      }
    }
  }
}

} // namespace

CrackFaceWeights crack_face_weights(const model::Mesh& mesh, const TipBody& tip,
                                    const ExtensionField& field,
                                    const std::vector<model::Face>& faces) {
  CrackFaceWeights weights;
  for_faces(mesh, tip, field, faces,
            [&](const PlaneEdge& edge, std::size_t i, const CrackFacePoint& p, double weight) {
              const auto [at, fresh] = weights.try_emplace(
                  edge.nodes[i], std::array<base::Vec2, 2>{base::Vec2::Zero(), base::Vec2::Zero()});
              // Edges run with the body on their left.
              const base::Vec2 inward(-p.along.y(), p.along.x());
              const base::Vec2 x = p.x + inside * (p.x - tip.frame.x).norm() * inward;
              for (int mode = 1; mode <= 2; ++mode) {
                at->second[static_cast<std::size_t>(mode - 1)] -=
                    weight *
                    (near_tip_gradient(tip.frame, x, mode, tip.material, tip.state) * tip.frame.e1);
              }
            });
  return weights;
}

std::array<double, 3> crack_face_term(const model::Mesh& mesh, const TipBody& tip,
                                      const ExtensionField& field,
                                      const CrackFaceForces& crack_faces, const base::Vector& u) {
  const auto at = [](const base::Vector& nodal, base::NodeId n) -> base::Vec2 {
    return nodal.segment<2>(2 * static_cast<Eigen::Index>(n.index()));
  };
  std::array<double, 3> sum{};
  for (const auto& [node, weight] : crack_face_weights(mesh, tip, field, crack_faces.faces)) {
    sum[1] += weight[0].dot(at(crack_faces.force, node));
    sum[2] += weight[1].dot(at(crack_faces.force, node));
  }
  for_faces(mesh, tip, field, crack_faces.faces,
            [&](const PlaneEdge& edge, std::size_t i, const CrackFacePoint& p, double weight) {
              base::Vec2 along = base::Vec2::Zero(); // du/ds
              for (std::size_t k = 0; k < nodes_of(edge); ++k) {
                along += p.dN[k] / p.ds * at(u, edge.nodes[k]);
              }
              // (crack.31) with the components along e1 only: u1,1 is du1/ds with the sign by which
              // the face runs along e1.
              sum[0] -= weight * at(crack_faces.force, edge.nodes[i]).dot(tip.frame.e1) *
                        along.dot(tip.frame.e1) * p.along.dot(tip.frame.e1);
            });
  return sum;
}

} // namespace spricka::crack
