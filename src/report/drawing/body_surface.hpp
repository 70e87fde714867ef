// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/picture_frame.hpp"
#include "results/results.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The outer surface of solids in a picture: facets turned to the eye, one painted over another.
namespace spricka::report {

/// So many faces are drawn at most: more make a page that is slow to show and no clearer.
inline constexpr std::size_t most_drawn_faces = 20000;

/// What of a surface is seen, and from where.
struct SurfaceViewpoint {
  PictureViewpoint eye;
  base::NetId net;                 ///< the only net to be drawn; invalid: all
  const base::Vector* u = nullptr; ///< displacements to add; null: none
  double magnify = 0.0;
};

/// A face that is turned to the eye.
struct DrawnFacet {
  const results::OuterSurfaceFace* face = nullptr;
  std::vector<DrawingPoint> outline; ///< as the eye sees it, y up [length]
  /// Parts of the outline where the surface has a kink or an end.
  std::vector<std::vector<DrawingPoint>> ridges;
  double depth = 0.0; ///< towards the eye
  double light = 1.0; ///< 0 dark to 1 bright, by its normal
};

/// The faces that are turned to the eye, the farthest first.
std::vector<DrawnFacet> facets_towards_eye(const results::CrackLengthResult& increment,
                                           const SurfaceViewpoint& view);

/// Which places of a surface the eye can see but for what stands before them.
class SurfaceSides {
public:
  SurfaceSides(const results::CrackLengthResult& increment, const PictureViewpoint& eye);
  /// Whether the place, a node of the surface or the middle of a face with this outer normal, is
  /// turned to the eye; true of places within, which have no normal.
  [[nodiscard]] bool faces_eye(const base::Vec3& x, const base::Vec3& normal) const;

private:
  base::Vec3 towards_;
  std::map<std::array<double, 3>, bool> at_node_;
};

/// The eye stands in front, to the right and above: x, -y and z point to it.
PictureViewpoint slanted_viewpoint();

/// A colour "#rrggbb" by that much light.
std::string shaded_colour(std::string_view colour, double light);

/// Arrows along the axes of the coordinates, with their letters, about a point of the drawing.
void draw_axes(SvgDrawing& svg, const PictureViewpoint& eye, DrawingPoint at);

} // namespace spricka::report
