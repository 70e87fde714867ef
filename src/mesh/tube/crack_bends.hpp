// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/tube/crack_reach.hpp"

#include <vector>

/// Where a crack that has turned is bent: lines that its faces have edges along.
namespace spricka::mesh {

struct KinkLinePoint {
  int node = -1; ///< of the net, where the line begins or ends at a mouth; else a new one:
  base::Vec3 x = base::Vec3::Zero(); ///< there
  double size = 0.0;                 ///< of elements
};
struct KinkLine {
  std::vector<KinkLinePoint> points;
  bool closed = false; ///< the first point not repeated
};

/// Lines within the loops of a crack, whose nodes are `rim`, away from its tubes; in the frame of
/// the patch.
std::vector<KinkLine> build_kink_lines(const CrackDistanceField& reach, double finer,
                                       const std::vector<int>& rim, const PatchMeshBuilder& net);

} // namespace spricka::mesh
