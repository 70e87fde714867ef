// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/crack_picture.hpp"

#include "report/drawing/colour_scale.hpp"
#include "report/drawing/crack_opening.hpp"
#include "report/drawing/picture_frame.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spricka::report {
namespace {

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

void draw_legend(SvgDrawing& svg, const ColourScale& scale, const PictureFrame& frame, double width,
                 const MeasureTitle& title) {
  draw_colour_legend(svg, scale, {0.2 * width, frame.foot() + 12.0}, 0.6 * width, title);
}

} // namespace

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
  draw_legend(svg, scale, frame, view.width, legend_title(what, view.length));
  return svg.svg_text();
}

} // namespace spricka::report
