// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/lip_term.hpp"

#include "shape/quadrature.hpp"
#include "shape/topology.hpp"

#include <cmath>
#include <span>

namespace spricka::crack {

namespace {

// Of the quadrature. With xi + 1 = 2 t^2 from the tip on, products with 1/sqrt(r) are polynomials
// in t on straight edges, with and without a quarter point.
constexpr int degree = 9;
// The near-tip fields jump across the crack's line: they are taken this part of the distance to the
// tip inside the body.
constexpr double inside = 1e-9;

// One side of an element on a face: ends and, if there is one, the middle node; the body on the
// left from the first end to the second.
struct FaceEdge {
  std::array<base::NodeId, 3> node;
  std::array<base::Vec2, 3> x;
  std::size_t count = 2;
};

FaceEdge edge_of(const model::Mesh& mesh, const model::Face& face) {
  const std::span<const base::NodeId> nodes = mesh.nodes_of(face.element);
  const std::span<const int> side = shape::side_nodes(mesh.type[face.element.index()], face.side);
  FaceEdge edge;
  edge.count = side.size();
  for (std::size_t i = 0; i < side.size(); ++i) {
    edge.node[i] = nodes[static_cast<std::size_t>(side[i])];
    edge.x[i] = mesh.x[edge.node[i].index()].head<2>();
  }
  return edge;
}

std::array<double, 3> shape_at(const FaceEdge& edge, double xi) {
  return edge.count == 2
             ? std::array<double, 3>{0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0}
             : std::array<double, 3>{0.5 * xi * (xi - 1.0), 0.5 * xi * (xi + 1.0), 1.0 - xi * xi};
}
std::array<double, 3> slope_at(const FaceEdge& edge, double xi) {
  return edge.count == 2 ? std::array<double, 3>{-0.5, 0.5, 0.0}
                         : std::array<double, 3>{xi - 0.5, xi + 0.5, -2.0 * xi};
}

// A point of a face: what integrals along it need.
struct FacePoint {
  double w = 0.0;   ///< weight by xi
  double ds = 0.0;  ///< |dx/dxi|
  base::Vec2 along; ///< unit tangent
  base::Vec2 x;
  std::array<double, 3> N, dN;
};

std::vector<FacePoint> points_of(const FaceEdge& edge, base::NodeId tip) {
  std::vector<FacePoint> points;
  for (const auto& [r, weight] : shape::line_rule(degree)) {
    double xi = r[0];
    double w = weight;
    if (edge.node[0] == tip || edge.node[1] == tip) {
      const double t = 0.5 * (1.0 + r[0]);
      const double from = edge.node[0] == tip ? 1.0 : -1.0;
      xi = from * (2.0 * t * t - 1.0);
      w = 2.0 * t * weight;
    }
    FacePoint p;
    p.N = shape_at(edge, xi);
    p.dN = slope_at(edge, xi);
    p.x = base::Vec2::Zero();
    base::Vec2 dx = base::Vec2::Zero();
    for (std::size_t i = 0; i < edge.count; ++i) {
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

NodeAreas areas_of(const std::vector<FaceEdge>& edges, base::NodeId tip) {
  NodeAreas area;
  for (const FaceEdge& edge : edges) {
    for (const FacePoint& p : points_of(edge, tip)) {
      for (std::size_t i = 0; i < edge.count; ++i) {
        area[edge.node[i]] += p.w * p.ds * p.N[i];
      }
    }
  }
  return area;
}

// Where the pressure of a node acts on an edge: its own function, with that of the tip added to its
// neighbour's, as no force between the faces is known there.
std::array<double, 3> pressed(const FaceEdge& edge, const std::array<double, 3>& N,
                              base::NodeId tip) {
  std::array<double, 3> own = N;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    if (edge.node[end] == tip) {
      own[edge.count == 3 ? 2 : 1 - end] += N[end];
      own[end] = 0.0;
    }
  }
  return own;
}

// Calls add(edge, i, point, weight / area) for the nodes i of all face edges that the field moves:
// weight is that of the integral of q times the node's function.
template <class Add>
void for_faces(const model::Mesh& mesh, const TipPlace& tip, const ExtensionField& field,
               const std::vector<model::Face>& faces, Add&& add) {
  std::vector<FaceEdge> edges;
  edges.reserve(faces.size());
  for (const model::Face& face : faces) {
    edges.push_back(edge_of(mesh, face));
  }
  const NodeAreas area = areas_of(edges, tip.node);
  const std::map<base::NodeId, double> q(field.q.begin(), field.q.end());
  for (const FaceEdge& edge : edges) {
    std::array<double, 3> moved{};
    bool moves = false;
    for (std::size_t i = 0; i < edge.count; ++i) {
      const auto at = q.find(edge.node[i]);
      moved[i] = at == q.end() ? 0.0 : at->second;
      moves = moves || moved[i] > 0.0;
    }
    if (!moves) {
      continue;
    }
    for (const FacePoint& p : points_of(edge, tip.node)) {
      double here = 0.0;
      for (std::size_t i = 0; i < edge.count; ++i) {
        here += p.N[i] * moved[i];
      }
      const std::array<double, 3> own = pressed(edge, p.N, tip.node);
      for (std::size_t i = 0; i < edge.count; ++i) {
        if (edge.node[i] != tip.node) {
          add(edge, i, p, p.w * p.ds * here * own[i] / (area.at(edge.node[i]) * tip.thickness));
        }
      }
    }
  }
}

} // namespace

LipWeights lip_weights(const model::Mesh& mesh, const TipPlace& tip, const ExtensionField& field,
                       const std::vector<model::Face>& faces) {
  LipWeights weights;
  for_faces(mesh, tip, field, faces,
            [&](const FaceEdge& edge, std::size_t i, const FacePoint& p, double weight) {
              const auto [at, fresh] = weights.try_emplace(
                  edge.node[i], std::array<base::Vec2, 2>{base::Vec2::Zero(), base::Vec2::Zero()});
              const base::Vec2 inward(-p.along.y(), p.along.x());
              const base::Vec2 x = p.x + inside * (p.x - tip.frame.x).norm() * inward;
              for (int mode = 1; mode <= 2; ++mode) {
                at->second[static_cast<std::size_t>(mode - 1)] -=
                    weight * (auxiliary_gradient(tip.frame, x, mode, tip.material, tip.state) *
                              tip.frame.e1);
              }
            });
  return weights;
}

std::array<double, 3> lip_term(const model::Mesh& mesh, const TipPlace& tip,
                               const ExtensionField& field, const LipForces& lips,
                               const base::Vector& u) {
  const auto at = [](const base::Vector& nodal, base::NodeId n) -> base::Vec2 {
    return nodal.segment<2>(2 * static_cast<Eigen::Index>(n.index()));
  };
  std::array<double, 3> sum{};
  for (const auto& [node, weight] : lip_weights(mesh, tip, field, lips.faces)) {
    sum[1] += weight[0].dot(at(lips.force, node));
    sum[2] += weight[1].dot(at(lips.force, node));
  }
  for_faces(mesh, tip, field, lips.faces,
            [&](const FaceEdge& edge, std::size_t i, const FacePoint& p, double weight) {
              base::Vec2 along = base::Vec2::Zero(); // du/ds
              for (std::size_t k = 0; k < edge.count; ++k) {
                along += p.dN[k] / p.ds * at(u, edge.node[k]);
              }
              sum[0] -= weight * at(lips.force, edge.node[i]).dot(tip.frame.e1) *
                        along.dot(tip.frame.e1) * p.along.dot(tip.frame.e1);
            });
  return sum;
}

} // namespace spricka::crack
