// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <functional>
#include <map>
#include <optional>
#include <vector>

/// How nodes on the surface of a body may follow the front of a crack.
namespace spricka::crack {

class SurfaceNodeMotion {
public:
  /// Of the nodes of these sides that are in their way.
  using ObstructionTest = std::function<bool(base::NodeId, const model::Face&)>;
  SurfaceNodeMotion(const model::Mesh& mesh, const std::vector<model::Face>& sides,
                    const ObstructionTest& in_the_way);

  /// m, or where a surface is in its way m + c t along it; nothing where no c does it: the surface
  /// runs along the front, or two surfaces meet. Nodes off the sides take m.
  [[nodiscard]] std::optional<base::Vec3> admissible_motion(base::NodeId node, const base::Vec3& m,
                                                            const base::Vec3& t) const;

private:
  std::map<base::NodeId, std::vector<base::Vec3>> normals_; ///< sums of those that are nearly one
};

} // namespace spricka::crack
