// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_shell.hpp"

#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::Matrix;
using base::NodeId;
using base::Vec2;
using base::Vec3;

constexpr std::size_t quadrilateral_middle =
    8; ///< the node there, whether of the quadrilateral or not

/// Nodes of a quadrilateral along its mean plane, over its size, from its middle.
std::vector<Vec2> flatten(std::span<const Vec3> nodes) {
  const Vec3 first = nodes[2] - nodes[0];
  const Vec3 second = nodes[3] - nodes[1];
  const Vec3 centre = 0.25 * (nodes[0] + nodes[1] + nodes[2] + nodes[3]);
  const Vec3 along = first.normalized();
  const Vec3 across = first.cross(second).cross(first).normalized();
  std::vector<Vec2> flat;
  for (const Vec3& x : nodes) {
    flat.emplace_back((x - centre).dot(along) / first.norm(),
                      (x - centre).dot(across) / first.norm());
  }
  return flat;
}

/// Adds the integrals of 1, x and y times the shape functions of a face [3, its nodes].
void add_moments(base::ElementType type, std::span<const std::size_t> nodes,
                 const std::vector<Vec2>& x, double factor, Matrix& moments) {
  constexpr int degree = 7; // of shape functions, place and determinant on curved sides
  const shape::ReferenceElement<2>& face = shape::reference_element<2>(type);
  for (const auto& point : shape::quadrature<2>(face.domain, degree)) {
    const auto N = face.N(point.r);
    const auto dN = face.dN(point.r);
    Vec3 linear(1.0, 0.0, 0.0);
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      linear.tail<2>() += N[k] * x[nodes[i]];
      J += x[nodes[i]] * dN.row(k);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      moments.col(static_cast<Eigen::Index>(nodes[i])) +=
          factor * point.weight * J.determinant() * N[static_cast<Eigen::Index>(i)] * linear;
    }
  }
}

/// Four quadratic triangles with a corner in the middle of a quadrilateral of eight or nine nodes
/// take its place on the other side of a join. Their nodes that it has not follow its own: the
/// middle (where it has no node there), then, for each corner, the place half way from there to the
/// middle. Returns the weights [such nodes, nodes of the quadrilateral] for which the displacements
/// of both sides have the same integral times 1, x and y over the quadrilateral as seen along its
/// normal: tractions that are linear then do the same work on both, so that hexahedra and
/// tetrahedra pass the patch test of a linear stress. Of all such weights those that differ least
/// from the shape functions; of displacements that are quadratic these are exact, and stay so.
/// `nodes`: corners in order, middles of the edges after them, and the middle (any unit of length).
Matrix quadrilateral_tie_weights(std::span<const Vec3> nodes) {
  assert(nodes.size() == quadrilateral_middle || nodes.size() == quadrilateral_middle + 1);
  const base::ElementType type =
      nodes.size() == quadrilateral_middle ? base::ElementType::quamc8 : base::ElementType::quamc9;
  const shape::ReferenceElement<2>& face = shape::reference_element<2>(type);
  const auto own = static_cast<Eigen::Index>(nodes.size());
  const Eigen::Index others = 13 - own;
  Matrix weights(others, own);
  if (nodes.size() == quadrilateral_middle) {
    weights.row(0) = face.N(face.centre()).transpose();
  }
  for (int corner = 0; corner < 4; ++corner) {
    weights.row(others - 4 + corner) =
        face.N(0.5 * face.node_local_coordinates(corner)).transpose();
  }
  std::vector<Vec2> x = flatten(nodes);
  for (Eigen::Index s = 0; s < others; ++s) {
    Vec2 place = Vec2::Zero();
    for (Eigen::Index i = 0; i < own; ++i) {
      place += weights(s, i) * x[static_cast<std::size_t>(i)];
    }
    x.push_back(place);
  }
  // What the quadrilateral has more than the triangles.
  Matrix moments = Matrix::Zero(3, own + others);
  std::vector<std::size_t> all(nodes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  add_moments(type, all, x, 1.0, moments);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const std::array<std::size_t, 6> triangle{i,
                                              next,
                                              quadrilateral_middle,
                                              4 + i,
                                              quadrilateral_middle + 1 + next,
                                              quadrilateral_middle + 1 + i};
    add_moments(base::ElementType::trimc6, triangle, x, -1.0, moments);
  }
  const auto of_others = moments.rightCols(others);
  const Matrix missing = moments.leftCols(own) + of_others * weights;
  const Eigen::Matrix3d product = of_others * of_others.transpose();
  weights -= of_others.transpose() * product.ldlt().solve(missing);
  return weights;
}

