// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/host.hpp"

#include "shape/shape.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace spricka::mesh {

ElementEdge element_edge(const model::Mesh& mesh, const model::Face& face) {
  const auto nodes = mesh.element_nodes(face.element);
  const auto local = shape::side_nodes(mesh.type[face.element.index()], face.side);
  return {nodes[static_cast<std::size_t>(local[0])], nodes[static_cast<std::size_t>(local[1])],
          local.size() == 3 ? nodes[static_cast<std::size_t>(local[2])] : base::NodeId()};
}

base::Vec3 point_on(const model::Mesh& mesh, const ElementEdge& edge, double xi) {
  const base::Vec3& a = mesh.x[edge.a.index()];
  const base::Vec3& b = mesh.x[edge.b.index()];
  if (!edge.mid.valid()) {
    return 0.5 * (1.0 - xi) * a + 0.5 * (1.0 + xi) * b;
  }
  // (shape.2).
  const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
  return N[0] * a + N[1] * b + N[2] * mesh.x[edge.mid.index()];
}

base::Vec2 point_on(const model::Mesh& mesh, const PlanarCrackFrame& frame, const ElementEdge& edge,
                    double xi) {
  const base::Vec2 a = frame.rounded_local(mesh.x[edge.a.index()]);
  const base::Vec2 b = frame.rounded_local(mesh.x[edge.b.index()]);
  const base::Vec2 m = frame.rounded_local(mesh.x[edge.mid.index()]);
  const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
  return N[0] * a + N[1] * b + N[2] * m;
}

NearestEdgePoint nearest_on(const model::Mesh& mesh, const ElementEdge& edge, const base::Vec3& p) {
  NearestEdgePoint best{0.0, std::numeric_limits<double>::max()};
  const auto meet = [&](double xi) {
    const double d = (point_on(mesh, edge, xi) - p).norm();
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
        (point_on(mesh, edge, xi + h) - point_on(mesh, edge, xi - h)) / (2.0 * h);
    const double step = (p - point_on(mesh, edge, xi)).dot(tangent) / tangent.squaredNorm();
    if (std::abs(step) < 1e-15) {
      break;
    }
    meet(std::clamp(xi + step, -1.0, 1.0));
  }
  return best;
}

bool is_beyond(const model::Mesh& mesh, const ElementEdge& edge, const base::Vec3& p,
               double distance) {
  const base::Vec3& a = mesh.x[edge.a.index()];
  // No point of the edge is taken to be farther from its first end than twice the chord.
  return (a - p).norm() - 2.0 * (mesh.x[edge.b.index()] - a).norm() > distance;
}

std::vector<base::Vec2> polygon(const model::Mesh& mesh, base::ElementId e,
                                const PlanarCrackFrame& frame) {
  std::vector<base::Vec2> result;
  for (int s = 0; s < base::element_info(mesh.type[e.index()]).sides; ++s) {
    const ElementEdge edge = element_edge(mesh, {e, s});
    result.push_back(frame.rounded_local(mesh.x[edge.a.index()]));
    if (edge.mid.valid()) {
      result.push_back(frame.rounded_local(mesh.x[edge.mid.index()]));
    }
  }
  return result;
}

bool in_net(const model::Mesh& mesh, const model::Face& face, base::NetId net) {
  return !net.valid() || mesh.element_net[face.element.index()] == net;
}

HostMesh::HostMesh(const model::Mesh& mesh) : mesh_(mesh), elements_(mesh) {
  assert(mesh.dim == 2);
  beyond_.assign(most_sides * mesh.element_count(), -1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const model::Face face{base::ElementId(e), s};
      if (beyond_[place(face)] < 0) {
        meet(face);
      }
      const std::int32_t across = beyond_[place(face)];
      if (across < 0) {
        boundary_.push_back(face);
      } else if (mesh.property[static_cast<std::size_t>(across)] != mesh.property[e]) {
        borders_.push_back(face);
      }
    }
  }
}

// Sides of plane elements join one corner to the next: those of neighbours run against each other,
// and what one finds the other need not look for.
void HostMesh::meet(const model::Face& face) {
  const auto next_corner = [&](base::ElementId e, std::size_t i) {
    const std::size_t next = i + 1;
    return next == std::size_t(base::element_info(mesh_.type[e.index()]).corners) ? 0 : next;
  };
  const auto own = mesh_.element_nodes(face.element);
  const auto s = static_cast<std::size_t>(face.side);
  const base::NodeId a = own[s];
  const base::NodeId b = own[next_corner(face.element, s)];
  for (const base::ElementId other : elements_around(a)) {
    if (other == face.element) {
      continue;
    }
    const auto nodes = mesh_.element_nodes(other);
    const auto sides =
        static_cast<std::size_t>(base::element_info(mesh_.type[other.index()]).sides);
    for (std::size_t k = 0; k < sides; ++k) {
      if (nodes[k] == b && nodes[next_corner(other, k)] == a) {
        beyond_[place(face)] = static_cast<std::int32_t>(other.index());
        std::int32_t& back = beyond_[place({other, static_cast<int>(k)})];
        back = back < 0 ? static_cast<std::int32_t>(face.element.index()) : back;
        return;
      }
    }
  }
}

} // namespace spricka::mesh
