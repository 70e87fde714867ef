// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_warnings.hpp"
#include "analysis/lengths/load_history.hpp"
#include "analysis/lengths/place_on_front.hpp"
#include "analysis/scene/free_faces.hpp"
#include "base/outcome.hpp"
#include "growth/ahead.hpp"
#include "growth/growth_integrator.hpp"
#include "life/growth_law.hpp"
#include "life/load_interaction.hpp"
#include "life/spectrum.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// The law of $GROW; K and lengths in deck units.
life::GrowthRateLaw growth_law(const model::CrackGrowthSettings& growth);

/// A solved state of the cracks.
struct SolvedCrackState {
  const results::CrackLengthResult& increment;
  const std::vector<mesh::CrackFront>& fronts;
  const std::vector<double>& plastic; ///< [front] in space, of the section before it, or empty
  const growth::CrackGeometry& cracks;
  const std::optional<LoadHistoryKResult>& followed; ///< where friction makes K a history
  const std::optional<OverlappingFaceResults>& free; ///< faces that may overlap, where they close
  const results::LoadPathResult* path;               ///< growth_load_path()
};

/// A tip that grows, and the place of a front where its K is taken.
struct GrowingPlace {
  std::string name;                    ///< of the tip
  std::string front;                   ///< its crack, in the plane the tip
  base::Vec3 aim = base::Vec3::Zero(); ///< in space: the place is the nearest to it
  bool straight = false;               ///< it cannot turn, on a line of symmetry
  model::PlaceOnCrack on_crack = {};   ///< where the law is asked
};

/// The step of the largest load of the growth: KMAX, or the end of the spectrum's load path.
std::size_t largest_load_step(const model::Model& model);

/// The load path of the growth's spectrum. Null: no spectrum, or there is no map of K.
const results::LoadPathResult* growth_load_path(const model::Model& model,
                                                const results::CrackLengthResult& increment);

/// Where K1 on a path is largest between two places: at one of them or at a breakpoint.
double locate_K1_maximum(const base::PiecewiseLinear& K1, double low, double high);

/// Sets the turn of a tip and gives the K to the law: factors of K1 and K2 of the crack before the
/// turn.
base::Vec2 kink_tip_and_get_K_factors(const model::Model& model, const base::Vec2& K, bool straight,
                                      growth::TipStation& found);

/// What a solved state of the cracks means for their growth: K at the largest and the smallest
/// load, the way on, the rate.
class GrowthRateEvaluator {
public:
  explicit GrowthRateEvaluator(const model::Model& model);

  /// By tip, whose lengths are `extents`. Empty: `trouble` says why there is no growth to be told.
  [[nodiscard]] std::optional<std::vector<growth::TipStation>>
  evaluate_tip_rates(const SolvedCrackState& at, const std::vector<growth::TrackedTip>& growing,
                     const std::vector<double>& extents);

  [[nodiscard]] const base::OptionalFailure& trouble() const { return trouble_; }
  /// Whether of the last state K at KMIN was above K at KMAX, and above 0, at all tips that grow.
  [[nodiscard]] bool is_load_reversed() const { return upside_down_; }
  /// What a reader must not miss.
  [[nodiscard]] GrowthWarnings& warnings() { return warnings_; }
  [[nodiscard]] const life::GrowthRateLaw& law() const { return law_; }
  [[nodiscard]] const std::optional<life::CountedSpectrum>& spectrum() const { return spectrum_; }
  [[nodiscard]] bool counts_cycles_on_K() const { return counted_on_K_; }
  /// da of one pass of the spectrum whose K over the load path is `K`: once it is like the one
  /// before where cycles act on each other [length].
  [[nodiscard]] double growth_per_pass(const base::PiecewiseLinear& K,
                                       const model::PlaceOnCrack& place) const;
  /// Rates between stations by K there; empty where those of the stations have to do: of a spectrum
  /// of very many different cycles, of one whose cycles act on each other, and with friction.
  [[nodiscard]] growth::GrowthRateFunction rates_between_stations() const;
  /// How the cycles of the spectrum act on each other; empty: they do not.
  [[nodiscard]] const std::optional<life::LoadInteraction>& interaction() const {
    return interaction_;
  }

  /// What it remembers of earlier states, as arrays "growth..." for a restart file.
  void save_state(results::NamedArrays& arrays) const {
    warnings_.save_state(arrays);
    arrays.integers["growth.counted_on_K"] = {counted_on_K_ ? 1 : 0};
  }
  /// Back from a restart file. Throws base::CorruptStoredField where an array is missing.
  void restore_state(const results::NamedArrays& arrays) {
    warnings_.restore_state(arrays);
    counted_on_K_ = results::required_array(arrays.integers, "growth.counted_on_K", 1)[0] != 0;
  }

private:
  /// Says why a state has no rate; false.
  bool no_rate(std::string why);
  bool evaluate_place(const SolvedCrackState& at, GrowingPlace to, growth::TipStation& found);
  /// What K along a front in space at KMAX means, however the law is given it.
  void look_at_front(const SolvedCrackState& at, const GrowingPlace& to, const PlaceOnFront& place,
                     growth::TipStation& found);
  bool by_steps(const SolvedCrackState& at, const GrowingPlace& to, const PlaceOnFront& place,
                growth::TipStation& found);
  bool by_spectrum(const SolvedCrackState& at, const GrowingPlace& to, growth::TipStation& found);
  bool by_history(const SolvedCrackState& at, const GrowingPlace& to, const PlaceOnFront& place,
                  growth::TipStation& found);
  /// K over the path, of which nothing but the loads of the spectrum is kept if those are fewer.
  [[nodiscard]] base::PiecewiseLinear at_loads_of_spectrum(base::PiecewiseLinear K) const;
  /// K at a place on the path of the spectrum, with what the law wants where the faces close.
  [[nodiscard]] base::PiecewiseLinear on_path(const SolvedCrackState& at,
                                              const results::LoadPathFront& front,
                                              const PlaceOnFront& place, const base::Vec2& part);
  /// K_min by a place at KMIN; `part` of its K1 and K2 counts.
  [[nodiscard]] double at_smallest(const SolvedCrackState& at, const GrowingPlace& to,
                                   const base::Vec2& part, const results::FrontResult& front,
                                   const PlaceOnFront& place);
  /// Warns of a cycle that a threshold of another R holds back.
  void look_at_threshold(const GrowingPlace& to, double K_max, double K_min);
  /// Warns where K at KMIN is larger than at KMAX, which all tips together may not have.
  void note_order(const std::string& name, bool upside_down);
  /// K1 and K2 of a place at the end of a step, corrected where the law is to have that.
  [[nodiscard]] base::Vec2 intensity(const results::FrontResult& front, const PlaceOnFront& place);

  const model::Model& model_;
  life::GrowthRateLaw law_;
  std::optional<life::CountedSpectrum> spectrum_;
  std::optional<life::LoadInteraction> interaction_; ///< the first of the deck
  std::vector<double> loads_;                        ///< of the spectrum, different ones ascending
  bool few_cycles_ = false;                          ///< different ones, of the spectrum
  growth::PlaneBoundaryAhead around_;
  base::OptionalFailure trouble_;
  bool upside_down_ = false;
  GrowthWarnings warnings_;
  bool counted_on_K_ = false;
};

} // namespace spricka::analysis
