// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/cut_cracks.hpp"
#include "growth/growth_integrator.hpp"
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// The part of the host that is condensed again at every station: what the cracks are going to
/// touch. Where a crack leaves it a new one is chosen, and what that costs is told.
class RecondensedGrowthRegion {
public:
  explicit RecondensedGrowthRegion(const model::Model& model) : model_(model) {}

  /// Before these cracks are solved: are they still within?
  void update_region(const std::vector<mesh::CrackLine>& lines,
                     const growth::GrowthIntegrator& integrator,
                     std::vector<results::LogLine>& log);
  /// Behind the solution that came after a new choice: its line in the log.
  void log_region_cost(std::vector<results::LogLine>& log);

  [[nodiscard]] const CrackRegionPlan& crack_region_plan() const { return plan_; }

  /// As arrays for a restart file, and back from there.
  void save_state(results::NamedArrays& arrays) const;
  /// Back from a restart file; nothing without such arrays. Throws base::CorruptStoredField for a
  /// region of another mesh.
  void restore_state(const results::NamedArrays& arrays);

private:
  void choose(const std::vector<mesh::CrackLine>& lines,
              const growth::GrowthIntegrator& integrator);

  const model::Model& model_;
  CrackRegionPlan plan_;
  double usual_ = 0.0;   ///< [s] to condense within a region
  bool renewed_ = false; ///< the next solution pays for it
};

} // namespace spricka::analysis
