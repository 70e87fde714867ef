// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/cut_cracks.hpp"
#include "growth/growth_integrator.hpp"
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// The part of the host that is condensed again at every station: what the cracks are going to
/// touch. Where a crack leaves it a new one is chosen, and what that costs is told. In the plane it
/// is chosen before a cut, in space by the cut itself, which the plan follows.
class RecondensedGrowthRegion {
public:
  explicit RecondensedGrowthRegion(const model::Model& model);

  /// In the plane, before these cracks are solved: are they still within?
  void update_region(const std::vector<mesh::CrackLine>& lines,
                     const growth::GrowthIntegrator& integrator,
                     std::vector<results::LogLine>& log);
  /// Behind a solution, of bodies that were `divided` into region and rest or were not: what was
  /// chosen for it and what that cost, where it was, in the log.
  void log_region_cost(bool divided, std::vector<results::LogLine>& log);

  [[nodiscard]] CrackRegionPlan& crack_region_plan() { return plan_; }

  /// As arrays for a restart file, and back from there.
  void save_state(results::NamedArrays& arrays) const;
  /// Back from a restart file; nothing without such arrays. Throws base::CorruptStoredField for a
  /// region of another mesh.
  void restore_state(const results::NamedArrays& arrays);

private:
  void choose(const std::vector<mesh::CrackLine>& lines,
              const growth::GrowthIntegrator& integrator);
  void log_choice(bool first, std::vector<results::LogLine>& log) const;

  const model::Model& model_;
  CrackRegionPlan plan_;
  double usual_ = 0.0;       ///< [s] to condense within a region
  bool renewed_ = false;     ///< the next solution pays for it
  std::vector<bool> before_; ///< the region of the last solution, where the plan follows patches
};

} // namespace spricka::analysis
