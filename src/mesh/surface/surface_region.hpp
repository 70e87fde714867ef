// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/new_surface.hpp"
#include "mesh/surface/surface_trace.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <vector>

/// The region of a body's surface that is meshed anew: its patches, and its lines divided.
namespace spricka::mesh {

/// A side of a face on the border of a patch, as the face runs round.
struct PatchBorderSide {
  std::size_t face = nowhere;
  int side = 0;
  std::size_t edge = nowhere;
  bool rim = false; ///< to a face that is not of the region; else to another patch
};

/// A region of the surface in parts, patches, each on one smooth piece and connected.
class SmoothSurfacePatches {
public:
  SmoothSurfacePatches(const SurfaceGeometry& surface, std::span<const std::size_t> faces);

  [[nodiscard]] const SurfaceFailure& failure() const { return trouble_; }
  [[nodiscard]] std::size_t count() const { return faces_.size(); }
  /// The patch of a face of the surface; `nowhere` outside of the region.
  [[nodiscard]] std::size_t patch_containing(std::size_t face) const;
  /// Faces of a patch, by their numbers in the surface.
  [[nodiscard]] const std::vector<std::size_t>& faces(std::size_t patch) const {
    return faces_[patch];
  }
  /// Closed borders of a patch, which lies on the left seen from outside the body.
  [[nodiscard]] const std::vector<std::vector<PatchBorderSide>>&
  border_loops(std::size_t patch) const {
    return loops_[patch];
  }
  /// All faces of the region, ascending.
  [[nodiscard]] const std::vector<std::size_t>& all_faces() const { return all_; }
  /// Feature edges between two faces of the region, ascending.
  [[nodiscard]] const std::vector<std::size_t>& feature_edges() const { return features_; }
  [[nodiscard]] const std::vector<std::size_t>& rim_edges() const {
    return rim_;
  } ///< edges, ascending

private:
  void sort_edges();
  void string_loops(std::size_t patch);
  [[nodiscard]] std::size_t across(std::size_t face, int side) const;
  [[nodiscard]] PatchBorderSide side_after(const PatchBorderSide& at) const;
  [[nodiscard]] bool is_border(std::size_t face, int side) const;

  const SurfaceGeometry& surface_;
  SurfaceFailure trouble_;
  std::vector<std::size_t> all_;
  std::map<std::size_t, std::size_t> patch_; ///< of a face
  std::vector<std::vector<std::size_t>> faces_;
  std::vector<std::vector<std::vector<PatchBorderSide>>> loops_;
  std::vector<std::size_t> features_, rim_;
};

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
