// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/crack_picture.hpp"

#include "model/mesh.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/crack_opening.hpp"
#include "report/drawing/svg.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace spricka::report {
namespace {

constexpr double edge_margin = 14.0;
constexpr double crack_title_room = 26.0;
constexpr double colours_room = 48.0;

/// What the picture's right and up are, and where the eye is.
struct Eye {
  base::Vec3 towards;
  base::Vec3 right;
  base::Vec3 up;
  [[nodiscard]] DrawingPoint operator()(const base::Vec3& x) const {
    return {right.dot(x), up.dot(x)};
  }
};

Eye eye_at(const base::Vec3& towards, const base::Vec3& up) {
  const base::Vec3 right = up.cross(towards).normalized();
  return {towards, right, towards.cross(right)};
}

/// Of slanted views with z up the one that sees most of the crack's face and its mouth.
Eye eye_for(const FittedFrontPlane& frame) {
  Eye best;
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
          best = eye_at(towards, base::Vec3::UnitZ());
        }
      }
    }
  }
  return best;
}

/// From places as the eye has them to pixels, y down.
class CrackWindow {
public:
  void take(DrawingPoint p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  /// No more of it than `half` each way from a place.
  void narrow(DrawingPoint middle, double half) {
    low_ = {std::max(low_.x, middle.x - half), std::max(low_.y, middle.y - half)};
    high_ = {std::min(high_.x, middle.x + half), std::min(high_.y, middle.y + half)};
  }
  void fit(double width) {
    const double inner = width - 2.0 * edge_margin;
    scale_ = std::min(inner / (high_.x - low_.x), 0.85 * inner / (high_.y - low_.y));
    left_ = 0.5 * (width - scale_ * (high_.x - low_.x));
  }
  [[nodiscard]] bool empty() const { return !(high_.x > low_.x && high_.y > low_.y); }
  [[nodiscard]] double height() const { return scale_ * (high_.y - low_.y) + 2.0 * edge_margin; }
  [[nodiscard]] DrawingPoint operator()(DrawingPoint p) const {
    return {left_ + scale_ * (p.x - low_.x),
            crack_title_room + edge_margin + scale_ * (high_.y - p.y)};
  }

private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  DrawingPoint low_{infinite, infinite};
  DrawingPoint high_{-infinite, -infinite};
  double scale_ = 1.0;
  double left_ = 0.0;
};

/// An edge of the surface, the normals of the faces that meet there and its nodes.
struct RidgeEdge {
  std::vector<base::NodeId> nodes; ///< from corner to corner
  std::vector<base::Vec3> normal;
};

/// Edges where the surface has a kink or an end, of one net. Corners are every second node of an
/// outline of a face of second order.
std::vector<RidgeEdge> ridges(const results::Increment& increment, base::NetId net) {
  constexpr double kink = 0.9; // cosine, 26 degrees
  const model::Mesh& mesh = increment.mesh;
  std::map<std::pair<base::NodeId, base::NodeId>, RidgeEdge> edges;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    if (mesh.element_net[face.element.index()] != net) {
      continue;
    }
    const std::size_t n = face.outline.size();
    const std::size_t step = base::element_info(mesh.type[face.element.index()]).quadratic ? 2 : 1;
    base::Vec3 area = base::Vec3::Zero();
    const base::Vec3& origin = mesh.x[face.outline.front().index()];
    for (std::size_t i = 0; i < n; ++i) {
      area += (mesh.x[face.outline[i].index()] - origin)
                  .cross(mesh.x[face.outline[(i + 1) % n].index()] - origin);
    }
    for (std::size_t i = 0; i < n; i += step) {
      const base::NodeId a = face.outline[i];
      const base::NodeId b = face.outline[(i + step) % n];
      RidgeEdge& edge = edges[std::minmax(a, b)];
      if (edge.nodes.empty()) {
        for (std::size_t k = 0; k <= step; ++k) {
          edge.nodes.push_back(face.outline[(i + k) % n]);
        }
      }
      edge.normal.push_back(area.normalized());
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

base::NetId net_of_front(const results::Increment& increment, const results::FrontResult& front) {
  const model::Mesh& mesh = increment.mesh;
  const base::Vec3& x = front.points.front().x;
  base::NodeId nearest = mesh.nodes.front();
  for (const base::NodeId n : mesh.nodes) {
    if ((mesh.x[n.index()] - x).squaredNorm() < (mesh.x[nearest.index()] - x).squaredNorm()) {
      nearest = n;
    }
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    if (std::ranges::find(nodes, nearest) != nodes.end()) {
      return mesh.element_net[e];
    }
  }
  return {};
}

/// Points of the front in the picture, the first once more where it is closed.
std::vector<DrawingPoint> front_line(const CrackView& view, const Eye& eye,
                                     const CrackWindow& window) {
  std::vector<DrawingPoint> line;
  for (const results::FrontPointResult& p : view.front->points) {
    line.push_back(window(eye(p.x)));
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
  return high >= low ? scale_between(low, high) : ColourScale{};
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
    svg.line(line[i], line[i + 1], {band_colour(scale.band(K)), 4.0, "none", ""});
  }
}

void title_of(SvgDrawing& svg, double width, const std::string& words) {
  svg.text({0.5 * width, 15.0}, words, {TextAnchor::middle, 13.0, "#000", 0.0, false, true});
}

void draw_legend(SvgDrawing& svg, const ColourScale& scale, double top, double width,
                 const std::string& words) {
  if (scale.high > scale.low) {
    draw_colour_legend(svg, scale, {0.2 * width, top + 12.0}, 0.6 * width, words);
  }
}

SvgPathData outline_path(const std::vector<base::NodeId>& outline, const model::Mesh& mesh,
                         const Eye& eye, const CrackWindow& window) {
  SvgPathData path;
  path.move(window(eye(mesh.x[outline.front().index()])));
  for (std::size_t i = 1; i < outline.size(); ++i) {
    path.line(window(eye(mesh.x[outline[i].index()])));
  }
  return path.close();
}

} // namespace

std::string draw_front(const CrackView& view) {
  const std::optional<FittedFrontPlane> frame = fit_front_plane(*view.front);
  const results::Increment& increment = *view.increment;
  if (!frame || increment.surface.empty()) {
    return {};
  }
  const Eye eye = eye_for(*frame);
  const std::vector<RidgeEdge> edges = ridges(increment, net_of_front(increment, *view.front));
  CrackWindow window;
  for (const RidgeEdge& edge : edges) {
    for (const base::NodeId n : edge.nodes) {
      window.take(eye(increment.mesh.x[n.index()]));
    }
  }
  constexpr double surroundings = 4.0; // sizes of the crack
  window.narrow(eye(frame->centre), surroundings * frame->size);
  if (window.empty()) {
    return {};
  }
  window.fit(view.width);
  const std::string title = fmt::format("{} in its body", view.front->name);
  SvgDrawing svg(view.width, crack_title_room + window.height() + colours_room, title);
  title_of(svg, view.width, title);
  svg.clip(fmt::format("front-{}", view.front->name), {0.0, crack_title_room}, view.width,
           window.height());
  for (const RidgeEdge& edge : edges) {
    // behind the body: both faces look away
    const bool hidden = std::ranges::all_of(
        edge.normal, [&](const base::Vec3& n) { return n.dot(eye.towards) < 0.0; });
    std::vector<DrawingPoint> line;
    for (const base::NodeId n : edge.nodes) {
      line.push_back(window(eye(increment.mesh.x[n.index()])));
    }
    svg.polyline(line, {hidden ? "#b8bec8" : "#334", hidden ? 0.6 : 0.9, "none", ""});
  }
  for (const CrackFaceOpening& face : crack_face_openings(increment, *view.step, *frame)) {
    svg.path(outline_path(face.outline, increment.mesh, eye, window),
             {"#e8c9a0", 0.5, "#e8c9a0", ""});
  }
  svg.unclip();
  const ColourScale scale = k_scale(*view.front);
  draw_front_line(svg, view, front_line(view, eye, window), scale);
  draw_legend(svg, scale, crack_title_room + window.height(), view.width,
              fmt::format("K1, {}", view.k_name));
  return svg.svg_text();
}

std::string draw_opening(const CrackView& view) {
  const std::optional<FittedFrontPlane> frame = fit_front_plane(*view.front);
  const results::Increment& increment = *view.increment;
  if (!frame || view.step->u.size() != static_cast<Eigen::Index>(3 * increment.mesh.node_count())) {
    return {};
  }
  const std::vector<CrackFaceOpening> faces = crack_face_openings(increment, *view.step, *frame);
  if (faces.empty()) {
    return {};
  }
  // the way of growth to the right, from above the upper face
  const base::Vec3 to_right = frame->growth.norm() > 0.1 ? base::Vec3(frame->growth.normalized())
                                                         : frame->normal.unitOrthogonal();
  const Eye eye = eye_at(frame->normal, frame->normal.cross(to_right));
  CrackWindow window;
  double opening = 0.0;
  double sliding = 0.0;
  for (const CrackFaceOpening& face : faces) {
    opening = std::max(opening, std::abs(face.opening));
    sliding = std::max(sliding, face.sliding);
    for (const base::NodeId n : face.outline) {
      window.take(eye(increment.mesh.x[n.index()]));
    }
  }
  if (window.empty()) {
    return {};
  }
  window.fit(view.width);
  const bool slides = opening < 1e-3 * sliding; // closed, and one face along the other
  double low = 0.0;
  for (const CrackFaceOpening& face : faces) {
    low = slides ? low : std::min(low, face.opening);
  }
  const ColourScale scale = scale_between(low, slides ? sliding : opening);
  const std::string title =
      fmt::format("{}, {} of its faces", view.front->name, slides ? "sliding" : "opening");
  SvgDrawing svg(view.width, crack_title_room + window.height() + colours_room, title);
  title_of(svg, view.width, title);
  for (const CrackFaceOpening& face : faces) {
    svg.path(outline_path(face.outline, increment.mesh, eye, window),
             {"#223", 0.3, band_colour(scale.band(slides ? face.sliding : face.opening)), ""});
  }
  const std::vector<DrawingPoint> line = front_line(view, eye, window);
  svg.polyline(line, {"#d55e00", 2.0, "none", ""});
  for (std::size_t i = 0; i < view.front->points.size(); ++i) {
    svg.marker(MarkerShape::circle, line[i], {"#d55e00", 1.0, "#fff", ""});
  }
  draw_legend(svg, scale, crack_title_room + window.height(), view.width,
              fmt::format("{}, {}", slides ? "sliding" : "opening", view.length_name));
  return svg.svg_text();
}

} // namespace spricka::report
