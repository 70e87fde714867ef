// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/tip_mesh.hpp"

#include "mesh/cut/crack_check.hpp"
#include "mesh/cut/placement.hpp"
#include "mesh/plane.hpp"
#include "mesh/plane_element.hpp"
#include "model/cracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Radius where the deck gives none.
double rosette_radius(const HostMesh& host, const CrackLine& line, const CrackFrame& frame,
                      std::span<const CrackLine> all) {
  std::vector<Vec2> local;
  for (const Vec3& p : line.points) {
    local.push_back(frame.rounded_local_coordinates(p).head<2>());
  }
  double room = std::min(1.0, tip_clearance_to_cracks(line, all) / frame.a);
  for (int end = 0; end < (line.embedded ? 2 : 1); ++end) {
    // (crack.16): half of the only straight part where both its ends are tips.
    const double last = (local.back() - local[local.size() - 2]).norm();
    room = std::min({room, tip_boundary_distance(host, frame, local, line.symmetric_half, line.net),
                     1.5 * last / (line.embedded && local.size() == 2 ? 2.0 : 1.0)});
    // Room is measured at the last point.
    std::reverse(local.begin(), local.end());
  }
  return radius_part * frame.a * room;
}

/// Mean length of a net's edges round a tip (crack.16b): those within the radius count most.
double net_edge_length(const HostMesh& host, base::NetId net, const Vec2& tip, double radius) {
  const model::Mesh& mesh = host.mesh();
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    if (net.valid() && mesh.element_net[i] != net) {
      continue;
    }
    const base::ElementId e(i);
    const double length = mean_side_length(mesh, e);
    const double distance = (element_centroid(mesh, e) - tip).norm();
    const double near = length * std::pow(radius * radius + distance * distance, -1.5);
    const double weight = near * near;
    sum += weight * length;
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : std::numeric_limits<double>::infinity();
}

/// How many times thicker the outermost ring of a rosette that is not made finer is than the edges
/// of the net round its tips are long (crack.16a).
double fineness_of_net(const HostMesh& host, const CrackLine& line, double radius, int rings) {
  const double ring = radius * (1.0 - 1.0 / ring_growth) / (1.0 - std::pow(ring_growth, -rings));
  double edge = net_edge_length(host, line.net, line.points.back().head<2>(), radius);
  if (line.embedded) {
    const Vec2 other = line.points.front().head<2>();
    edge = std::min(edge, net_edge_length(host, line.net, other, radius));
  }
  return rounded(ring / edge);
}

} // namespace

TipMeshParameters choose_tip_mesh(const HostMesh& host, const CrackLine& line,
                                  const model::TipMeshSettings* settings,
                                  std::span<const CrackLine> all) {
  const model::TipMeshSettings given = settings == nullptr ? model::TipMeshSettings{} : *settings;
  const CrackFrame frame = make_crack_frame(line);
  TipMeshParameters tip;
  tip.radius = given.radius ? *given.radius : rosette_radius(host, line, frame, all);
  tip.finer = given.finer;
  if (given.patch && !given.sizes_given && !given.tolerance) {
    const double of_net = fineness_of_net(host, line, tip.radius, given.rings);
    // The finer of both, not their product; below 1 FINER makes coarser what follows the net.
    tip.finer *= std::max(1.0, of_net / std::max(1.0, given.finer));
  }
  tip.rings = std::max(fewest_rings, static_cast<int>(std::lround(tip.finer * given.rings)));
  tip.sectors = std::max(fewest_sectors, static_cast<int>(std::lround(tip.finer * given.sectors)));
  tip.quarter_point = given.quarter_point;
  tip.patch = given.patch;
  tip.transition = given.join == model::PatchCoupling::transition;
  if (given.size) {
    tip.size = *given.size / tip.finer;
  } else {
    // So many times more rings over the same radius: sizes grow as before with the distance.
    const double q = std::pow(ring_growth, 1.0 / tip.finer);
    tip.size = tip.radius *
               std::max(smallest_part / tip.finer, (q - 1.0) / (std::pow(q, tip.rings) - 1.0));
  }
  return tip;
}

} // namespace spricka::mesh
