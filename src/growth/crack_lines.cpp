// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/crack_lines.hpp"

#include "fe/dof_map.hpp"
#include "geometry/polyline.hpp"
#include "growth/smooth_line.hpp"
#include "mesh/cut/mouth.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

constexpr double same_place = 1e-9; // of the crack length

// The drawn points of a curve may be few and its turns large.
geometry::SplineCurve curve_through(const std::vector<base::Vec3>& points) {
  constexpr int parts_of_length = 4;
  return {points, false, parts_of_length};
}

// The first `a` of a polyline; a point within round-off of the cut is the cut.
std::vector<base::Vec3> truncate(const std::vector<base::Vec3>& points, double a) {
  std::vector<base::Vec3> cut{points.front()};
  double left = a;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const base::Vec3 d = points[i] - points[i - 1];
    const double length = d.norm();
    if (left <= length * (1.0 + same_place)) {
      cut.push_back(std::abs(left - length) <= same_place * a ? points[i]
                                                              : points[i - 1] + left / length * d);
      return cut;
    }
    cut.push_back(points[i]);
    left -= length;
  }
  return cut;
}

// An embedded polyline made longer or shorter at either end.
std::vector<base::Vec3> prolong_both(std::vector<base::Vec3> points, double at_first,
                                     double at_last) {
  for (const double more : {at_last, at_first}) {
    if (more > 0.0) {
      const base::Vec3 d = (points.back() - points[points.size() - 2]).normalized();
      points.back() += more * d;
    } else {
      points = truncate(points, geometry::polyline_length(points) + more);
    }
    std::reverse(points.begin(), points.end());
  }
  return points;
}

// Corner and mid nodes of a straight path collapse to its two ends, so that a patch sees one
// segment.
std::vector<base::Vec3> without_middles(const std::vector<base::Vec3>& points) {
  std::vector<base::Vec3> kept{points.front()};
  const double scale = geometry::polyline_length(points);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const base::Vec3 d = (points[i + 1] - kept.back()).normalized();
    const base::Vec3 off = points[i] - kept.back();
    if ((off - off.dot(d) * d).norm() > 1e-7 * scale) {
      kept.push_back(points[i]);
    }
  }
  kept.push_back(points.back());
  return kept;
}

// Symmetry: every node of the path is suppressed across the path.
bool on_symmetry_line(const model::Model& model, const std::vector<base::NodeId>& path,
                      const std::vector<model::FreedomRole>& cls) {
  const model::Mesh& mesh = model.mesh;
  const base::Vec3 along =
      (mesh.x[path.back().index()] - mesh.x[path.front().index()]).normalized();
  const int across = std::abs(along.x()) > std::abs(along.y()) ? 1 : 0;
  // Freedoms are components: only along an axis is the motion across the path one of them.
  if (std::abs(along[across]) > 1e-9) {
    return false;
  }
  // About an axis a cylinder is no mirror, and the axis itself is held along the radius by nature.
  if (across == 0 && model::is_axisymmetric(model)) {
    return false;
  }
  const auto dim = static_cast<std::size_t>(mesh.dim);
  return std::all_of(path.begin(), path.end(), [&](base::NodeId n) {
    return cls[dim * n.index() + static_cast<std::size_t>(across)] ==
           model::FreedomRole::suppressed;
  });
}

struct CrackLineBuilder {
  const model::Model& model;
  base::Diagnostics& diagnostics;
  std::vector<model::FreedomRole> cls;
  std::optional<mesh::HostMesh> host = std::nullopt; ///< made when a crack is drawn

  /// Whether the first point of a drawn crack is inside the body.
  bool starts_inside(const model::CrackDefinition& crack) {
    if (!host) {
      host.emplace(model.mesh);
    }
    return mesh::locate_crack_start(*host, crack.points.front(), crack.net) ==
           mesh::CrackStartLocation::inside;
  }

  std::optional<mesh::CrackLine> path_line(const model::CrackDefinition& crack,
                                           mesh::CrackLine line) {
    line.path = model.mesh.set_with_id(crack.path).nodes;
    if (line.path.size() < 2) {
      diagnostics.error(crack.span, "E401",
                        fmt::format("crack {}: PATH needs at least two nodes", crack.name));
      return std::nullopt;
    }
    for (const base::NodeId n : line.path) {
      line.points.push_back(model.mesh.x[n.index()]);
    }
    line.net = model.mesh.node_net[line.path.front().index()];
    line.right_face_nodes = crack.right_face_nodes;
    line.embedded =
        !line.right_face_nodes.empty() && line.right_face_nodes.front() == line.path.front();
    // Seen from the suppressed freedoms: the deck does not say it.
    line.symmetric_half = on_symmetry_line(model, line.path, cls);
    return line;
  }

