// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/solid_picture.hpp"

#include "model/property_points.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/svg.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spricka::report {
namespace {

constexpr double margin = 12.0;
constexpr double head_height = 24.0;
constexpr double legend_room = 46.0;

/// The camera looks along -towards, z up.
struct Camera {
  base::Vec3 towards = base::Vec3(0.5, -0.75, 0.45).normalized();
  base::Vec3 right = base::Vec3::UnitZ().cross(towards).normalized();
  base::Vec3 up = towards.cross(right);
};

struct DrawnFace {
  std::vector<DrawingPoint> outline;
  double depth = 0.0; ///< towards the eye
  double value = 0.0; ///< von Mises
};

/// Largest extent of the surface.
double size_of(const results::Increment& increment) {
  base::Vec3 low = base::Vec3::Constant(std::numeric_limits<double>::infinity());
  base::Vec3 high = -low;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    for (const base::NodeId n : face.outline) {
      low = low.cwiseMin(increment.mesh.x[n.index()]);
      high = high.cwiseMax(increment.mesh.x[n.index()]);
    }
  }
  return (high - low).maxCoeff();
}

/// So that the largest displacement is a round share, at most a fifteenth, of the size; 0: none.
double magnification(const SolidView& view) {
  const std::size_t nodes = view.increment->mesh.node_count();
  if (view.step->u.size() != static_cast<Eigen::Index>(3 * nodes)) {
    return 0.0;
  }
  double largest = 0.0;
  for (std::size_t n = 0; n < nodes; ++n) {
    largest = std::max(largest, view.step->u.segment<3>(static_cast<Eigen::Index>(3 * n)).norm());
  }
  return largest > 0.0 ? round_number_below(size_of(*view.increment) / 15.0 / largest) : 0.0;
}

class Painter {
public:
  explicit Painter(const SolidView& view)
      : view_(view), magnify_(magnification(view)),
        points_(model::property_points(view.increment->mesh)) {}

  /// Faces turned to the eye, the farthest first.
  [[nodiscard]] std::vector<DrawnFace> faces() const {
    std::vector<DrawnFace> drawn;
    for (const results::OuterSurfaceFace& face : view_.increment->surface) {
      base::Vec3 area = base::Vec3::Zero();
      base::Vec3 centre = base::Vec3::Zero();
      DrawnFace out;
      for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const base::Vec3 x = place(face.outline[i]);
        area += x.cross(place(face.outline[(i + 1) % face.outline.size()]));
        centre += x / static_cast<double>(face.outline.size());
        out.outline.push_back({camera_.right.dot(x), camera_.up.dot(x)});
        out.value += von_mises(face, i) / static_cast<double>(face.outline.size());
      }
      if (area.dot(camera_.towards) > 0.0) {
        out.depth = centre.dot(camera_.towards);
        drawn.push_back(std::move(out));
      }
    }
    std::ranges::stable_sort(drawn, {}, &DrawnFace::depth);
    return drawn;
  }
  [[nodiscard]] double magnify() const { return magnify_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }

private:
  [[nodiscard]] base::Vec3 place(base::NodeId n) const {
    base::Vec3 x = view_.increment->mesh.x[n.index()];
    if (magnify_ > 0.0) {
      x += magnify_ * view_.step->u.segment<3>(static_cast<Eigen::Index>(3 * n.index()));
    }
    return x;
  }
  // Of the face's own element where properties meet.
  [[nodiscard]] double von_mises(const results::OuterSurfaceFace& face, std::size_t i) const {
    const model::Mesh& mesh = view_.increment->mesh;
    const auto nodes = mesh.element_nodes(face.element);
    const auto local = std::ranges::find(nodes, face.outline[i]) - nodes.begin();
    const auto k = static_cast<std::size_t>(mesh.first[face.element.index()] + local);
    return results::von_mises(view_.step->stress[static_cast<std::size_t>(points_.of[k])]);
  }

  const SolidView& view_;
  Camera camera_;
  double magnify_ = 0.0;
  model::PropertyPoints points_;
};

/// Moves the faces into the picture, y down; returns its height.
double fit(std::vector<DrawnFace>& faces, double width) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  DrawingPoint low{infinite, infinite};
  DrawingPoint high{-infinite, -infinite};
  for (const DrawnFace& face : faces) {
    for (const DrawingPoint& p : face.outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double inner = width - 2.0 * margin;
  const double scale = std::min(inner / (high.x - low.x), 0.85 * inner / (high.y - low.y));
  const double left = 0.5 * (width - scale * (high.x - low.x));
  for (DrawnFace& face : faces) {
    for (DrawingPoint& p : face.outline) {
      p = {left + scale * (p.x - low.x), head_height + margin + scale * (high.y - p.y)};
    }
  }
  return scale * (high.y - low.y) + 2.0 * margin;
}

ColourScale scale_of(const std::vector<DrawnFace>& faces) {
  const auto [low, high] = std::ranges::minmax(faces, {}, &DrawnFace::value);
  return scale_between(low.value, high.value);
}

void draw_axes(SvgDrawing& svg, const Camera& camera, DrawingPoint at) {
  constexpr double length = 24.0;
  for (int c = 0; c < 3; ++c) {
    const base::Vec3 axis = base::Vec3::Unit(c);
    const DrawingPoint way{camera.right.dot(axis), -camera.up.dot(axis)};
    svg.line(at, {at.x + length * way.x, at.y + length * way.y}, {"#000", 1.1, "none", ""});
    svg.text({at.x + 1.35 * length * way.x, at.y + 1.35 * length * way.y + 4.0},
             std::string(1, "xyz"[c]), {TextAnchor::middle, 11.0});
  }
}

} // namespace

std::string draw_svg(const SolidView& view) {
  const Painter painter(view);
  std::vector<DrawnFace> faces = painter.faces();
  const double height = fit(faces, view.width);
  const ColourScale scale = scale_of(faces);
  const std::string title = "Surface, von Mises stress";
  SvgDrawing svg(view.width, head_height + height + legend_room, title);
  svg.text({0.5 * view.width, 14.0}, title, {TextAnchor::middle, 13.0, "#000", 0.0, false, true});
  for (const DrawnFace& face : faces) {
    SvgPathData path;
    path.move(face.outline.front());
    for (std::size_t i = 1; i < face.outline.size(); ++i) {
      path.line(face.outline[i]);
    }
    svg.path(path.close(), {"#223", 0.35, band_colour(scale.band(face.value)), ""});
  }
  const double top = head_height + height;
  if (scale.high > scale.low) {
    draw_colour_legend(svg, scale, {0.3 * view.width, top + 12.0}, 0.62 * view.width,
                       fmt::format("von Mises, {}", view.stress_name));
  }
  draw_axes(svg, painter.camera(), {40.0, top + 14.0});
  if (painter.magnify() > 0.0) {
    svg.text({view.width - 2.0, head_height + 4.0},
             fmt::format("displacements × {:.3g}", painter.magnify()), {TextAnchor::end, 11.0});
  }
  return svg.svg_text();
}

} // namespace spricka::report
