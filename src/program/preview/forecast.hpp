// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "results/preview.hpp"
#include "solve/rate.hpp"

#include <map>
#include <string>
#include <vector>

namespace spricka::program {

/// How a cost is foretold.
struct ForecastSettings {
  int threads = 1; ///< of the run
  solve::FlopRate rate;
  bool exact = false;           ///< by the symbolic analysis; else by the law of solve::NetOutline
  bool several_lengths = false; ///< nets may be found again at a later one
};

/// Foretells memory and time of a run, length by length. By the symbolic analysis of the very nets
/// that the run would factorise fill and flops are exact, and analysis takes as long as it took
/// here, stiffness as that of a sample of elements; by the law no matrix is made, and both go by
/// the numbers of unknowns and elements. Memory adds up what the run keeps and its largest passing
/// need on top of what this process holds now. Time: flops at the rate that dense products reach in
/// blocks of the factor's size, and everything else as multiples of the stiffness.
class CostForecast {
public:
  CostForecast(const model::Model& model, const ForecastSettings& settings)
      : model_(model), settings_(settings) {}

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
  static std::string describe_engine(const NetToForecast& piece, const solve::FactorReport& report);
  static std::vector<solve::CondensedNetBlock>
  blocks_of(const NetToForecast& piece, std::vector<std::vector<std::int32_t>>& freedoms);
  solve::FactorReport analyse(const analysis::CondensationRequest& request,
                              const NetToForecast& piece);
  solve::FactorReport estimate(const analysis::CondensationRequest& request,
                               const NetToForecast& piece);
  const solve::FactorReport& report_of(const analysis::CondensationRequest& request,
                                       const NetToForecast& piece, Needs& needs);
  [[nodiscard]] std::vector<analysis::SubstructureHashes>
  keys_of(const analysis::CondensationRequest& request,
          const std::vector<analysis::SubstructuredBody>& bodies) const;
  [[nodiscard]] double contact_flops(const std::vector<analysis::SubstructuredBody>& bodies,
                                     const analysis::Discretisation& scene) const;

  const model::Model& model_;
  ForecastSettings settings_;
  std::map<analysis::HashKey, solve::FactorReport> known_;
  std::map<analysis::HashKey, solve::EarlyLateRowPartition>
      early_;                    ///< by the part they are rows of
  double element_seconds_ = 0.0; ///< stiffness of one element of the first net
  double kept_results_ = 0.0;    ///< [bytes] of the lengths so far
  double kept_modes_ = 0.0;      ///< [bytes] matrices that the last length leaves for the next
  double resident_ = 0.0;        ///< [bytes] of the process when the first length came
};

} // namespace spricka::program
