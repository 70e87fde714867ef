// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_sizes.hpp"

#include "mesh/plane.hpp"

namespace spricka::mesh {

using base::Vec3;

namespace {

/// Growth of sizes beside small faces of the cavity.
constexpr double growth_at_rim = 0.5;

} // namespace

SolidGrading solid_patch_grading(std::span<const PatchSolidCrack> cracks,
                                 const std::vector<std::vector<PatchTriangle>>& rims,
                                 const PatchMeshBuilder& net) {
  SolidGrading size;
  for (const PatchSolidCrack& crack : cracks) {
    for (const Tube& tube : crack.tubes) {
      for (std::size_t i = 0; i < tube.stations.size(); ++i) {
        size.add_size_source(
            {rounded(tube.stations[i].x), rounded(tube.fill_size_beside_tube(i)) / crack.finer,
             CrackDistanceField::usual_growth / crack.finer, rounded(tube.radius[i])});
      }
    }
  }
  // Faces of a finer host.
  const SolidGrading own = size;
  for (const std::vector<PatchTriangle>& rim : rims) {
    for (const PatchTriangle& t : rim) {
      const Vec3 middle =
          (net.local_position(t[0]) + net.local_position(t[1]) + net.local_position(t[2])) / 3.0;
      const double edge = ((net.local_position(t[1]) - net.local_position(t[0])).norm() +
                           (net.local_position(t[2]) - net.local_position(t[1])).norm() +
                           (net.local_position(t[0]) - net.local_position(t[2])).norm()) /
                          3.0;
      if (edge < 0.7 * own(middle)) {
        size.add_size_source({middle, edge, growth_at_rim});
      }
    }
  }
  return size;
}

} // namespace spricka::mesh
