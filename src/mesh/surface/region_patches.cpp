// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/region_patches.hpp"

#include "base/disjoint_sets.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace spricka::mesh {

SmoothSurfacePatches::SmoothSurfacePatches(const SurfaceGeometry& surface,
                                           std::span<const std::size_t> faces)
    : surface_(surface), all_(faces.begin(), faces.end()) {
  std::ranges::sort(all_);
  all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    patch_[all_[i]] = i;
  }
  base::DisjointSets smooth(all_.size());
  for (const auto& [face, i] : patch_) {
    for (int s = 0; s < surface_.face(face).corners(); ++s) {
      const auto next = patch_.find(across(face, s));
      if (next != patch_.end() && !surface_.edges()[surface_.face_edge_index(face, s)].feature) {
        smooth.join_sets(i, next->second);
      }
    }
  }
  const base::DisjointSets::SetNumbers patches = smooth.set_numbers();
  faces_.resize(patches.count);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    patch_[all_[i]] = patches.of[i];
    faces_[patches.of[i]].push_back(all_[i]);
  }
  sort_edges();
  loops_.resize(faces_.size());
  for (std::size_t p = 0; p < faces_.size() && !trouble_; ++p) {
    string_loops(p);
  }
}

std::size_t SmoothSurfacePatches::patch_containing(std::size_t face) const {
  const auto at = patch_.find(face);
  return at == patch_.end() ? nowhere : at->second;
}

/// The face beyond a side, if there is exactly one.
std::size_t SmoothSurfacePatches::across(std::size_t face, int side) const {
  const SurfaceEdge& edge = surface_.edges()[surface_.face_edge_index(face, side)];
  return edge.count != 2 ? nowhere : edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
}

void SmoothSurfacePatches::sort_edges() {
  std::set<std::size_t> features;
  std::set<std::size_t> rim;
  for (const std::size_t face : all_) {
    for (int s = 0; s < surface_.face(face).corners(); ++s) {
      const std::size_t e = surface_.face_edge_index(face, s);
      if (surface_.edges()[e].count != 2) {
        trouble_ = {"more than two faces of the body meet in one edge",
                    surface_.place_on_edge(e, 0.0).x};
      } else if (!patch_.contains(across(face, s))) {
        rim.insert(e);
      } else if (surface_.edges()[e].feature) {
        features.insert(e);
      }
    }
  }
  features_.assign(features.begin(), features.end());
  rim_.assign(rim.begin(), rim.end());
}

bool SmoothSurfacePatches::is_border(std::size_t face, int side) const {
  const std::size_t other = across(face, side);
  return other == nowhere || patch_containing(other) != patch_containing(face);
}

/// The next side of the border: round the node at the end of this one, over the faces of the patch.
PatchBorderSide SmoothSurfacePatches::side_after(const PatchBorderSide& at) const {
  std::size_t face = at.face;
  int side = (at.side + 1) % surface_.face(face).corners();
  while (!is_border(face, side)) {
    const std::size_t e = surface_.face_edge_index(face, side);
    const SurfaceEdge& edge = surface_.edges()[e];
    const std::size_t way = edge.faces[0] == face ? 1 : 0;
    face = edge.faces[way];
    side = (edge.side[way] + 1) % surface_.face(face).corners();
  }
  return {face, side, surface_.face_edge_index(face, side), !patch_.contains(across(face, side))};
}

void SmoothSurfacePatches::string_loops(std::size_t patch) {
  std::set<std::pair<std::size_t, int>> used;
  for (const std::size_t face : faces_[patch]) {
    for (int s = 0; s < surface_.face(face).corners(); ++s) {
      if (!is_border(face, s) || used.contains({face, s})) {
        continue;
      }
      std::vector<PatchBorderSide> loop;
      PatchBorderSide at{face, s, surface_.face_edge_index(face, s),
                         !patch_.contains(across(face, s))};
      while (used.insert({at.face, at.side}).second) {
        loop.push_back(at);
        at = side_after(at);
      }
      loops_[patch].push_back(std::move(loop));
    }
  }
  if (loops_[patch].empty()) {
    trouble_ = {"the cavity takes away a closed surface",
                surface_.face(faces_[patch].front()).X.col(0)};
  }
}

} // namespace spricka::mesh
