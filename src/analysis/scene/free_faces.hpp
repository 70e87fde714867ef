// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

/// K below the closing of a crack. Where its faces touch, K1 at the tip is 0; the laws that know
/// R < 0 mean the K that goes on below 0 with the load, as if the faces could overlap.
namespace spricka::analysis {

/// Whether the law of $GROW knows R < 0 and cracks have faces that may touch.
bool continues_K_below_closing(const model::Model& model);

/// K of a state of the cracks whose faces may overlap, all other contacts as the deck has them.
struct OverlappingFaceResults {
  std::vector<std::vector<results::FrontResult>> steps; ///< [step] tips
  std::vector<results::LoadPathResult> paths;           ///< [load path]
};

/// Of a tip at a step; null: there is none.
const results::FrontResult*
find_tip_overlap_result(const std::optional<OverlappingFaceResults>& free, std::size_t step,
                        const std::string& name);

/// K on a load path with `free` in its place where that is below 0. Empty: `free` does not reach as
/// far as `to`.
std::optional<base::PiecewiseLinear>
continue_K_with_overlapping_faces(const base::PiecewiseLinear& K, const base::PiecewiseLinear& free,
                                  double to);

} // namespace spricka::analysis
