// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_host.hpp"

#include "base/disjoint_sets.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace spricka::mesh {

using base::ElementId;
using base::NodeId;
using base::Vec3;

BodySurface::BodySurface(const model::Mesh& mesh, const std::vector<ElementId>& elements,
                         const SetUsage& use)
    : elements_(elements), number_(mesh.element_count(), -1) {
  body_.dim = 3;
  body_.x = mesh.x;
  body_.node_label = mesh.node_label;
  body_.node_net = mesh.node_net;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const ElementId e = elements_[i];
    number_[e.index()] = static_cast<std::int32_t>(i);
    model::add_element(body_, mesh.type[e.index()], mesh.element_nodes(e),
                       mesh.element_label[e.index()], mesh.element_net[e.index()]);
  }
  add_face_sets(mesh, use);
  add_node_sets(mesh, use);
  for (std::size_t s = 0; s < body_.face_sets.size(); ++s) {
    kept_.emplace_back(s);
  }
  for (const base::NodeSetId set : use.held) {
    lines_.emplace_back(body_.node_sets.size());
    body_.node_sets.push_back(mesh.set_with_id(set));
  }
  static_cast<void>(geometry());
}

void BodySurface::add_face_sets(const model::Mesh& mesh, const SetUsage& use) {
  for (std::size_t s = 0; s < mesh.face_sets.size(); ++s) {
    const model::FaceSet& set = mesh.face_sets[s];
    model::FaceSet own{set.name, {}, set.span};
    for (const model::Face& face : set.faces) {
      if (number_[face.element.index()] >= 0) {
        own.faces.push_back(
            {ElementId(static_cast<std::size_t>(number_[face.element.index()])), face.side});
      }
    }
    std::ranges::sort(own.faces);
    body_.face_sets.push_back(std::move(own));
    used_.push_back(SetUsage::is_used(use.faces, s));
  }
}

/// A face set has a node set of the same faces: only what is new makes borders.
void BodySurface::add_node_sets(const model::Mesh& mesh, const SetUsage& use) {
  std::map<std::vector<model::Face>, std::size_t> known;
  for (std::size_t s = 0; s < body_.face_sets.size(); ++s) {
    const std::size_t first = known.try_emplace(body_.face_sets[s].faces, s).first->second;
    used_[first] = used_[first] || used_[s];
  }
  const std::vector<model::Face> boundary = boundary_faces(body_);
  for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) {
    const model::NodeSet& set = mesh.node_sets[s];
    const std::vector<bool> member = model::mark_members(mesh.node_count(), set.nodes);
    model::FaceSet own{set.name, {}, set.span};
    std::ranges::copy_if(boundary, std::back_inserter(own.faces), [&](const model::Face& face) {
      return face_has_all_nodes_inside(body_, face, member);
    });
    std::ranges::sort(own.faces);
    const bool used = SetUsage::is_used(use.nodes, s);
    const auto [at, fresh] = known.try_emplace(own.faces, body_.face_sets.size());
    if (fresh) {
      body_.face_sets.push_back(std::move(own));
      used_.push_back(used);
    } else {
      used_[at->second] = used_[at->second] || used;
    }
  }
}

const SurfaceGeometry& BodySurface::geometry(SetBorderPreservation borders) const {
  std::optional<SurfaceGeometry>& made = geometry_[static_cast<std::size_t>(borders)];
  if (!made) {
    std::vector<base::FaceSetId> kept = kept_;
    if (borders == SetBorderPreservation::used) {
      std::erase_if(kept, [&](base::FaceSetId set) { return !used_[set.index()]; });
    }
    made.emplace(body_, kept, borders != SetBorderPreservation::none, lines_);
  }
  return *made;
}

std::size_t BodySurface::face_index(const model::Face& face) const {
  const std::int32_t e = number_[face.element.index()];
  return e < 0 ? nowhere
               : geometry().face_index({ElementId(static_cast<std::size_t>(e)), face.side});
}

model::Face BodySurface::face(std::size_t index) const {
  const geometry::ElementSide& own = geometry().face(index);
  return {elements_[own.element.index()], own.side};
}

void add_face_triangles(const model::Mesh& mesh, const model::Face& face,
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
    for (const model::Face& face : sides_facing_outside(
             members_[p], [&](ElementId e) { return property_part_index(e) == p; })) {
      add_face_triangles(mesh(), face, triangles);
      if (neighbour(face)) {
        add_face_triangles(mesh(), face, between);
      }
    }
    skin_.emplace_back(std::move(triangles));
    border_.emplace_back(std::move(between));
  }
}

const BodySurface& SolidHostMesh::body_surface(ElementId e) const {
  if (!surface_[property_part_index(e)]) {
    // All parts of the body.
    std::vector<bool> has(members_.size(), false);
    std::vector<std::size_t> parts{property_part_index(e)};
    has[property_part_index(e)] = true;
    std::vector<ElementId> elements;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (const ElementId member : members_[parts[k]]) {
        elements.push_back(member);
        for (int s = 0; s < base::element_info(mesh().type[member.index()]).sides; ++s) {
          const auto other = neighbour({member, s});
          if (other && !has[property_part_index(*other)]) {
            has[property_part_index(*other)] = true;
            parts.push_back(property_part_index(*other));
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
  return *surface_[property_part_index(e)];
}

void SolidHostMesh::find_extents() {
  extent_.resize(mesh().element_count());
  for (std::size_t e = 0; e < mesh().element_count(); ++e) {
    const auto nodes = mesh().element_nodes(ElementId(e));
    ElementBoundingBall& extent = extent_[e];
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
    const ElementBoundingBall& own = bounding_ball(elements[i]);
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
