// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "fe/dof_map.hpp"
#include "model/forward.hpp"
#include "results/run_profile.hpp"
#include "solve/factor_report.hpp"

#include <span>
#include <string>

/// What a profile tells of the nets of a body.
namespace spricka::analysis {

/// Elements of a part and of the region that it stands in.
struct PartAndRegionElements {
  std::span<const base::ElementId> part, region;
};
/// A part: "LUG: rest", what no crack will touch, or of a body of several nets the name of the
/// part's net, "COARSE+FINE: COARSE".
std::string substructure_name(const model::Model& model, const model::Mesh& mesh,
                              const std::string& body, const PartAndRegionElements& elements);

/// Sizes of a net that has its factor; of one condensed just now also the work.
void add_factor_sizes(const fe::DofMap& map, const solve::FactorReport& report,
                      results::NetCost& work);

} // namespace spricka::analysis
