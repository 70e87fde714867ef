// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/constraint.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Rigid motions by which surfaces slide on themselves: a round shaft that turns, a flange in its
/// plane, a ball about its centre. No pressure resists them, however inexactly the nodes lie on
/// their cylinder and the normals of a pair, which are those of one side, know the axis of the
/// other.
namespace spricka::contact {

/// A node of a surface and the outer normal that the shape of its part has there.
struct SurfaceNodeNormal {
  base::NodeId node;
  base::Vec3 normal = base::Vec3::Zero();
};
/// The nodes of a surface, face by face.
std::vector<SurfaceNodeNormal> surface_node_normals(const ContactSurface& surface);

/// The normal rows of one contact and the surfaces that they keep apart.
struct ContactRowSurfaces {
  std::size_t first = 0;                                 ///< of its rows among all
  std::vector<double> area;                              ///< [row of the contact]
  std::array<std::vector<SurfaceNodeNormal>, 2> surface; ///< of either side; empty if rigid
};

/// The free rigid modes of the body that a node belongs to, at that node [dim, its modes].
struct RigidModesAtNode {
  std::size_t body = 0;
  base::Matrix motion;
};
using RigidModesLookup = std::function<std::optional<RigidModesAtNode>(base::NodeId)>;

/// Takes from B [row, mode], what a unit of each rigid mode opens, all that motions open by which
/// the surface of a body slides on itself within 1e-4 (root mean square of what its points move
/// along their normals over that of what they move). `first_mode` [body + 1].
void remove_self_sliding_openings(const std::vector<ContactRowSurfaces>& contacts,
                                  const std::vector<Eigen::Index>& first_mode,
                                  const RigidModesLookup& modes_at, base::Matrix& B);

} // namespace spricka::contact