using Corners = std::array<int, 4>;

/// Whether of a quadrilateral, anticlockwise seen from the fill, the diagonal from corner 0 to 2
/// bulges towards the fill (or the four lie in a plane), not that from 1 to 3.
bool first_bulges(const PatchMeshBuilder& net, const Corners& q) {
  return net.six_times_volume(q[0], q[1], q[2], q[3]) <= 0.0;
}

std::array<PatchTriangle, 2> halves(const Corners& q, bool first) {
  if (first) {
    return {{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}};
  }
  return {{{q[1], q[2], q[3]}, {q[1], q[3], q[0]}}};
}

/// The value in the middle of a serendipity face, of its corners and middles (contact with a
/// diagonal: two triangles of six nodes and one of eight then have the same mean).
PatchTie middle_of(const Corners& corner, const std::array<int, 4>& mid) {
  PatchTie tie;
  for (const int n : corner) {
    tie.master.push_back(n);
    tie.weight.push_back(-0.25);
  }
  for (const int n : mid) {
    tie.master.push_back(n);
    tie.weight.push_back(0.5);
  }
  return tie;
}

/// Makes the slave of a tie in its place; the tie stays if it is to hold.
int slave_of(PatchMeshBuilder& net, PatchTie tie, bool holds) {
  Vec3 x = Vec3::Zero();
  for (std::size_t i = 0; i < tie.master.size(); ++i) {
    x += tie.weight[i] * net.position(tie.master[i]);
  }
  tie.slave = net.add_node_at_position(x);
  const int node = tie.slave;
  if (holds) {
    net.ties.push_back(std::move(tie));
  }
  return node;
}

/// Makes the nodes inside a quadrilateral (corners, middles, and the middle where it has one) that
/// four triangles round it share with it, tied so that linear stresses pass. Returns its middle.
int tie_inside(PatchMeshBuilder& net, const std::vector<int>& nodes) {
  std::vector<Vec3> places;
  std::ranges::transform(nodes, std::back_inserter(places), [&](int n) { return net.position(n); });
  const base::Matrix weights = quadrilateral_tie_weights(places);
  Eigen::Index row = 0;
  const auto next = [&] {
    const base::Vector w = weights.row(row++).transpose();
    return slave_of(net, {0, nodes, {w.begin(), w.end()}}, true);
  };
  const int middle = nodes.size() > 8 ? nodes[8] : next();
  for (std::size_t corner = 0; corner < 4; ++corner) {
    net.set_mid_node(nodes[corner], middle, next());
  }
  return middle;
}

std::vector<PatchTriangle> fan(const Corners& q, int middle) {
  return {{q[0], q[1], middle}, {q[1], q[2], middle}, {q[2], q[3], middle}, {q[3], q[0], middle}};
}

class Sheller {
public:
  Sheller(const SolidHostMesh& host, const std::vector<bool>& removed, PatchMeshBuilder& net)
      : host_(host), mesh_(host.mesh()), removed_(removed), net_(net) {}

  std::vector<PatchTriangle> triangles_of(const CavityFace& face) {
    const FaceNodes nodes = face_nodes(mesh_, face.face);
    std::vector<int> corner;
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      corner.push_back(net_.find_or_add_host_node(nodes.all[i]));
    }
    std::vector<int> mid;
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      mid.push_back(middle(nodes, i));
    }
    if (nodes.corners == 3) { // seen from inside the other way round
      return {{corner[0], corner[2], corner[1]}};
    }
    const Corners q{corner[0], corner[3], corner[2], corner[1]};
    if (!face.free && nodes.mid_node(0).valid()) { // a quadratic element stays behind it
      std::vector<int> all = corner;
      all.insert(all.end(), mid.begin(), mid.end());
      if (nodes.centre_node().valid()) {
        all.push_back(net_.find_or_add_host_node(nodes.centre_node()));
      }
      return fan(q, tie_inside(net_, all));
    }
    const bool first = first_bulges(net_, q);
    const int a = first ? q[0] : q[1];
    const int b = first ? q[2] : q[3];
    net_.set_mid_node(a, b, centre(nodes, face.free, q, mid));
    const auto two = halves(q, first);
    return {two[0], two[1]};
  }

