// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/solid_picture.hpp"

#include "geometry/box.hpp"
#include "model/property_points.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/picture_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::report {
namespace {

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

/// Of a face the mean over its nodes, of the face's own element where properties meet.
class FaceValues {
public:
  explicit FaceValues(const SolidView& view)
      : view_(view), points_(model::property_points(view.increment->mesh)) {}

  [[nodiscard]] double of(const results::OuterSurfaceFace& face) const {
    const model::Mesh& mesh = view_.increment->mesh;
    const auto nodes = mesh.element_nodes(face.element);
    double sum = 0.0;
    for (const base::NodeId n : face.outline) {
      const auto local = std::ranges::find(nodes, n) - nodes.begin();
      const auto k = static_cast<std::size_t>(mesh.first[face.element.index()] + local);
      sum += view_.value(view_.step->stress[static_cast<std::size_t>(points_.of[k])]);
    }
    return sum / static_cast<double>(face.outline.size());
  }

private:
  const SolidView& view_;
  model::FieldPointsByProperty points_;
};

/// What a facet takes of the picture.
double area_of(const std::vector<DrawingPoint>& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const DrawingPoint& a = outline[i];
    const DrawingPoint& b = outline[(i + 1) % outline.size()];
    doubled += a.x * b.y - b.x * a.y;
  }
  return 0.5 * std::abs(doubled);
}

ColourScale scale_of(const std::vector<DrawnFacet>& facets, const std::vector<double>& values) {
  constexpr double counted = 0.99;
  std::vector<std::pair<double, double>> shares;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    shares.emplace_back(values[i], area_of(facets[i].outline));
  }
  const auto [low, high] = std::ranges::minmax(values);
  const double top = value_above_share(shares, counted);
  const double foot = low < 0.0 ? value_above_share(shares, 1.0 - counted) : low;
  return make_colour_scale(foot, top > foot ? top : high);
}

} // namespace

std::string draw_svg(const SolidView& view) {
  const double magnify = magnification_of(view);
  const PictureViewpoint eye = slanted_viewpoint();
  const std::vector<DrawnFacet> facets = facets_towards_eye(
      *view.increment,
      {.eye = eye, .net = {}, .u = magnify > 0.0 ? &view.step->u : nullptr, .magnify = magnify});
  const FaceValues face_values(view);
  std::vector<double> values;
  PictureBox box;
  for (const DrawnFacet& facet : facets) {
    values.push_back(face_values.of(*facet.face));
    std::ranges::for_each(facet.outline, [&](DrawingPoint p) { box.add(p); });
  }
  if (box.empty()) {
    return {};
  }
  const PictureFrame frame(box, view.width);
  const ColourScale scale = scale_of(facets, values);
  const auto pixels = [&](std::vector<DrawingPoint> line) {
    std::ranges::transform(line, line.begin(), frame);
    return line;
  };
  SvgDrawing svg = frame.begin_drawing(view.title);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    svg.polygon(pixels(facets[i].outline),
                {"#223", 0.35, band_colour(scale.band_index(values[i])), ""});
    for (const std::vector<DrawingPoint>& ridge : facets[i].ridges) {
      svg.polyline(pixels(ridge), {"#000", 0.9, "none", ""});
    }
  }
  draw_colour_legend(svg, scale, {0.3 * view.width, frame.foot() + 12.0}, 0.62 * view.width,
                     view.field_title);
  draw_axes(svg, eye, {40.0, frame.foot() + 14.0});
  if (magnify > 0.0) {
    svg.text({view.width - 2.0, PictureFrame::head + 4.0},
             fmt::format("displacements × {:.3g}", magnify), {TextAnchor::end, 11.0});
  }
  return svg.svg_text();
}

} // namespace spricka::report
