// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/host.hpp"

#include <limits>

namespace spricka::mesh {

/// Where a crack starts: on a boundary edge of the host, at a node of it if `node` is valid.
struct MouthPosition {
  model::Face face;
  double xi = 0.0;
  base::NodeId node;
};

/// The boundary point nearest to the start of a crack, or to any other point.
struct NearestMouth {
  MouthPosition mouth;
  base::Vec3 at = base::Vec3::Zero();
  double distance = std::numeric_limits<double>::max();
  double chord = 0.0; ///< of the edge it lies on; 0: the net has no boundary

  /// Whether the crack starts on the boundary: so near to it, as a part of the edge there, that
  /// arcs, which the host's curves approximate, do not matter.
  [[nodiscard]] bool on_boundary() const {
    constexpr double near = 1e-3;
    return distance <= near * chord;
  }
};
/// On the boundary of a net (any net: invalid); at a node where one is there.
NearestMouth find_crack_mouth(const HostMesh& host, const base::Vec3& start, base::NetId net);

/// The element of a net (any net: invalid) that a point lies in, or an invalid one.
base::ElementId find_element_at(const model::Mesh& mesh, const base::Vec3& point, base::NetId net);

/// Where the first point of a free crack lies: on the boundary of the net (any net if invalid),
/// inside it, or neither.
enum class CrackStartLocation { boundary, inside, outside };
CrackStartLocation locate_crack_start(const HostMesh& host, const base::Vec3& point,
                                      base::NetId net);

} // namespace spricka::mesh
