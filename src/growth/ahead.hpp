// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spricka::growth {

/// What a tip would run into.
struct Obstacle {
  double distance = 0.0; ///< [length]
  std::string what;      ///< "edge set PLATE.XMAX", "the edge at (3, 4)", "crack C2"
};

/// A tip on its way: where it stands and where it heads to.
struct TipGrowthDirection {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 direction = base::Vec3::UnitX(); ///< unit
};

/// Edges of the host in the plane.
class PlaneBoundaryAhead {
public:
  explicit PlaneBoundaryAhead(const model::Mesh& host);

  /// The nearest edge of the crack's body straight ahead. A crack on a symmetry line runs along the
  /// edge there and meets the next one.
  [[nodiscard]] std::optional<Obstacle> edge_ahead(const mesh::CrackLine& line,
                                                   const TipGrowthDirection& tip) const;
  /// The nearest other crack, or an earlier part of its own: straight ahead, or so near to the tip
  /// on either side that the two run together. `own` is the tip's line.
  [[nodiscard]] static std::optional<Obstacle> crack_ahead(std::span<const mesh::CrackLine> lines,
                                                           std::size_t own,
                                                           const TipGrowthDirection& tip);

private:
  struct HostBoundaryEdge {
    base::Vec2 a, b;
    base::NetId net;
    model::Face face;
  };
  [[nodiscard]] std::string name_of(const HostBoundaryEdge& piece, const base::Vec2& at) const;

  const model::Mesh& host_;
  std::vector<HostBoundaryEdge> pieces_;
};

} // namespace spricka::growth
