// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/crack_picture.hpp"

#include "report/drawing/colour_scale.hpp"
#include "report/drawing/crack_opening.hpp"
#include "report/drawing/picture_frame.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace spricka::report {
namespace {

/// Of slanted views with z up the one that sees most of the crack's face and its mouth.
PictureViewpoint eye_for(const FittedFrontPlane& frame) {
  PictureViewpoint best;
  double most = -std::numeric_limits<double>::infinity();
  for (const double first : {0.5, -0.5, 0.75, -0.75}) {
    for (const double up : {0.45, -0.45}) {
      for (const double side : {-1.0, 1.0}) {
        const base::Vec3 towards =
            base::Vec3(first, side * (1.25 - std::abs(first)), up).normalized();
        const double flat = std::min(std::abs(towards.dot(frame.normal)), 0.6);
        const double seen = flat - towards.dot(frame.growth) + (up > 0.0 ? 0.1 : 0.0);
        if (seen > most + 1e-9) {
          most = seen;
          best = PictureViewpoint::looking_from(towards, base::Vec3::UnitZ());
        }
      }
    }
  }
  return best;
}

/// No more of a box than `half` each way from a place.
void narrow(PictureBox& box, DrawingPoint middle, double half) {
  box.low = {std::max(box.low.x, middle.x - half), std::max(box.low.y, middle.y - half)};
  box.high = {std::min(box.high.x, middle.x + half), std::min(box.high.y, middle.y + half)};
}

/// An edge of the surface, the normals of the faces that meet there and its nodes.
struct RidgeEdge {
  std::vector<base::NodeId> nodes; ///< from corner to corner
  std::vector<base::Vec3> normal;
};

/// Edges where the surface has a kink or an end, of one net. Corners are every second node of an
/// outline of a face of second order.
std::vector<RidgeEdge> ridges(const results::CrackLengthResult& increment, base::NetId net) {
  constexpr double kink = 0.9; // cosine, 26 degrees
  const model::Mesh& mesh = increment.mesh;
  std::map<std::pair<base::NodeId, base::NodeId>, RidgeEdge> edges;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    if (mesh.element_net[face.element.index()] != net) {
      continue;
    }
    const std::size_t n = face.outline.size();
    const std::size_t step = base::element_info(mesh.type[face.element.index()]).quadratic ? 2 : 1;
    const base::Vec3 normal = doubled_area_vector(mesh, face.outline).normalized();
    for (std::size_t i = 0; i < n; i += step) {
      const base::NodeId a = face.outline[i];
      const base::NodeId b = face.outline[(i + step) % n];
      RidgeEdge& edge = edges[std::minmax(a, b)];
      if (edge.nodes.empty()) {
        for (std::size_t k = 0; k <= step; ++k) {
          edge.nodes.push_back(face.outline[(i + k) % n]);
        }
      }
      edge.normal.push_back(normal);
    }
  }
  std::vector<RidgeEdge> kept;
  for (auto& [ends, edge] : edges) {
    if (edge.normal.size() != 2 || edge.normal[0].dot(edge.normal[1]) < kink) {
      kept.push_back(std::move(edge));
    }
  }
  return kept;
}

base::NetId net_of_front(const results::CrackLengthResult& increment,
                         const results::FrontResult& front) {
  const model::Mesh& mesh = increment.mesh;
  const base::NodeId nearest = nearest_node(mesh, front.points.front().x);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    if (std::ranges::find(nodes, nearest) != nodes.end()) {
      return mesh.element_net[e];
    }
  }
  return {};
}

std::vector<DrawingPoint> node_line(const std::vector<base::NodeId>& nodes, const model::Mesh& mesh,
                                    const PictureViewpoint& eye, const PictureFrame& frame) {
  std::vector<DrawingPoint> line;
  line.reserve(nodes.size());
  for (const base::NodeId n : nodes) {
    line.push_back(frame(eye(mesh.x[n.index()])));
  }
  return line;
}

/// Points of the front in the picture, the first once more where it is closed.
std::vector<DrawingPoint> front_line(const CrackView& view, const PictureViewpoint& eye,
                                     const PictureFrame& frame) {
  std::vector<DrawingPoint> line;
  for (const results::FrontPointResult& p : view.front->points) {
    line.push_back(frame(eye(p.x)));
  }
  if (view.front->is_loop) {
    line.push_back(line.front());
  }
  return line;
}

/// K1 of the points, without those at a surface, where it is a number of the mesh.
ColourScale k_scale(const results::FrontResult& front) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const results::FrontPointResult& p : front.points) {
    if (!p.at_surface) {
      low = std::min(low, p.K1);
      high = std::max(high, p.K1);
    }
  }
  return high >= low ? make_colour_scale(low, high) : ColourScale{};
}

