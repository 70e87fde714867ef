// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"
#include "report/drawing/svg.hpp"

#include <limits>
#include <string_view>
#include <vector>

/// What pictures of bodies and cracks have in common.
namespace spricka::report {

/// The smallest upright rectangle round points of the plane; empty where it has no area.
struct PictureBox {
  DrawingPoint low{std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  DrawingPoint high{-low.x, -low.y};

  /// Makes the rectangle hold a point too.
  void add(DrawingPoint p);
  /// Whether it has no width or no height.
  [[nodiscard]] bool empty() const { return !(width() > 0.0 && height() > 0.0); }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.y - low.y; }
};

/// A view from far away: places in space to those of the picture, y up.
struct PictureViewpoint {
  base::Vec3 towards = base::Vec3::UnitZ(); ///< unit, from the place to the eye
  base::Vec3 right = base::Vec3::UnitX();
  base::Vec3 up = base::Vec3::UnitY();

  /// The eye in that direction from the place, with `upward` above.
  static PictureViewpoint looking_from(const base::Vec3& towards, const base::Vec3& upward);
  /// Where a place in space is in the picture [length].
  [[nodiscard]] DrawingPoint operator()(const base::Vec3& x) const {
    return {right.dot(x), up.dot(x)};
  }
};

/// A picture of a box with its title above it and the legend of its colours below.
class PictureFrame {
public:
  /// The box in the middle of a picture so many pixels wide; its height is at most 85 % of that.
  PictureFrame(const PictureBox& box, double width);
  /// A drawing with its title, else empty.
  [[nodiscard]] SvgDrawing begin_drawing(std::string_view title) const;
  /// Where a place of the box stands in the drawing.
  [[nodiscard]] DrawingPoint operator()(DrawingPoint p) const;
  [[nodiscard]] double height() const { return height_; } ///< of the box with its margins [px]
  /// Where the room below the box begins [px].
  [[nodiscard]] double foot() const { return head + height_; }

  static constexpr double head = 26.0; ///< room of the title [px]

private:
  PictureBox box_;
  double width_, scale_, left_, height_;
};

/// The factor of displacements in a picture that makes the largest of them a round share, at most
/// so much, of a length; 0 without displacements.
double displacement_magnification(double largest, double share);

/// The node of a mesh that is nearest to a place; the first of those that are as near. The mesh has
/// nodes.
base::NodeId nearest_node(const model::Mesh& mesh, const base::Vec3& x);

/// The area vector of a closed line of nodes, along its normal by the right-hand rule, twice as
/// long as the area it encloses.
base::Vec3 doubled_area_vector(const model::Mesh& mesh, const std::vector<base::NodeId>& outline);

} // namespace spricka::report