private:
  /// The node in the middle of the edge from corner i to the next.
  int middle(const FaceNodes& nodes, std::size_t i) {
    const auto [a, b] = nodes.edge(i);
    const int na = net_.find_or_add_host_node(a);
    const int nb = net_.find_or_add_host_node(b);
    if (const auto known = net_.find_mid_node(na, nb)) {
      return *known;
    }
    const int node = nodes.mid_node(i).valid()
                         ? net_.find_or_add_host_node(nodes.mid_node(i))
                         : slave_of(net_, {0, {na, nb}, {0.5, 0.5}}, stays(a, b));
    net_.set_mid_node(na, nb, node);
    return node;
  }

  int centre(const FaceNodes& nodes, bool free, const Corners& corner,
             const std::vector<int>& mid) {
    if (nodes.centre_node().valid()) {
      return net_.find_or_add_host_node(nodes.centre_node());
    }
    if (nodes.mid_node(0).valid()) {
      return slave_of(net_, middle_of(corner, {mid[0], mid[1], mid[2], mid[3]}), false);
    }
    return slave_of(net_, {0, {corner.begin(), corner.end()}, {0.25, 0.25, 0.25, 0.25}}, !free);
  }

  /// Whether an element that stays has both nodes.
  [[nodiscard]] bool stays(NodeId a, NodeId b) const {
    return std::ranges::any_of(host_.elements_around(a), [&](ElementId e) {
      const auto nodes = mesh_.element_nodes(e);
      return !removed_[e.index()] && std::find(nodes.begin(), nodes.end(), b) != nodes.end();
    });
  }

  const SolidHostMesh& host_;
  const model::Mesh& mesh_;
  const std::vector<bool>& removed_;
  PatchMeshBuilder& net_;
};

} // namespace

std::vector<PatchTriangle> triangulate_cavity_shell(const SolidHostMesh& host,
                                                    const std::vector<bool>& removed,
                                                    const std::vector<CavityFace>& faces,
                                                    PatchMeshBuilder& net,
                                                    std::vector<HostFaceReplacement>& pieces) {
  Sheller sheller(host, removed, net);
  std::vector<PatchTriangle> shell;
  for (const CavityFace& face : faces) {
    const std::vector<PatchTriangle> triangles = sheller.triangles_of(face);
    shell.insert(shell.end(), triangles.begin(), triangles.end());
    HostFaceReplacement& own = pieces.emplace_back(face.face, std::vector<std::vector<int>>());
    for (const PatchTriangle& t : triangles) {
      own.second.emplace_back(t.begin(), t.end());
    }
  }
  return shell;
}

std::vector<int> add_tube_to_patch(const Tube& tube, PatchMeshBuilder& net,
                                   std::vector<PatchTriangle>& shell) {
  std::vector<int> node;
  for (const Vec3& place : tube.x) {
    node.push_back(net.add_node_at_local_position(place));
  }
  const auto at = [&](int n) { return node[static_cast<std::size_t>(n)]; };
  for (const Tube::TubeElement& element : tube.elements) {
    PatchElement& e = net.elements.emplace_back(PatchElement{element.type, {}});
    std::ranges::transform(element.nodes, std::back_inserter(e.nodes), at);
  }
  for (std::size_t i = 0; i < tube.front_mid.size(); ++i) {
    net.set_mid_node(at(tube.front[i]), at(tube.front[(i + 1) % tube.front.size()]),
                     at(tube.front_mid[i]));
  }
  // The fill meets the upper of the two lines of the crack until it is split.
  std::vector<int> single = node;
  for (const auto& [upper, lower] : tube.twins) {
    single[static_cast<std::size_t>(lower)] = at(upper);
  }
  for (const TubeQuad& quad : tube.outer) {
    Corners own{};
    Corners fill{};
    std::array<int, 4> mid{};
    for (std::size_t i = 0; i < 4; ++i) {
      own[i] = at(quad.corner[i]);
      fill[i] = single[static_cast<std::size_t>(quad.corner[i])];
      mid[i] = at(quad.mid[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      net.set_mid_node(own[i], own[(i + 1) % 4], mid[i]);
    }
    const bool first = first_bulges(net, own);
    const int diagonal = slave_of(net, middle_of(own, mid), true);
    net.set_mid_node(first ? own[0] : own[1], first ? own[2] : own[3], diagonal);
    const auto two = halves(fill, first);
    shell.insert(shell.end(), two.begin(), two.end());
  }
  return node;
}

} // namespace spricka::mesh
