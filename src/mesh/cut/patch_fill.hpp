// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/link/grading.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// What is left of a cavity once its rosettes are there, by corner nodes of the patch.
struct PatchContours {
  std::vector<std::vector<int>> loops;    ///< closed, region on the left
  std::vector<std::vector<int>> embedded; ///< open lines inside
};

/// Adds triangles between the contours to a patch, with all edges of these. Returns what the mesher
/// said if it failed; empty if not.
std::string triangulate_patch(PatchMeshBuilder& net, const PatchContours& contours,
                              const Grading& size);

} // namespace spricka::mesh
