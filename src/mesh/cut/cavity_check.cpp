// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/cavity_check.hpp"

#include "mesh/plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;

/// The first part of a crack, where it may be near the boundary that it starts from.
constexpr double at_mouth = 0.05;
/// Least distance of a crack beyond that from the boundary, in crack lengths, and in radii of its
/// rosette.
constexpr double beside_boundary = 0.002;
constexpr double beside_tip = 0.4;
/// Edges of a material boundary, which a patch cannot divide, over their distance from the crack.
constexpr double longest_border = 2.0;

/// The crack without its first part.
std::vector<Vec2> without_mouth(const std::vector<Vec2>& line) {
  std::vector<Vec2> result = line;
  const double first = (line[1] - line[0]).norm();
  // A first segment shorter than that keeps its second half.
  result[0] = line[0] + std::min(0.5, at_mouth / first) * (line[1] - line[0]);
  return result;
}

/// An edge as a polyline whose points lie the denser the nearer to the mouth, if that is on it.
std::vector<Vec2> fine_curve(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge,
                             const CrackPlacement& placement) {
  std::vector<double> xi{-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0};
  const NearestEdgePoint mouth = nearest_point_on_edge(mesh, edge, placement.frame.origin);
  if (mouth.distance < coordinate_tolerance * placement.frame.a) {
    xi.push_back(mouth.xi);
    // The edge may be many times longer than the crack: steps that halve towards the mouth leave
    // some points within a small part of the crack from it.
    for (int k = 0; k < 20; ++k) {
      xi.push_back(std::min(mouth.xi + std::ldexp(1.0, -k), 1.0));
      xi.push_back(std::max(mouth.xi - std::ldexp(1.0, -k), -1.0));
    }
    std::sort(xi.begin(), xi.end());
  }
  std::vector<Vec2> result;
  result.reserve(xi.size());
  for (const double t : xi) {
    result.push_back(
        placement.frame.exact_local_coordinates(point_on_edge(mesh, edge, t)).head<2>());
  }
  return result;
}

/// Whether the crack starts into the body: between the boundary ahead of the mouth and, turning
/// anticlockwise, the boundary before it.
bool starts_inside(const HostMesh& host, const CrackPlacement& placement, const Cavity& cavity) {
  const Vec2 along = (placement.line[1] - placement.line[0]).normalized();
  const auto angle = [&](const Vec2& p) { // from the crack, in (-pi, pi]
    return std::atan2(cross(along, p), along.dot(p));
  };
  for (const std::vector<CavityOutlineEdge>& loop : cavity.loops) {
    std::vector<Vec2> points;
    for (const CavityOutlineEdge& edge : loop) {
      const std::vector<Vec2> curve = fine_curve(host.mesh(), edge.edge, placement);
      points.insert(points.end(), curve.begin(), curve.end() - 1);
    }
    const auto mouth = std::find_if(points.begin(), points.end(),
                                    [](const Vec2& p) { return p.norm() < coordinate_tolerance; });
    if (mouth != points.end()) {
      // The loop has the cavity on its left: from the mouth on it runs along the boundary ahead,
      // and comes back along the one before.
      std::rotate(points.begin(), mouth, points.end());
      const auto away = [](const Vec2& p) { return p.norm() >= 0.5 * at_mouth; };
      const auto ahead = std::find_if(points.begin(), points.end(), away);
      const auto before = std::find_if(points.rbegin(), points.rend(), away);
      // A body that is all near the mouth is smaller than the crack.
      return ahead != points.end() && angle(*ahead) < 0.0 && angle(*before) > 0.0;
    }
  }
  return false;
}

/// Where a crack leaves its body or comes too near to its boundary, if it does.
std::optional<Vec2> way_out(const HostMesh& host, const CrackPlacement& placement,
                            const Cavity& cavity) {
  if (placement.mouth && !starts_inside(host, placement, cavity)) {
    return placement.line[0];
  }
  // A tip may be as near to the boundary as its rosette allows: the limit shrinks with a small one.
  const double room = std::min(beside_boundary, beside_tip * placement.radius);
  const std::vector<Vec2> line = placement.mouth ? without_mouth(placement.line) : placement.line;
  for (const std::vector<CavityOutlineEdge>& loop : cavity.loops) {
    for (const CavityOutlineEdge& edge : loop) {
      const std::vector<Vec2> curve = fine_curve(host.mesh(), edge.edge, placement);
      for (std::size_t i = 0; edge.free && i + 1 < curve.size(); ++i) {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
          const ClosestApproach meeting =
              closest_approach(line[k], line[k + 1], curve[i], curve[i + 1]);
          if (meeting.distance < room) {
            return meeting.at;
          }
        }
      }
    }
  }
  return std::nullopt;
}

