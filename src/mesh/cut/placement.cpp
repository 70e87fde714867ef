// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/placement.hpp"

#include "geometry/polyline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// A start inside the body that is nearer to the boundary than this part of the crack's length was
/// meant to be on it.
constexpr double short_of_boundary = 0.01;

// Room for the tip, as a part of the crack's length, below which nothing is left of the ligament.
constexpr double through = 1e-4;
// The same for the straight part at a tip.
constexpr double shortest_part = 1e-5;

bool on_axis(const Vec2& p) {
  return std::abs(p.y()) < coordinate_tolerance;
}

/// Which side of a crack along the boundary the body lies on.
int side_of_body(const HostMesh& host, const CrackFrame& frame) {
  for (const model::Face& face : host.boundary()) {
    const EdgeEndAndMidNodes edge = element_edge_nodes(host.mesh(), face);
    const Vec2 a = frame.rounded_local_coordinates(host.mesh().x[edge.a.index()]).head<2>();
    const Vec2 b = frame.rounded_local_coordinates(host.mesh().x[edge.b.index()]).head<2>();
    if (on_axis(a) && on_axis(b) && std::max(a.x(), b.x()) > coordinate_tolerance &&
        std::min(a.x(), b.x()) < 1.0 - coordinate_tolerance) {
      // Edges run with the body on their left: one that runs as the crack does has it on the
      // crack's left.
      return b.x() > a.x() ? 1 : -1;
    }
  }
  return 0;
}

/// Distance from the last point of a line to some faces of its net, but for the line itself of a
/// symmetric half [a].
double tip_clearance(const HostMesh& host, const CrackFrame& frame, const std::vector<Vec2>& line,
                     bool half, base::NetId net, const std::vector<model::Face>& faces) {
  const model::Mesh& mesh = host.mesh();
  const Vec3 tip = frame.global(base::embed_in_space(line.back()));
  const Vec2 along = (line.back() - line[line.size() - 2]).normalized();
  const auto is_ahead = [&](base::NodeId n) {
    const Vec2 x = frame.exact_local_coordinates(mesh.x[n.index()]).head<2>();
    return std::abs(cross(along, x - line.back())) < coordinate_tolerance;
  };
  const auto on_line = [&](const EdgeEndAndMidNodes& edge) {
    return is_ahead(edge.a) && is_ahead(edge.b);
  };
  double least = std::numeric_limits<double>::max();
  for (const model::Face& face : faces) {
    const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, face);
    // The quick test first: the nearest point of a curved edge takes some steps.
    if (is_face_element_in_net(mesh, face, net) &&
        !is_edge_beyond_distance_of_point(mesh, edge, tip, least) && !(half && on_line(edge))) {
      least = std::min(least, nearest_point_on_edge(mesh, edge, tip).distance);
    }
  }
  return least / frame.a;
}

} // namespace

double tip_boundary_distance(const HostMesh& host, const CrackFrame& frame,
                             const std::vector<Vec2>& line, bool half, base::NetId net) {
  return std::min(tip_clearance(host, frame, line, half, net, host.boundary()),
                  tip_clearance(host, frame, line, half, net, host.property_borders()));
}

CrackFrame make_crack_frame(const CrackLine& line) {
  CrackFrame frame;
  frame.origin = line.points.front();
  const Vec3 along = (line.points[1] - line.points[0]).normalized();
  frame.axes.col(0) = along;
  frame.axes.col(1) = Vec3(-along.y(), along.x(), 0.0);
  frame.a = (line.embedded ? 0.5 : 1.0) * geometry::polyline_length(line.points);
  return frame;
}

double geometric_ring_sum(int rings, double factor) {
  double sum = 0.0;
  for (int k = 0; k < rings; ++k) {
    sum = sum * factor + 1.0;
  }
  return sum;
}

namespace {

std::string text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g})", p.x(), p.y());
}

