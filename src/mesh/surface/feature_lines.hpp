// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/new_surface.hpp"
#include "mesh/surface/region_patches.hpp"

#include <map>
#include <set>
#include <vector>

namespace spricka::mesh {

/// A point of the new surface on an edge of the old one.
struct FeatureEdgePoint {
  double t = 0.0;
  int point = -1;
};

/// Feature edges inside a region divided anew, and the rim as it is: which points lie on which
/// edges and nodes of the host. Adds points and edges to `out`.
class FeatureLines {
public:
  /// `crossings`: points that must be there, by edge.
  FeatureLines(const SurfaceGeometry& surface, const SmoothSurfacePatches& patches,
               const SizeFunction& size,
               std::map<std::size_t, std::vector<FeatureEdgePoint>> crossings,
               RemeshedSurface& out);

  /// The point on a node of the host, -1 if there is none.
  [[nodiscard]] int point_at_node(base::NodeId node) const;
  /// The points on an edge, between its ends, t ascending.
  [[nodiscard]] const std::vector<FeatureEdgePoint>& points_on_edge(std::size_t edge) const;

private:
  struct Chain;
  void add_rim();
  void take_nodes();
  void add_ends_of_lines(std::set<base::NodeId>& stops) const;
  void divide(const FeatureChain& feature);
  int point_at(const Chain& chain, double s);
  int point_on_node(base::NodeId node, const SurfacePlace& place);

  const SurfaceGeometry& surface_;
  const SmoothSurfacePatches& patches_;
  const SizeFunction& size_;
  std::map<std::size_t, std::vector<FeatureEdgePoint>> on_edge_;
  std::map<base::NodeId, int> on_node_;
  RemeshedSurface& out_;
};

} // namespace spricka::mesh
