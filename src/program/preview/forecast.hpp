// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "results/preview.hpp"
#include "solve/rate.hpp"

#include <map>
#include <vector>

namespace spricka::program {

/// Foretells memory and time of a run, length by length, from the symbolic analysis of the very
/// nets that the run would factorise. Fill and flops are exact. Memory adds up what the run keeps
/// and its largest passing need on top of what this process holds now. Time: flops at the rate that
/// dense products reach in blocks of the factor's size, analysis as long as it took here, the
/// stiffness of a sample of elements, and everything else as multiples of that.
class CostForecast {
public:
  CostForecast(const model::Model& model, int threads, const solve::FlopRate& rate)
      : model_(model), threads_(threads), rate_(rate) {}

  /// Fills unknowns, fill, flops, memory and seconds of a length. `scene_cpu` [s] is what its mesh
  /// and contact rows took. Lengths in the order of the run.
  void forecast_crack_length(const analysis::CondensationRequest& request,
                             const std::vector<analysis::SubstructuredBody>& bodies,
                             const analysis::Discretisation& scene, double scene_cpu,
                             results::CrackLengthPreview& length);

private:
  struct Needs; ///< of one length
  struct NetToForecast {
    const analysis::Substructure& net;
    const analysis::HashKey& key;
    const analysis::SubstructuredBody* body; ///< that whose region the net is; null for a part
    const analysis::HashKey* first_part;     ///< its key, if there is one
  };
  const solve::FactorReport& report_of(const analysis::CondensationRequest& request,
                                       const NetToForecast& piece, Needs& needs);
  [[nodiscard]] double contact_flops(const std::vector<analysis::SubstructuredBody>& bodies,
                                     const analysis::Discretisation& scene) const;

  const model::Model& model_;
  int threads_;
  solve::FlopRate rate_;
  std::map<analysis::HashKey, solve::FactorReport> known_;
  std::map<analysis::HashKey, solve::EarlyLateRowPartition>
      early_;                    ///< by the part they are rows of
  double element_seconds_ = 0.0; ///< stiffness of one element, measured on the first net
  double kept_results_ = 0.0;    ///< [bytes] of the lengths so far
  double kept_modes_ = 0.0;      ///< [bytes] matrices that the last length leaves for the next
  double resident_ = 0.0;        ///< [bytes] of the process when the first length came
};

} // namespace spricka::program