/// Finds where the crack starts and moves its frame there.
bool put_start(const HostMesh& host, const CrackLine& line, CrackPlacement& result,
               base::Diagnostics& diagnostics, base::SourceSpan span) {
  const Vec3& start = line.points.front();
  const NearestMouth found = find_crack_mouth(host, start, line.net);
  const bool mouth = found.on_boundary();
  if (mouth && !line.embedded) {
    result.mouth = found.mouth;
    result.seed = found.mouth.face.element;
    result.frame.origin = found.at;
    return true;
  }
  result.seed = find_element_at(host.mesh(), start, line.net);
  if (!mouth && line.embedded && result.seed.valid() &&
      found.distance > short_of_boundary * result.frame.a) {
    return true;
  }
  const std::string hint = found.chord > 0.0
                               ? fmt::format("the nearest boundary point is {}", text(found.at))
                               : "the net has no boundary there";
  if (!mouth && line.embedded && result.seed.valid()) {
    diagnostics.error(
        span, "E421",
        fmt::format("{} starts at {}, {:.3g} short of the boundary: neither on it nor "
                    "inside the body",
                    line.display_name(), text(start), found.distance),
        hint);
    return false;
  }
  diagnostics.error(span, "E421",
                    fmt::format("{} starts at {}, which is neither on the boundary nor inside the "
                                "body",
                                line.display_name(), text(start)),
                    hint);
  return false;
}

double angle_of(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

/// The least distance of a tip from the boundary [a].
double ligament_of(const HostMesh& host, const CrackPlacement& placement, base::NetId net) {
  const bool half = placement.half != 0;
  const auto& faces = host.boundary();
  double least = tip_clearance(host, placement.frame, placement.line, half, net, faces);
  if (placement.fronts.size() > 1) {
    const std::vector<Vec2> reversed(placement.line.rbegin(), placement.line.rend());
    least = std::min(least, tip_clearance(host, placement.frame, reversed, half, net, faces));
  }
  return least;
}

/// A tip on the boundary: the whole crack may lie there.
void report_removed_section(const HostMesh& host, const CrackLine& line, const CrackFrame& frame,
                            double room, base::Diagnostics& diagnostics, base::SourceSpan span) {
  const Vec3 middle = 0.5 * (line.points[0] + line.points[1]);
  if (find_crack_mouth(host, middle, line.net).distance < 1e-6 * frame.a) {
    const bool path = !line.path.empty();
    diagnostics.error(
        span, "E423",
        fmt::format("{} runs along the boundary{}", line.display_name(),
                    path ? ", but not all nodes of PATH are suppressed across it" : ""),
        path ? "on a line of symmetry every node of PATH is in a $FREEDOM CLASS=SUPPRESSED of the "
               "direction across; the crack's part is set free by the program"
             : "a crack on a line of symmetry is given by PATH, its nodes all suppressed across "
               "that line");
    return;
  }
  diagnostics.error(span, "E423",
                    fmt::format("{}: with a = {:.6g} the net section is lost: a tip is {:.3g} from "
                                "the boundary",
                                line.display_name(), frame.a, room * frame.a),
                    "a crack needs a ligament of at least 1e-4 of its length; a body cut through "
                    "is two nets");
}

/// The fronts of a line, each a tip with its direction of growth.
std::vector<PlacedTip> fronts_of(const std::vector<Vec2>& line, bool embedded) {
  const bool straight = line.size() == 2; // then the angles are exact
  const Vec2 last = line.back() - line[line.size() - 2];
  const PlacedTip end{line.back(), straight ? 0.0 : angle_of(last)};
  if (!embedded) {
    return {end};
  }
  return {{line.front(), straight ? std::numbers::pi : angle_of(line[0] - line[1])}, end};
}

/// Room for a rosette at the last point of a line: to the boundary, along the last stretch.
double room_at_end(const HostMesh& host, const CrackPlacement& placement,
                   const std::vector<Vec2>& line, base::NetId net) {
  const double last = (line.back() - line[line.size() - 2]).norm();
  const bool shared = placement.fronts.size() > 1 && line.size() == 2; // with the other tip
  return std::min(tip_boundary_distance(host, placement.frame, line, placement.half != 0, net),
                  shared ? 0.5 * last : last);
}

// From ring to ring of a rosette thicknesses may grow by this; K is then 1 % off (an edge crack
// with five rings), at 11 it is 4 %, both more than what the near-tip fields are good for.
constexpr double steepest = 6.0;
constexpr double usual_steep = 2.0;

bool rings_follow(const TipMeshParameters& tip) {
  return tip.rings < 2 || tip.radius <= geometric_ring_sum(tip.rings, steepest) * tip.size;
}

void report_steep_rings(const CrackLine& line, const TipMeshParameters& tip,
                        base::Diagnostics& diagnostics, base::SourceSpan span) {
  int rings = tip.rings;
  while (geometric_ring_sum(rings, usual_steep) * tip.size < tip.radius) {
    ++rings;
  }
  diagnostics.error(
      span, "E457",
      fmt::format("{}: {} rings from tip elements of {:.6g} to a radius of {:.6g} grow more than "
                  "{:.0f} times from one to the next: K would be wrong",
                  line.display_name(), tip.rings, tip.size, tip.radius, steepest),
      fmt::format("SIZE={:.3g} of $TIPNET goes with these rings, or RINGS={} with that SIZE",
                  tip.radius / geometric_ring_sum(tip.rings, usual_steep), rings));
}

} // namespace

