// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/picture_frame.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace spricka::report {
namespace {

constexpr double frame_margin = 14.0;
constexpr double colours_room = 48.0;

} // namespace

void PictureBox::add(DrawingPoint p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

PictureViewpoint PictureViewpoint::looking_from(const base::Vec3& towards,
                                                const base::Vec3& upward) {
  const base::Vec3 right = upward.cross(towards).normalized();
  return {towards, right, towards.cross(right)};
}

PictureFrame::PictureFrame(const PictureBox& box, double width)
    : box_(box), width_(width),
      scale_(std::min((width - 2.0 * frame_margin) / box.width(),
                      0.85 * (width - 2.0 * frame_margin) / box.height())),
      left_(0.5 * (width - scale_ * box.width())),
      height_(scale_ * box.height() + 2.0 * frame_margin) {}

SvgDrawing PictureFrame::begin_drawing(std::string_view title) const {
  SvgDrawing svg(width_, foot() + colours_room, title);
  svg.title({0.5 * width_, 15.0}, title);
  return svg;
}

DrawingPoint PictureFrame::operator()(DrawingPoint p) const {
  return {left_ + scale_ * (p.x - box_.low.x), head + frame_margin + scale_ * (box_.high.y - p.y)};
}

double displacement_magnification(double largest, double share) {
  return largest > 0.0 ? round_number_below(share / largest) : 0.0;
}

base::NodeId nearest_node(const model::Mesh& mesh, const base::Vec3& x) {
  return *std::ranges::min_element(
      mesh.nodes, {}, [&](base::NodeId n) { return (mesh.x[n.index()] - x).squaredNorm(); });
}

base::Vec3 doubled_area_vector(const model::Mesh& mesh, const std::vector<base::NodeId>& outline) {
  const base::Vec3& origin = mesh.x[outline.front().index()];
  base::Vec3 area = base::Vec3::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    area += (mesh.x[outline[i].index()] - origin)
                .cross(mesh.x[outline[(i + 1) % outline.size()].index()] - origin);
  }
  return area;
}

} // namespace spricka::report
