// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/solid_picture.hpp"

#include "geometry/box.hpp"
#include "model/property_points.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/picture_frame.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::report {
namespace {

const PictureViewpoint slanted_eye =
    PictureViewpoint::looking_from(base::Vec3(0.5, -0.75, 0.45).normalized(), base::Vec3::UnitZ());

struct DrawnFace {
  std::vector<DrawingPoint> outline;
  double depth = 0.0; ///< towards the eye
  double value = 0.0; ///< von Mises
};

/// Largest extent of the surface.
double size_of(const results::CrackLengthResult& increment) {
  geometry::Box<3> box;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    for (const base::NodeId n : face.outline) {
      box.extend({increment.mesh.x[n.index()], increment.mesh.x[n.index()]});
    }
  }
  return (box.high - box.low).maxCoeff();
}

/// So that the largest displacement is at most a fifteenth of the size; 0: none.
double magnification_of(const SolidView& view) {
  const std::size_t nodes = view.increment->mesh.node_count();
  if (view.step->u.size() != static_cast<Eigen::Index>(3 * nodes)) {
    return 0.0;
  }
  double largest = 0.0;
  for (std::size_t n = 0; n < nodes; ++n) {
    largest = std::max(largest, view.step->u.segment<3>(static_cast<Eigen::Index>(3 * n)).norm());
  }
  return displacement_magnification(largest, size_of(*view.increment) / 15.0);
}

class Painter {
public:
  explicit Painter(const SolidView& view)
      : view_(view), magnify_(magnification_of(view)),
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
        out.outline.push_back(slanted_eye(x));
        out.value += von_mises(face, i) / static_cast<double>(face.outline.size());
      }
      if (area.dot(slanted_eye.towards) > 0.0) {
        out.depth = centre.dot(slanted_eye.towards);
        drawn.push_back(std::move(out));
      }
    }
    std::ranges::stable_sort(drawn, {}, &DrawnFace::depth);
    return drawn;
  }
  [[nodiscard]] double magnify() const { return magnify_; }

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
  double magnify_ = 0.0;
  model::FieldPointsByProperty points_;
};

ColourScale scale_of(const std::vector<DrawnFace>& faces) {
  const auto [low, high] = std::ranges::minmax(faces, {}, &DrawnFace::value);
  return make_colour_scale(low.value, high.value);
}

void draw_axes(SvgDrawing& svg, DrawingPoint at) {
  constexpr double length = 24.0;
  for (int c = 0; c < 3; ++c) {
    const DrawingPoint way = slanted_eye(base::Vec3::Unit(c));
    svg.line(at, {at.x + length * way.x, at.y - length * way.y}, {"#000", 1.1, "none", ""});
    svg.text({at.x + 1.35 * length * way.x, at.y - 1.35 * length * way.y + 4.0},
             std::string(1, "xyz"[c]), {TextAnchor::middle, 11.0});
  }
}

} // namespace

std::string draw_svg(const SolidView& view) {
  const Painter painter(view);
  std::vector<DrawnFace> faces = painter.faces();
  PictureBox box;
  for (const DrawnFace& face : faces) {
    std::ranges::for_each(face.outline, [&](DrawingPoint p) { box.add(p); });
  }
  const PictureFrame frame(box, view.width);
  const ColourScale scale = scale_of(faces);
  SvgDrawing svg = frame.begin_drawing("Surface, von Mises stress");
  for (DrawnFace& face : faces) {
    std::ranges::transform(face.outline, face.outline.begin(), frame);
    svg.polygon(face.outline, {"#223", 0.35, band_colour(scale.band_index(face.value)), ""});
  }
  draw_colour_legend(svg, scale, {0.3 * view.width, frame.foot() + 12.0}, 0.62 * view.width,
                     fmt::format("von Mises, {}", view.stress_name));
  draw_axes(svg, {40.0, frame.foot() + 14.0});
  if (painter.magnify() > 0.0) {
    svg.text({view.width - 2.0, PictureFrame::head + 4.0},
             fmt::format("displacements × {:.3g}", painter.magnify()), {TextAnchor::end, 11.0});
  }
  return svg.svg_text();
}

} // namespace spricka::report
