// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/ahead.hpp"

#include "geometry/polyline.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/plane.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::growth {

using base::Vec2;

namespace {

/// Straight pieces of a curved edge.
constexpr int pieces_of_edge = 4;
/// Slack for round-off, as a part of the piece that is met.
constexpr double slack = 1e-6;
/// A crack beside the way counts where it comes nearer than it is far ahead.
constexpr double beside = 0.5;

Vec2 plane(const base::Vec3& x) {
  return x.head<2>();
}

/// How far along a ray a piece is met; pieces along the ray are not met.
std::optional<double> meets(const Vec2& from, const Vec2& way, const Vec2& a, const Vec2& b) {
  const Vec2 chord = b - a;
  const double turn = mesh::cross(way, chord);
  if (std::abs(turn) <= 1e-9 * chord.norm()) {
    return std::nullopt;
  }
  const double along = mesh::cross(a - from, chord) / turn;
  const double on = mesh::cross(a - from, way) / turn;
  if (along < 0.0 || on < -slack || on > 1.0 + slack) {
    return std::nullopt;
  }
  return along;
}

} // namespace

PlaneBoundaryAhead::PlaneBoundaryAhead(const model::Mesh& host) : host_(host) {
  for (const model::Face& face : mesh::boundary_faces(host)) {
    if (!shape::is_plane_element_side(host.type[face.element.index()], face.side)) {
      continue; // no tip of a line runs into a face
    }
    const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(host, face);
    const base::NetId net = host.element_net[face.element.index()];
    const int parts = edge.mid.valid() ? pieces_of_edge : 1;
    for (int k = 0; k < parts; ++k) {
      const auto at = [&](int i) {
        return plane(mesh::point_on_edge(host, edge, -1.0 + 2.0 * i / parts));
      };
      pieces_.push_back({at(k), at(k + 1), net, face});
    }
  }
}

std::string PlaneBoundaryAhead::name_of(const HostBoundaryEdge& piece, const Vec2& at) const {
  for (const model::FaceSet& set : host_.face_sets) {
    if (!set.name.empty() && std::ranges::find(set.faces, piece.face) != set.faces.end()) {
      return "edge set " + set.name;
    }
  }
  for (const model::NodeSet& set : host_.node_sets) {
    const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(host_, piece.face);
    const auto holds = [&](base::NodeId n) {
      return !n.valid() || std::ranges::find(set.nodes, n) != set.nodes.end();
    };
    const bool all = holds(edge.a) && holds(edge.b) && holds(edge.mid);
    if (!set.name.empty() && all) {
      return "edge " + set.name;
    }
  }
  return fmt::format("the edge at ({:.6g}, {:.6g})", at.x(), at.y());
}

std::optional<Obstacle> PlaneBoundaryAhead::edge_ahead(const mesh::CrackLine& line,
                                                       const TipGrowthDirection& tip) const {
  const Vec2 from = plane(tip.x);
  const Vec2 way = plane(tip.direction);
  const HostBoundaryEdge* nearest = nullptr;
  double least = std::numeric_limits<double>::max();
  for (const HostBoundaryEdge& piece : pieces_) {
    // Edges of other nets do not bound the body that the crack is in.
    if (line.net.valid() && piece.net != line.net) {
      continue;
    }
    const std::optional<double> distance = meets(from, way, piece.a, piece.b);
    // The edge that the tip stands on, as at a mouth, is met at no distance: not ahead.
    if (distance && (*distance < least) && (*distance > slack * (piece.b - piece.a).norm())) {
      least = *distance;
      nearest = &piece;
    }
  }
  if (nearest == nullptr) {
    return std::nullopt;
  }
  return Obstacle{least, name_of(*nearest, from + least * way)};
}

std::optional<Obstacle> PlaneBoundaryAhead::crack_ahead(std::span<const mesh::CrackLine> lines,
                                                        std::size_t own,
                                                        const TipGrowthDirection& tip) {
  const Vec2 from = plane(tip.x);
  const Vec2 way = plane(tip.direction);
  std::optional<Obstacle> found;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<base::Vec3>& points = lines[i].points;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec2 a = plane(points[k - 1]);
      const Vec2 b = plane(points[k]);
      // The pieces that end at this tip are no obstacle; earlier parts of the same crack are.
      const bool at_tip = i == own && ((a - from).norm() <= slack * (b - a).norm() ||
                                       (b - from).norm() <= slack * (b - a).norm());
      if (at_tip) {
        continue;
      }
      double distance = std::numeric_limits<double>::max();
      if (const auto hit = meets(from, way, a, b)) {
        distance = *hit;
      }
      if (i != own) {
        // ends that come towards one another count where they are nearly in line
        for (const Vec2& end : {a, b}) {
          const Vec2 off = end - from;
          if (off.dot(way) > 0.0 && std::abs(mesh::cross(way, off)) < beside * off.dot(way)) {
            distance = std::min(distance, off.norm());
          }
        }
        // What is passed at the side: its distance counts double.
        distance = std::min(distance, geometry::distance_to_segment(from, a, b) / beside);
      }
      if (distance < least) {
        least = distance;
        found = Obstacle{least, lines[i].display_name()};
      }
    }
  }
  return found;
}

} // namespace spricka::growth