std::optional<CrackPlacement> place_crack_in_host(const HostMesh& host, const CrackLine& line,
                                                  const TipMeshParameters& tip,
                                                  base::SourceSpan span,
                                                  base::Diagnostics& diagnostics) {
  CrackPlacement result;
  CrackFrame& frame = result.frame;
  frame = make_crack_frame(line);
  if (!put_start(host, line, result, diagnostics, span)) {
    return std::nullopt;
  }
  for (const Vec3& p : line.points) {
    // The start was moved onto the boundary and takes the line along: its length and shape stay.
    result.line.push_back(
        frame.exact_local_coordinates(p - line.points[0] + frame.origin).head<2>());
  }
  result.line[0].setZero();
  // A straight crack lies on the axis exactly, whatever round-off its direction has.
  if (result.line.size() == 2) {
    result.line[1] = {line.embedded ? 2.0 : 1.0, 0.0};
  }
  result.fronts = fronts_of(result.line, line.embedded);
  result.radius = tip.radius / frame.a;
  result.size = tip.size / frame.a;
  if (line.symmetric_half) {
    result.half = side_of_body(host, frame);
    if (result.half == 0 || result.line.size() != 2) {
      diagnostics.error(span, "E422",
                        fmt::format("{} lies on a symmetry line, which must be a straight part of "
                                    "the boundary",
                                    line.display_name()));
      return std::nullopt;
    }
  }
  double room = room_at_end(host, result, result.line, line.net);
  if (line.embedded) {
    const std::vector<Vec2> reversed(result.line.rbegin(), result.line.rend());
    room = std::min(room, room_at_end(host, result, reversed, line.net));
  }
  if (const double ligament = ligament_of(host, result, line.net); ligament < through) {
    report_removed_section(host, line, frame, ligament, diagnostics, span);
    return std::nullopt;
  }
  if (room < shortest_part) { // of the crack, or up to a material boundary
    diagnostics.error(span, "E423",
                      fmt::format("{}: a tip has {:.3g} of room to a material boundary or to the "
                                  "point before it: at least 1e-5 of a = {:.6g}",
                                  line.display_name(), room * frame.a, frame.a),
                      "end the crack before the boundary, or leave out the point before the tip");
    return std::nullopt;
  }
  // A tenth of the room is left for elements between the rosette and what bounds it (crack.17).
  if (result.radius > 0.9 * room || result.size >= result.radius || !(result.size > 0.0)) {
    diagnostics.error(
        span, "E423",
        fmt::format("{}: a rosette of radius {:.6g} with tip elements of {:.6g} does not fit, the "
                    "tip has {:.6g} of room",
                    line.display_name(), tip.radius, tip.size, room * frame.a),
        "RADIUS of $TIPNET must be smaller than that, and SIZE smaller than RADIUS");
    return std::nullopt;
  }
  if (!rings_follow(tip)) {
    report_steep_rings(line, tip, diagnostics, span);
    return std::nullopt;
  }
  return result;
}

CrackPlacement placement_in_frame(const CrackPlacement& placement, const CrackFrame& frame) {
  CrackPlacement result = placement;
  const CrackFrame& own = placement.frame;
  if (own.origin == frame.origin && own.axes == frame.axes && own.a == frame.a) {
    return result;
  }
  // Directions are angles from the frame's axis, which turns.
  const Vec3 from = frame.axes.col(0);
  const Vec3 to = own.axes.col(0);
  const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const auto moved = [&](const Vec2& p) -> Vec2 {
    return frame.exact_local_coordinates(own.global(base::embed_in_space(p))).head<2>();
  };
  for (Vec2& p : result.line) {
    p = moved(p);
  }
  for (PlacedTip& tip : result.fronts) {
    tip.at = moved(tip.at);
    tip.direction += turn;
  }
  result.radius *= own.a / frame.a;
  result.size *= own.a / frame.a;
  result.frame = frame;
  return result;
}

} // namespace spricka::mesh
