// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <string>
#include <vector>

/// Plane meshes that stand for solids: bodies that are the same all along an axis, or round it.
namespace spricka::sense {

/// Where a solid is cut, and where its places lie in the section.
struct SectionPlane {
  bool round = false; ///< about the axis, which runs through the origin; else along it
  int axis = 2;
  double first = 0.0; ///< the section lies there: coordinate [length], or angle [rad]
  double last = 0.0;  ///< the bodies end there
  double reach = 0.0; ///< what is nearer to the axis of a round one lies on it [length]

  /// Thickness [length], or the angle that the solid takes of a whole turn [rad].
  [[nodiscard]] double depth() const { return last - first; }
  /// The direction of space that is x (0) or y (1) of the section; along an axis right-handed.
  [[nodiscard]] int direction(int d) const;
  /// A place of space in the section: along the axis the other two coordinates, about it the radius
  /// and the height.
  [[nodiscard]] base::Vec3 place(const base::Vec3& x) const;
  /// The place of space that lies there at a coordinate or an angle.
  [[nodiscard]] base::Vec3 in_space(const base::Vec3& place, double along) const;
  /// Coordinate or angle of a place, from -pi to pi.
  [[nodiscard]] double along(const base::Vec3& x) const;
  /// The unit direction in which it grows; zero on the axis of a round one.
  [[nodiscard]] base::Vec3 normal(const base::Vec3& x) const;
};

struct Section {
  SectionPlane plane;
  /// Of the plane: nodes, elements, labels, nets and properties of the solid's faces there; sets
  /// under their old numbers, those that do not reach the section are empty.
  model::Mesh mesh;
  /// [face set] Whether it takes the whole thickness or angle, and none of the flat faces.
  std::vector<bool> whole;
};

/// Sections of bodies that are the same along z, y or x from one flat face to another, all with the
/// same thickness: of a block three, mostly one or none.
std::vector<Section> extruded_sections(const model::Mesh& mesh);

/// Sections of bodies that are sectors of one angle about z, y or x through the origin.
std::vector<Section> round_sections(const model::Mesh& mesh);

/// The nodes of the section behind which (along the axis, or round it) nodes of space lie.
std::vector<base::NodeId> nodes_before(const Section& section, const model::Mesh& space,
                                       const std::vector<base::NodeId>& nodes);

/// Where the line from a place inside of a net (any net: invalid) leaves the net first; empty:
/// nowhere.
std::optional<base::Vec3> way_out(const model::Mesh& section, base::NetId net,
                                  const base::Vec3& from, const base::Vec3& through);

} // namespace spricka::sense
