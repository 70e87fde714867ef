// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/host.hpp"

#include "mesh/boundary.hpp"
#include "mesh/plane.hpp"
#include "mesh/side_index.hpp"
#include "shape/shape.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <limits>

namespace spricka::mesh {

EdgeEndAndMidNodes element_edge_nodes(const model::Mesh& mesh, const model::Face& face) {
  const auto nodes = mesh.element_nodes(face.element);
  const auto local = shape::side_nodes(mesh.type[face.element.index()], face.side);
  return {nodes[static_cast<std::size_t>(local[0])], nodes[static_cast<std::size_t>(local[1])],
          local.size() == 3 ? nodes[static_cast<std::size_t>(local[2])] : base::NodeId()};
}

base::Vec3 point_on_edge(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge, double xi) {
  const base::Vec3& a = mesh.x[edge.a.index()];
  const base::Vec3& b = mesh.x[edge.b.index()];
  if (!edge.mid.valid()) {
    return 0.5 * (1.0 - xi) * a + 0.5 * (1.0 + xi) * b;
  }
  // (shape.2).
  const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
  return N[0] * a + N[1] * b + N[2] * mesh.x[edge.mid.index()];
}

base::Vec2 point_on_edge(const model::Mesh& mesh, const CrackFrame& frame,
                         const EdgeEndAndMidNodes& edge, double xi) {
  const base::Vec2 a = frame.rounded_local_coordinates(mesh.x[edge.a.index()]).head<2>();
  const base::Vec2 b = frame.rounded_local_coordinates(mesh.x[edge.b.index()]).head<2>();
  const base::Vec2 m = frame.rounded_local_coordinates(mesh.x[edge.mid.index()]).head<2>();
  const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
  return N[0] * a + N[1] * b + N[2] * m;
}

NearestEdgePoint nearest_point_on_edge(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge,
                                       const base::Vec3& p) {
  NearestEdgePoint best{0.0, std::numeric_limits<double>::max()};
  const auto meet = [&](double xi) {
    const double d = (point_on_edge(mesh, edge, xi) - p).norm();
    if (d < best.distance) {
      best = {xi, d};
    }
  };
  // Several starts: the distance to a parabola may have two minima.
  for (int i = 0; i <= 8; ++i) {
    meet(-1.0 + 0.25 * i);
  }
  for (int i = 0; i < 30; ++i) { // Gauss-Newton on the distance
    constexpr double h = 1e-5;   // the curve is a parabola: central differences are exact
    const double xi = best.xi;
    const base::Vec3 tangent =
        (point_on_edge(mesh, edge, xi + h) - point_on_edge(mesh, edge, xi - h)) / (2.0 * h);
    const double step = (p - point_on_edge(mesh, edge, xi)).dot(tangent) / tangent.squaredNorm();
    if (std::abs(step) < 1e-15) {
      break;
    }
    meet(std::clamp(xi + step, -1.0, 1.0));
  }
  return best;
}

bool is_edge_beyond_distance_of_point(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge,
                                      const base::Vec3& p, double distance) {
  const base::Vec3& a = mesh.x[edge.a.index()];
  // No point of the edge is taken to be farther from its first end than twice the chord.
  return (a - p).norm() - 2.0 * (mesh.x[edge.b.index()] - a).norm() > distance;
}

std::vector<base::Vec2> element_polygon_in_frame(const model::Mesh& mesh, base::ElementId e,
                                                 const CrackFrame& frame) {
  std::vector<base::Vec2> result;
  for (int s = 0; s < base::element_info(mesh.type[e.index()]).sides; ++s) {
    const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, {e, s});
    result.push_back(frame.rounded_local_coordinates(mesh.x[edge.a.index()]).head<2>());
    if (edge.mid.valid()) {
      result.push_back(frame.rounded_local_coordinates(mesh.x[edge.mid.index()]).head<2>());
    }
  }
  return result;
}

ElementOutlines::ElementOutlines(const model::Mesh& mesh, std::span<const base::ElementId> elements,
                                 const CrackFrame& frame) {
  std::vector<geometry::Box<2>> boxes;
  for (const base::ElementId e : elements) {
    outlines_.push_back(element_polygon_in_frame(mesh, e, frame));
    boxes.push_back(geometry::Box<2>::around(outlines_.back()));
  }
  boxes_ = geometry::BoxTree<2>(boxes);
}

std::size_t ElementOutlines::nearest_element_index(const base::Vec2& p) const {
  return boxes_.nearest(p,
                        [&](std::size_t i) {
                          return distance(outlines_[i], {p, p});
                        })
      .value_or(0);
}

bool is_face_element_in_net(const model::Mesh& mesh, const model::Face& face, base::NetId net) {
  return !net.valid() || mesh.element_net[face.element.index()] == net;
}

HostMesh::HostMesh(const model::Mesh& mesh) : mesh_(mesh), elements_(mesh) {
  beyond_.assign(most_sides * mesh.element_count(), -1);
  SideIndex(mesh).for_same_sides([&](std::span<const model::Face> same) {
    for (const model::Face& face : same) {
      const auto other = std::ranges::find_if(
          same, [&](const model::Face& side) { return side.element != face.element; });
      if (other != same.end()) {
        beyond_[place(face)] = static_cast<std::int32_t>(other->element.index());
      }
    }
  });
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const model::Face face{base::ElementId(e), s};
      const std::optional<base::ElementId> other = neighbour(face);
      if (!other) {
        boundary_.push_back(face);
      } else if (mesh.property[other->index()] != mesh.property[e]) {
        borders_.push_back(face);
      }
    }
  }
}

std::vector<model::Face>
HostMesh::sides_facing_outside(std::span<const base::ElementId> elements,
                               const std::function<bool(base::ElementId)>& inside) const {
  std::vector<model::Face> result;
  for (const base::ElementId e : elements) {
    for (int s = 0; s < base::element_info(mesh_.type[e.index()]).sides; ++s) {
      const auto other = neighbour({e, s});
      if (!other || !inside(*other)) {
        result.push_back({e, s});
      }
    }
  }
  return result;
}

} // namespace spricka::mesh
