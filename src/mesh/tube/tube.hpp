// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "mesh/front_curve.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// Tubes of elements along fronts: their sizes, and the elements.
namespace spricka::mesh {

/// Radius of the tube and length of its elements along a front, by what is there: at equal steps
/// of its length.
struct TubeSizes {
  std::vector<double> s;
  std::vector<double> radius;
  std::vector<double> length;
  std::vector<double> room; ///< distance to what the tube must not reach

  [[nodiscard]] double radius_at(double at) const;
  /// Lengths along the front at which elements begin and end, of equal number for each length
  /// wanted; of an open front at least two elements, of a closed one its end is not repeated.
  [[nodiscard]] std::vector<double> stations(bool closed) const;
  /// Elements along the front up to each of `s`.
  [[nodiscard]] std::vector<double> cumulative_element_counts() const;
  [[nodiscard]] double element_count_along_front() const {
    return cumulative_element_counts().back();
  } ///< of them in all
};

/// What limits a tube at a length along the front: distance from the surface of the body and from
/// other cracks, and how far the crack reaches backwards. And how far the ends of an open front
/// lean from the surface's normal (tangent of the angle).
struct TubeClearanceAlongFront {
  std::function<double(double)> free;
  std::function<double(double)> width;
  std::array<double, 2> lean{};
  /// Distance to where a crack that has turned is bent; empty: nowhere.
  std::function<double(double)> straight = {};
};

/// The sizes of section lengths: a tenth of the crack's width, half of the radius of curvature, 0.4
/// of the room and half of what is straight for the radius; elements as long as 0.15 and 0.25 of
/// the first two, and 0.5 to 3 radii, shorter towards the ends of an open front. Near leaning ends
/// the radius leaves room for the shear onto the surface where the front turns. Given sizes
/// (`given`, in the lengths of the curve) stand as they are, all divided by `finer`.
TubeSizes choose_tube_sizes(const FrontCurve& curve, const TubeClearanceAlongFront& room,
                            const TubeMeshParameters& given);

/// A quadrilateral with middle nodes, as a side of an element in space: corners in order, then the
/// middles of the edges that follow them.
struct TubeQuad {
  std::array<int, 4> corner{};
  std::array<int, 4> mid{};
};

/// Elements swept along a front: wedges round it, bricks round these. In the frame of its patch.
/// Angles run from the lower face of the crack through what lies ahead to the upper one, and nodes
/// of the two are distinct, but for those of the front.
struct Tube {
  struct TubeElement {
    base::ElementType type = base::ElementType::pentac15;
    std::vector<int> nodes;
  };
  struct TubeElementSide {
    std::size_t element = 0;
    int side = 0;
  };

  bool closed = true;
  /// No elements: the front alone, round which tetrahedra are as large as `size` up to `radius`.
  /// Both lines of the crack are the front.
  bool free = false;
  bool quarter_point = true; ///< of a free one
  std::vector<base::Vec3> x; ///< [node]
  std::vector<TubeElement> elements;
  std::vector<FrontFrame> stations; ///< where elements begin and end
  std::vector<double> radius;       ///< [station]
  std::vector<double> size;         ///< [station] radial length of the elements at the front
  std::vector<int> front;           ///< [station] corner nodes
  std::vector<int> front_mid;       ///< of a free one: nodes behind these
  std::vector<TubeQuad> outer;      ///< seen from outside in anticlockwise order
  /// The lines of the crack along the outside of the tube: corner nodes. [station]
  std::vector<int> upper, lower;
  std::vector<std::pair<int, int>> twins; ///< nodes of the faces, upper and lower; of the front one
  std::vector<TubeElementSide> upper_sides, lower_sides;
  /// Of an open front, for each end: sides on the surface, the corners of the outline from the
  /// crack on (lower nodes).
  struct TubeEnd {
    std::vector<TubeElementSide> sides;
    std::vector<int> corner;
  };
  std::array<TubeEnd, 2> ends;
  std::optional<base::Vec3> off_surface; ///< a place of an end that finds no surface: no tube

  /// Of the fill's elements beside it.
  [[nodiscard]] double fill_size_beside_tube(std::size_t station) const {
    return free ? size[station] : radius[station];
  }
};

/// How far a place is from the surface along a direction; empty if it finds none.
using DistanceToSurface =
    std::function<std::optional<double>(const base::Vec3& place, const base::Vec3& along)>;

/// The ends of an open tube are sheared along the front onto the surface; over three radii, or
/// three times the shear if that is more, it fades.
Tube make_tube(const FrontCurve& curve, const TubeSizes& sizes, const TubeMeshParameters& given,
               const DistanceToSurface& to_surface);

} // namespace spricka::mesh