/// The first element of another property that the crack or its rosette touches.
std::optional<ElementId> foreign_element(const HostMesh& host, const CrackPlacement& placement,
                                         const Cavity& cavity) {
  const model::Mesh& mesh = host.mesh();
  // The cavity ends at borders of properties: an element beyond that the crack could meet touches
  // it.
  std::set<ElementId> others;
  for (const ElementId e : cavity.elements) {
    for (const NodeId n : mesh.element_nodes(e)) {
      for (const ElementId next : host.elements_around(n)) {
        if (mesh.property[next.index()] != mesh.property[e.index()]) {
          others.insert(next);
        }
      }
    }
  }
  for (const ElementId e : others) {
    const std::vector<Vec2> shape = element_polygon_in_frame(mesh, e, placement.frame);
    const bool near_tip = std::ranges::any_of(placement.fronts, [&](const PlacedTip& tip) {
      return distance(shape, {tip.at, tip.at}) < 1.1 * placement.radius;
    });
    if (distance(shape, placement.line) < coordinate_tolerance || near_tip) {
      return e;
    }
  }
  return std::nullopt;
}

} // namespace

bool check_crack_inside_cavity(const HostMesh& host, const CrackPlacement& placement,
                               const Cavity& cavity, base::SourceSpan span,
                               base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = host.mesh();
  if (const auto e = foreign_element(host, placement, cavity)) {
    diagnostics.error(span, "E424",
                      fmt::format("with a = {:.6g} the crack or its rosette meets a material "
                                  "boundary at element {}",
                                  placement.frame.a, mesh.element_label[e->index()]),
                      "a patch has one property: end the crack before the boundary, or give a "
                      "smaller RADIUS on $TIPNET");
    return false;
  }
  for (const std::vector<CavityOutlineEdge>& loop : cavity.loops) {
    for (const CavityOutlineEdge& edge : loop) {
      if (!edge.free && is_edge_longer_than_clearance(mesh, placement, edge.edge, longest_border)) {
        const base::Vec3& at = mesh.x[edge.edge.a.index()];
        diagnostics.error(
            span, "E424",
            fmt::format("edges of a material boundary near ({:.6g}, {:.6g}) are too long for the "
                        "crack beside them",
                        at.x(), at.y()),
            "refine the net there: edges of twice the distance from the crack at most");
        return false;
      }
    }
  }
  // A half runs along the boundary by intent.
  if (placement.half == 0) {
    if (const auto out = way_out(host, placement, cavity)) {
      const base::Vec3 at = placement.frame.global(base::embed_in_space(*out));
      diagnostics.error(span, "E425",
                        fmt::format("with a = {:.6g} the crack leaves its body or runs along the "
                                    "boundary at ({:.6g}, {:.6g})",
                                    placement.frame.a, at.x(), at.y()),
                        placement.mouth
                            ? "from its first point on it runs inside: is that point on the right "
                              "boundary, is the direction that into the body, the length less than "
                              "there is body?"
                            : "a crack that does not start on the boundary lies inside from end to "
                              "end; give the point on the boundary first");
      return false;
    }
  }
  for (const ElementId e : cavity.elements) {
    if (!base::element_info(mesh.type[e.index()]).quadratic) {
      diagnostics.error(span, "E426",
                        fmt::format("a crack patch needs quadratic elements round it, element {} "
                                    "is a {}",
                                    mesh.element_label[e.index()],
                                    base::element_info(mesh.type[e.index()]).name),
                        "use TRIMC6 or QUAMC8, TYPE=QUADRATIC on $IMPORT, or PATCH=NO");
      return false;
    }
  }
  return true;
}

} // namespace spricka::mesh
