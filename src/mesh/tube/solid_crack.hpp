// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Cracks cut into finished meshes of solids.
namespace spricka::mesh {

class NonPlanarCrackSurface;

/// A crack in space of one size, before it is cut: what its front encloses of a plane, inside the
/// body, or of what it has made of that plane as it turned. Where the front leaves the body the
/// crack has a mouth.
struct SolidCrack {
  base::CrackId crack;
  base::NetId net;
  base::Vec3 normal = base::Vec3::UnitZ(); ///< b, unit; of one that has turned that of its plane
  /// Dense points of the front in the order of t = m x b, m pointing out of the crack. A closed one
  /// (first point not repeated) may lie partly outside of the body: the arcs inside are fronts. An
  /// open one starts and ends outside or on the surface.
  std::vector<base::Vec3> front;
  bool closed = true;
  std::string name;                                         ///< for messages
  std::shared_ptr<const NonPlanarCrackSurface> relief = {}; ///< of one that has turned
  /// The middle of an ellipse. Parts of the body that it lies in or at have the crack; with none of
  /// them all that the ellipse reaches.
  std::optional<base::Vec3> middle = {};

  /// The crack's normals b at points of its front.
  [[nodiscard]] std::vector<base::Vec3> normals_at(const std::vector<base::Vec3>& points) const;

  [[nodiscard]] std::string display_name() const;
};

/// How to mesh round a front; what is 0 follows the front (lengths in deck units).
struct TubeMeshParameters {
  double radius = 0.0; ///< of the tube
  double size = 0.0;   ///< radial length of the elements at the front
  double length = 0.0; ///< of elements along the front
  int rings = 3;       ///< rings of elements in the tube, that at the front included
  int sectors = 8;     ///< of a full circle
  bool quarter_point = true;
  bool tube = true;   ///< false: tetrahedra with the front as edges; `radius` is that of even sizes
  double finer = 1.0; ///< divides all sizes, and their growth with the distance outside the tube
};

} // namespace spricka::mesh
