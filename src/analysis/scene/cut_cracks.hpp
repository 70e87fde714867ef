// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"

#include <algorithm>
#include <optional>
#include <vector>

/// Cracks in the mesh of the deck, and the part of it that they touch.
namespace spricka::analysis {

/// The deck's mesh with these cracks in it; mistakes go to `diagnostics` and give an empty result.
std::optional<mesh::CrackedMesh> make_cracked_mesh(const model::Model& model,
                                                   const std::vector<mesh::CrackLine>& lines,
                                                   base::Diagnostics& diagnostics);

/// What stays the same for all lengths of a run.
struct CrackRegionPlan {
  std::vector<bool> region; ///< [host element] some length's cavity touches it
  bool split = false;       ///< worth condensing region and rest apart (several lengths)
  /// In space: the region is that of the patches (patch_region.hpp); empty before the first cut.
  bool follows_patches = false;

  /// Whether all of these elements [host element] are in the region.
  [[nodiscard]] bool covers(const std::vector<bool>& elements) const {
    return !region.empty() &&
           std::ranges::equal(elements, region, [](bool in, bool own) { return !in || own; });
  }
};

/// The region of the host that the cracks of all lengths touch.
CrackRegionPlan plan_crack_region(const model::Model& model, const std::vector<double>& lengths,
                                  base::Diagnostics& diagnostics);

/// Adds what these cracks touch.
void add_to_crack_region(const model::Model& model, const std::vector<mesh::CrackLine>& lines,
                         CrackRegionPlan& plan);

} // namespace spricka::analysis
