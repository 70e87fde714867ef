// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/tip_mesh.hpp"

#include "mesh/cut/crack_check.hpp"
#include "mesh/cut/placement.hpp"
#include "model/cracks.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// Rosette radius, as a part of the crack's length or of the room round its tip, and growth of its
/// rings from the tip outward.
constexpr double radius_part = 0.4;
constexpr double ring_growth = 1.5;
/// The smallest tip element, as a part of the radius: more rings than 17 grow more slowly.
constexpr double smallest_part = 5e-4;
/// What a coarse net still has: as $TIPNET allows them.
constexpr int fewest_rings = 2;
constexpr int fewest_sectors = 6;

} // namespace

TipMeshParameters choose_tip_mesh(const HostMesh& host, const CrackLine& line,
                                  const model::TipMeshSettings* settings,
                                  std::span<const CrackLine> all) {
  TipMeshParameters tip;
  const double finer = settings == nullptr ? 1.0 : settings->finer;
  if (settings != nullptr) {
    tip.rings = std::max(fewest_rings, static_cast<int>(std::lround(finer * settings->rings)));
    tip.sectors =
        std::max(fewest_sectors, static_cast<int>(std::lround(finer * settings->sectors)));
    tip.quarter_point = settings->quarter_point;
    tip.patch = settings->patch;
    tip.transition = settings->join == model::PatchCoupling::transition;
  }
  const CrackFrame frame = make_crack_frame(line);
  if (settings != nullptr && settings->radius) {
    tip.radius = *settings->radius;
  } else {
    std::vector<Vec2> local;
    for (const Vec3& p : line.points) {
      local.push_back(frame.rounded_local_coordinates(p).head<2>());
    }
    double room = std::min(1.0, tip_clearance_to_cracks(line, all) / frame.a);
    for (int end = 0; end < (line.embedded ? 2 : 1); ++end) {
      // (crack.16): half of the only straight part where both its ends are tips.
      const double last = (local.back() - local[local.size() - 2]).norm();
      room =
          std::min({room, tip_boundary_distance(host, frame, local, line.symmetric_half, line.net),
                    1.5 * last / (line.embedded && local.size() == 2 ? 2.0 : 1.0)});
      // Room is measured at the last point.
      std::reverse(local.begin(), local.end());
    }
    tip.radius = radius_part * frame.a * room;
  }
  if (settings != nullptr && settings->size) {
    tip.size = *settings->size / finer;
  } else {
    // So many times more rings over the same radius: sizes grow as before with the distance.
    const double q = std::pow(ring_growth, 1.0 / finer);
    tip.size =
        tip.radius * std::max(smallest_part / finer, (q - 1.0) / (std::pow(q, tip.rings) - 1.0));
  }
  tip.finer = finer;
  return tip;
}

} // namespace spricka::mesh
