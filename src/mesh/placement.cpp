// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cavity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::mesh {
namespace {

using base::NodeId;
using base::Vec2;
using base::Vec3;

/// A start this near to the boundary, as a part of the edge there, is on it: arcs are approximated
/// by the host's curves.
constexpr double on_boundary = 1e-3;
/// A mouth this near to a node is at the node.
constexpr double at_node = 1e-6;

double length_of(const std::vector<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

bool in_net(const Host& host, const model::Face& face, base::NetId net) {
  return !net.valid() || host.mesh().element_net[face.element.index()] == net;
}

/// The mouth and how far the crack is moved to put it there; empty if it is too far away.
struct Found {
  Mouth mouth;
  Vec3 at = Vec3::Zero();
  double distance = std::numeric_limits<double>::max();
  double chord = 0.0;
};

Found find_mouth(const Host& host, const CrackLine& line) {
  const model::Mesh& mesh = host.mesh();
  const Vec3& start = line.points.front();
  Found found;
  for (const model::Face& face : host.boundary()) {
    if (!in_net(host, face, line.net)) {
      continue;
    }
    const Edge edge = edge_of(mesh, face);
    const double chord = (mesh.x[edge.b.index()] - mesh.x[edge.a.index()]).norm();
    if (is_beyond(mesh, edge, start, found.distance)) {
      continue;
    }
    const EdgePoint p = nearest_on(mesh, edge, start);
    if (p.distance < found.distance - 1e-9 * chord) {
      found = {{face, p.xi, {}}, point_on(mesh, edge, p.xi), p.distance, chord};
    }
  }
  if (found.distance <= on_boundary * found.chord) {
    const Edge edge = edge_of(mesh, found.mouth.face);
    for (const NodeId n : {edge.a, edge.b, edge.mid}) {
      if (n.valid() && (mesh.x[n.index()] - found.at).norm() <= at_node * found.chord) {
        found.mouth.node = n;
        found.at = mesh.x[n.index()];
      }
    }
  }
  return found;
}

bool on_axis(const Vec2& p) {
  return std::abs(p.y()) < same;
}

/// Which side of a crack along the boundary the body lies on.
int side_of_body(const Host& host, const CrackFrame& frame) {
  for (const model::Face& face : host.boundary()) {
    const Edge edge = edge_of(host.mesh(), face);
    const Vec2 a = frame.local(host.mesh().x[edge.a.index()]);
    const Vec2 b = frame.local(host.mesh().x[edge.b.index()]);
    if (on_axis(a) && on_axis(b) && std::max(a.x(), b.x()) > same &&
        std::min(a.x(), b.x()) < 1.0 - same) {
      return b.x() > a.x() ? 1 : -1;
    }
  }
  return 0;
}

} // namespace

double tip_clearance(const Host& host, const CrackFrame& frame, const std::vector<Vec2>& line,
                     bool half, base::NetId net) {
  const model::Mesh& mesh = host.mesh();
  const Vec3 tip = frame.global(line.back());
  const Vec2 along = (line.back() - line[line.size() - 2]).normalized();
  const auto on_line = [&](const Edge& edge) {
    return std::abs(cross(along, frame.exact(mesh.x[edge.a.index()]) - line.back())) < same &&
           std::abs(cross(along, frame.exact(mesh.x[edge.b.index()]) - line.back())) < same;
  };
  double least = std::numeric_limits<double>::max();
  for (const model::Face& face : host.boundary()) {
    const Edge edge = edge_of(mesh, face);
    if (in_net(host, face, net) && !is_beyond(mesh, edge, tip, least) && !(half && on_line(edge))) {
      least = std::min(least, nearest_on(mesh, edge, tip).distance);
    }
  }
  return least / frame.a;
}

// Room for the tip, as a part of the crack's length, below which it counts as on the boundary.
constexpr double through = 1e-9;

std::optional<Placement> place(const Host& host, const CrackLine& line, const TipMesh& tip,
                               base::Span span, base::Diagnostics& diagnostics) {
  Placement result;
  const Found found = find_mouth(host, line);
  if (!(found.distance <= on_boundary * found.chord)) {
    diagnostics.error(span, "E421",
                      fmt::format("{} starts at ({:.6g}, {:.6g}), which is not on the boundary; a "
                                  "crack inside the body is not available in this version",
                                  line.title(), line.points[0].x(), line.points[0].y()),
                      found.chord > 0.0
                          ? fmt::format("the nearest boundary point is ({:.6g}, {:.6g})",
                                        found.at.x(), found.at.y())
                          : "the net has no boundary there");
    return std::nullopt;
  }
  result.mouth = found.mouth;
  CrackFrame& frame = result.frame;
  frame.origin = found.at;
  frame.a = length_of(line.points);
  frame.e1 = (line.points[1] - line.points[0]).normalized();
  for (const Vec3& p : line.points) {
    result.line.push_back(frame.exact(p - line.points[0] + found.at));
  }
  result.line[0].setZero();
  if (result.line.size() == 2) {
    result.line[1] = {1.0, 0.0};
  }
  const Vec2 last = result.line.back() - result.line[result.line.size() - 2];
  result.direction = result.line.size() == 2 ? 0.0 : std::atan2(last.y(), last.x());
  result.radius = tip.radius / frame.a;
  result.size = tip.size / frame.a;
  if (line.symmetric_half) {
    result.half = side_of_body(host, frame);
    if (result.half == 0 || result.line.size() != 2) {
      diagnostics.error(span, "E422",
                        fmt::format("{} lies on a symmetry line, which must be a straight part of "
                                    "the boundary",
                                    line.title()));
      return std::nullopt;
    }
  }
  const double room =
      std::min(tip_clearance(host, frame, result.line, result.half != 0, line.net), last.norm());
  if (room < through) {
    diagnostics.error(
        span, "E423",
        fmt::format("{}: with a = {:.6g} the tip lies on the boundary: the crack cuts "
                    "the body through, or its line is neither inside the body nor "
                    "held as a line of symmetry",
                    line.title(), frame.a));
    return std::nullopt;
  }
  if (result.radius > 0.9 * room || result.size >= result.radius || !(result.size > 0.0)) {
    diagnostics.error(
        span, "E423",
        fmt::format("{}: a rosette of radius {:.6g} with tip elements of {:.6g} does not fit, the "
                    "tip has {:.6g} of room",
                    line.title(), tip.radius, tip.size, room * frame.a),
        "RADIUS of $TIPNET must be smaller than that, and SIZE smaller than RADIUS");
    return std::nullopt;
  }
  return result;
}

} // namespace spricka::mesh