  std::optional<mesh::CrackLine> free_line(const model::CrackDefinition& crack,
                                           mesh::CrackLine line, const CrackLengthsByTip& arms) {
    const double a = arms.last;
    line.net = crack.net;
    line.points = crack.points;
    line.embedded = !line.points.empty() && starts_inside(crack);
    if (crack.angle && line.points.size() == 1) {
      const base::Vec3 along(std::cos(*crack.angle), std::sin(*crack.angle), 0.0);
      // of given lengths the first tip of an embedded crack stays at the point
      // By a law the middle of an embedded crack stays where it was first.
      const double drawn = arms.given ? a : first_length(crack);
      line.points.push_back(line.points.front() + (line.embedded ? 2.0 * drawn : a) * along);
    }
    if (line.points.size() < 2) {
      diagnostics.error(crack.span, "E401",
                        fmt::format("crack {}: one point needs ANGLE and A0", crack.name));
      return std::nullopt;
    }
    if (crack.smooth && line.points.size() > 2) {
      const geometry::SplineCurve curve = curve_through(line.points);
      // Arms count from the middle of the curve as drawn; beyond its ends it goes straight on.
      const double half = 0.5 * curve.length();
      line.points = line.embedded ? polyline_of_curve(curve, half - arms.first, half + a, true)
                                  : polyline_of_curve(curve, 0.0, a, false);
      return line;
    }
    // Beyond its last point a free crack goes straight on; an embedded one at both ends.
    const double given = geometry::polyline_length(line.points);
    if (line.embedded) {
      const double at_first = arms.first - 0.5 * given;
      const double at_last = a - 0.5 * given;
      if (std::max(std::abs(at_first), std::abs(at_last)) > same_place * a) {
        line.points = prolong_both(line.points, at_first, at_last);
      }
      return line;
    }
    if (a > given * (1.0 + same_place)) {
      const base::Vec3 last = line.points.back();
      const base::Vec3 d = (last - line.points[line.points.size() - 2]).normalized();
      line.points.back() = last + (a - given) * d;
    }
    return line;
  }

  // Length of the crack that the points draw; of an embedded one, half of it.
  double own_length(const model::CrackDefinition& crack) {
    const bool curved = crack.smooth && crack.points.size() > 2;
    return (starts_inside(crack) ? 0.5 : 1.0) * (curved ? curve_through(crack.points).length()
                                                        : geometry::polyline_length(crack.points));
  }

  double first_length(const model::CrackDefinition& crack) {
    if (crack.a0) {
      return *crack.a0;
    }
    return crack.kind == model::CrackDefinitionKind::free && crack.points.size() > 1
               ? own_length(crack)
               : 0.0;
  }

  std::optional<mesh::CrackLine> line(std::size_t number, CrackLengthsByTip arms) {
    const model::CrackDefinition& crack = model.cracks[number];
    // A crack that does not grow, and one without a length of its own here, has its first length.
    if (!is_growing_crack(model, number) || arms.last <= 0.0) {
      arms.first = arms.last = first_length(crack);
    }
    const double a = arms.last;
    if (a <= 0.0) {
      diagnostics.error(
          crack.span, "E402",
          fmt::format("crack {} has no length: give A0, points or $GROW lengths", crack.name));
      return std::nullopt;
    }
    mesh::CrackLine start;
    start.crack = base::CrackId(number);
    start.name = crack.name;
    std::optional<mesh::CrackLine> line = crack.kind == model::CrackDefinitionKind::path
                                              ? path_line(crack, start)
                                              : free_line(crack, start, arms);
    if (!line) {
      return line;
    }
    if (line->embedded || (crack.smooth && crack.points.size() > 2)) {
      line->points = without_middles(line->points);
      return line; // has its length already
    }
    if (geometry::polyline_length(line->points) < a * (1.0 - same_place)) {
      diagnostics.error(crack.span, "E403",
                        fmt::format("crack {}: length {:.6g} is longer than its path, {:.6g}",
                                    crack.name, a, geometry::polyline_length(line->points)));
      return std::nullopt;
    }
    line->points = without_middles(truncate(line->points, a));
    return line;
  }
};

} // namespace

std::vector<double> growth_loop_crack_lengths(const model::Model& model) {
  if (model.growth && !model.growth->lengths.empty() && !model.cracks.empty()) {
    return model.growth->lengths;
  }
  return {0.0};
}

std::vector<model::CrackDefinition> resize_solid_cracks(const model::Model& model, double a) {
  std::vector<model::CrackDefinition> cracks = model.cracks;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    model::PlanarCrack& plane = cracks[i].plane;
    if (a > 0.0 && is_growing_crack(model, i) &&
        cracks[i].kind == model::CrackDefinitionKind::ellipse) {
      plane.c *= a / plane.a;
      plane.a = a;
    }
  }
  return cracks;
}

bool is_growing_crack(const model::Model& model, std::size_t crack) {
  if (!model.growth) {
    return false;
  }
  const std::vector<base::CrackId>& list = model.growth->cracks;
  return list.empty() || std::find(list.begin(), list.end(), base::CrackId(crack)) != list.end();
}

std::optional<std::vector<mesh::CrackLine>> crack_lines(const model::Model& model, double a,
                                                        base::Diagnostics& diagnostics) {
  return crack_lines(
      model, std::vector<CrackLengthsByTip>(model.cracks.size(), CrackLengthsByTip{a, a, true}),
      diagnostics);
}

std::optional<std::vector<mesh::CrackLine>> crack_lines(const model::Model& model,
                                                        const std::vector<CrackLengthsByTip>& arms,
                                                        base::Diagnostics& diagnostics) {
  std::vector<mesh::CrackLine> lines;
  if (std::ranges::none_of(model.cracks, &model::CrackDefinition::is_line)) {
    return lines; // cracks in solids: mesh/tube/solid_crack.hpp
  }
  CrackLineBuilder builder{model, diagnostics, fe::classify_freedoms(model, model.mesh)};
  // All cracks are looked at, so that every error is told at once.
  bool complete = true;
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    std::optional<mesh::CrackLine> line = builder.line(c, arms[c]);
    complete = complete && line.has_value();
    if (line) {
      lines.push_back(std::move(*line));
    }
  }
  return complete ? std::optional(std::move(lines)) : std::nullopt;
}

} // namespace spricka::growth