/// Piece by piece in the colour of the mean of K1 at its ends.
void draw_front_line(SvgDrawing& svg, const CrackView& view, const std::vector<DrawingPoint>& line,
                     const ColourScale& scale) {
  svg.polyline(line, {"#fff", 6.0, "none", ""});
  const auto& points = view.front->points;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const results::FrontPointResult& a = points[i];
    const results::FrontPointResult& b = points[(i + 1) % points.size()];
    const double K = a.at_surface ? b.K1 : b.at_surface ? a.K1 : 0.5 * (a.K1 + b.K1);
    svg.line(line[i], line[i + 1], {band_colour(scale.band_index(K)), 4.0, "none", ""});
  }
}

void draw_legend(SvgDrawing& svg, const ColourScale& scale, const PictureFrame& frame, double width,
                 const std::string& words) {
  draw_colour_legend(svg, scale, {0.2 * width, frame.foot() + 12.0}, 0.6 * width, words);
}

} // namespace

std::string draw_crack_front(const CrackView& view) {
  const std::optional<FittedFrontPlane> plane = fit_front_plane(*view.front);
  const results::CrackLengthResult& increment = *view.increment;
  if (!plane || increment.surface.empty()) {
    return {};
  }
  const PictureViewpoint eye = eye_for(*plane);
  const std::vector<RidgeEdge> edges = ridges(increment, net_of_front(increment, *view.front));
  PictureBox box;
  for (const RidgeEdge& edge : edges) {
    for (const base::NodeId n : edge.nodes) {
      box.add(eye(increment.mesh.x[n.index()]));
    }
  }
  constexpr double surroundings = 4.0; // sizes of the crack
  narrow(box, eye(plane->centre), surroundings * plane->size);
  if (box.empty()) {
    return {};
  }
  const PictureFrame frame(box, view.width);
  SvgDrawing svg = frame.begin_drawing(fmt::format("{} in its body", view.front->name));
  svg.clip(fmt::format("front-{}", view.front->name), {0.0, PictureFrame::head}, view.width,
           frame.height());
  for (const RidgeEdge& edge : edges) {
    // behind the body: both faces look away
    const bool hidden = std::ranges::all_of(
        edge.normal, [&](const base::Vec3& n) { return n.dot(eye.towards) < 0.0; });
    svg.polyline(node_line(edge.nodes, increment.mesh, eye, frame),
                 {hidden ? "#b8bec8" : "#334", hidden ? 0.6 : 0.9, "none", ""});
  }
  for (const OpenedCrackFace& face : crack_face_openings(increment, *view.step, *plane)) {
    svg.polygon(node_line(face.outline, increment.mesh, eye, frame),
                {"#e8c9a0", 0.5, "#e8c9a0", ""});
  }
  svg.unclip();
  const ColourScale scale = k_scale(*view.front);
  draw_front_line(svg, view, front_line(view, eye, frame), scale);
  draw_legend(svg, scale, frame, view.width, fmt::format("K1, {}", view.k_name));
  return svg.svg_text();
}

std::string draw_crack_opening(const CrackView& view) {
  const std::optional<FittedFrontPlane> plane = fit_front_plane(*view.front);
  const results::CrackLengthResult& increment = *view.increment;
  if (!plane || view.step->u.size() != static_cast<Eigen::Index>(3 * increment.mesh.node_count())) {
    return {};
  }
  const std::vector<OpenedCrackFace> faces = crack_face_openings(increment, *view.step, *plane);
  // the way of growth to the right, from above the upper face
  const base::Vec3 to_right = plane->growth.norm() > 0.1 ? base::Vec3(plane->growth.normalized())
                                                         : plane->normal.unitOrthogonal();
  const PictureViewpoint eye =
      PictureViewpoint::looking_from(plane->normal, plane->normal.cross(to_right));
  PictureBox box;
  double low = 0.0;
  double opening = 0.0;
  double sliding = 0.0;
  for (const OpenedCrackFace& face : faces) {
    low = std::min(low, face.opening);
    opening = std::max(opening, std::abs(face.opening));
    sliding = std::max(sliding, face.sliding);
    for (const base::NodeId n : face.outline) {
      box.add(eye(increment.mesh.x[n.index()]));
    }
  }
  if (box.empty()) {
    return {};
  }
  const PictureFrame frame(box, view.width);
  const bool slides = opening < 1e-3 * sliding; // closed, and one face along the other
  const char* const what = slides ? "sliding" : "opening";
  const ColourScale scale =
      slides ? make_colour_scale(0.0, sliding) : make_colour_scale(low, opening);
  SvgDrawing svg = frame.begin_drawing(fmt::format("{}, {} of its faces", view.front->name, what));
  for (const OpenedCrackFace& face : faces) {
    svg.polygon(
        node_line(face.outline, increment.mesh, eye, frame),
        {"#223", 0.3, band_colour(scale.band_index(slides ? face.sliding : face.opening)), ""});
  }
  const std::vector<DrawingPoint> line = front_line(view, eye, frame);
  svg.polyline(line, {"#d55e00", 2.0, "none", ""});
  for (std::size_t i = 0; i < view.front->points.size(); ++i) {
    svg.marker(MarkerShape::circle, line[i], {"#d55e00", 1.0, "#fff", ""});
  }
  draw_legend(svg, scale, frame, view.width, fmt::format("{}, {}", what, view.length_name));
  return svg.svg_text();
}

} // namespace spricka::report
