// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_host.hpp"

#include "base/disjoint_sets.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

namespace spricka::mesh {

using base::ElementId;
using base::NodeId;
using base::Vec3;

void add_triangles(const model::Mesh& mesh, const model::Face& face,
                   std::vector<geometry::CornerPlaces>& triangles) {
  const FaceNodes nodes = face_nodes(mesh, face);
  std::vector<Vec3> rim; // round the face, middles too
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < nodes.corners; ++i) {
    rim.push_back(mesh.x[nodes.all[i].index()]);
    if (nodes.mid_node(i).valid()) {
      rim.push_back(mesh.x[nodes.mid_node(i).index()]);
    }
  }
  if (rim.size() == 3) {
    triangles.push_back({rim[0], rim[1], rim[2]});
    return;
  }
  if (rim.size() == 6) { // corners and, in the middle, the triangle of the middles
    triangles.push_back({rim[0], rim[1], rim[5]});
    triangles.push_back({rim[1], rim[2], rim[3]});
    triangles.push_back({rim[3], rim[4], rim[5]});
    triangles.push_back({rim[1], rim[3], rim[5]});
    return;
  }
  if (nodes.centre_node().valid()) {
    middle = mesh.x[nodes.centre_node().index()];
  } else if (rim.size() == 4) {
    middle = 0.25 * (rim[0] + rim[1] + rim[2] + rim[3]);
  } else { // serendipity: -1/4 of the corners, 1/2 of the middles
    for (std::size_t i = 0; i < rim.size(); ++i) {
      middle += (i % 2 == 0 ? -0.25 : 0.5) * rim[i];
    }
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    triangles.push_back({rim[i], rim[(i + 1) % rim.size()], middle});
  }
}

SolidHostMesh::SolidHostMesh(const model::Mesh& mesh, SetUsage use)
    : HostMesh(mesh), use_(std::move(use)) {
  find_parts();
  find_skins();
  find_extents();
}

void SolidHostMesh::find_parts() {
  base::DisjointSets parts(mesh().element_count());
  for (std::size_t e = 0; e < mesh().element_count(); ++e) {
    for (int s = 0; s < base::element_info(mesh().type[e]).sides; ++s) {
      const auto other = neighbour({ElementId(e), s});
      if (other && mesh().property[other->index()] == mesh().property[e] &&
          mesh().element_net[other->index()] == mesh().element_net[e]) {
        parts.join_sets(e, other->index());
      }
    }
  }
  base::DisjointSets::SetNumbers numbers = parts.set_numbers();
  part_ = std::move(numbers.of);
  members_.resize(numbers.count);
  for (std::size_t e = 0; e < part_.size(); ++e) {
    members_[part_[e]].emplace_back(e);
  }
}

void SolidHostMesh::find_skins() {
  surface_.resize(members_.size());
  for (std::size_t p = 0; p < members_.size(); ++p) {
    std::vector<geometry::CornerPlaces> triangles;
    std::vector<geometry::CornerPlaces> between;
    for (const model::Face& face :
         outline(members_[p], [&](ElementId e) { return part_index(e) == p; })) {
      add_triangles(mesh(), face, triangles);
      if (neighbour(face)) {
        add_triangles(mesh(), face, between);
      }
    }
    skin_.emplace_back(std::move(triangles));
    border_.emplace_back(std::move(between));
  }
}

const BodySurface& SolidHostMesh::body_surface(ElementId e) const {
  if (!surface_[part_index(e)]) {
    // All parts of the body.
    std::vector<bool> has(members_.size(), false);
    std::vector<std::size_t> parts{part_index(e)};
    has[part_index(e)] = true;
    std::vector<ElementId> elements;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (const ElementId member : members_[parts[k]]) {
        elements.push_back(member);
        for (int s = 0; s < base::element_info(mesh().type[member.index()]).sides; ++s) {
          const auto other = neighbour({member, s});
          if (other && !has[part_index(*other)]) {
            has[part_index(*other)] = true;
            parts.push_back(part_index(*other));
          }
        }
      }
    }
    std::sort(elements.begin(), elements.end());
    const auto made = std::make_shared<const BodySurface>(mesh(), elements, use_);
    for (const std::size_t p : parts) {
      surface_[p] = made;
    }
  }
  return *surface_[part_index(e)];
}

void SolidHostMesh::find_extents() {
  extent_.resize(mesh().element_count());
  for (std::size_t e = 0; e < mesh().element_count(); ++e) {
    const auto nodes = mesh().element_nodes(ElementId(e));
    ElementExtent& extent = extent_[e];
    extent.middle = model::element_corner_mean(mesh(), ElementId(e));
    for (const NodeId n : nodes) {
      extent.radius = std::max(extent.radius, (mesh().x[n.index()] - extent.middle).norm());
    }
    for (int m = 0; m < shape::edge_count(mesh().type[e]); ++m) {
      const auto [a, b] = shape::edge_corners(mesh().type[e], m);
      const Vec3 edge = mesh().x[nodes[static_cast<std::size_t>(b)].index()] -
                        mesh().x[nodes[static_cast<std::size_t>(a)].index()];
      extent.edge = std::max(extent.edge, edge.norm());
    }
  }
}

double distance_outside(const model::Mesh& mesh, ElementId e, const Vec3& x) {
  const base::ElementType type = mesh.type[e.index()];
  if (base::element_info(type).dim != 3) {
    return std::numeric_limits<double>::max();
  }
  const shape::ReferenceElement<3>& element = shape::reference_element<3>(type);
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, shape::most_nodes<3>> X(3, element.nodes);
  const auto nodes = mesh.element_nodes(e);
  for (int i = 0; i < element.nodes; ++i) {
    X.col(i) = mesh.x[nodes[static_cast<std::size_t>(i)].index()];
  }
  shape::Point<3> r = element.centre();
  for (int k = 0; k < 12; ++k) { // Newton's method; far outside it need not converge
    const Eigen::Matrix3d J = X.lazyProduct(element.dN(r));
    const Vec3 miss = x - X * element.N(r);
    const Vec3 step = J.inverse() * miss;
    if (!step.allFinite()) {
      break;
    }
    r += step.norm() > 1.0 ? Vec3(step.normalized()) : step;
    if (step.norm() < 1e-12) {
      break;
    }
  }
  return element.distance_outside(r);
}

std::optional<ElementId> SolidHostMesh::find_element_at(const Vec3& x, base::NetId net) const {
  constexpr double rim = 1e-9;
  std::optional<ElementId> best;
  double least = rim;
  for (std::size_t e = 0; e < mesh().element_count(); ++e) {
    if ((net.valid() && mesh().element_net[e] != net) ||
        (x - extent_[e].middle).norm() > (1.0 + rim) * extent_[e].radius) {
      continue;
    }
    if (const double outside = distance_outside(mesh(), ElementId(e), x); outside < least) {
      least = outside;
      best = ElementId(e);
    }
  }
  return best;
}

ElementId SolidHostMesh::nearest_element(std::span<const ElementId> elements, const Vec3& x) const {
  constexpr double beyond = 1.1; // of curved elements
  ElementId best = elements.front();
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < elements.size() && least > 0.0; ++i) {
    const ElementExtent& own = extent(elements[i]);
    if ((x - own.middle).norm() > beyond * own.radius) {
      continue;
    }
    const double outside = distance_outside(mesh(), elements[i], x);
    if (outside < least) {
      least = outside;
      best = elements[i];
    }
  }
  return best;
}

} // namespace spricka::mesh
