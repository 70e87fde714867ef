// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_trace.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

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

} // namespace spricka::mesh
