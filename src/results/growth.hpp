// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/law_use.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Growth of cracks by a law: lengths over cycles.
namespace spricka::results {

/// A point of a front that grows, at a station; in the plane the tip, in space an end of an axis
/// too.
struct GrownPointResult {
  std::string name; ///< as FrontResult
  /// What lies behind the tip: its crack's first length (half of it if embedded) and all it has
  /// grown since; the two arms of an embedded crack grow apart.
  double a = 0.0;
  double K_max = 0.0;  ///< what the law was given: K1, or of a crack that turns the K1 after the
  double K_min = 0.0;  ///< kink; of a spectrum the extremes of a pass [stress * length^0.5]
  double K2_max = 0.0; ///< K2 at the largest load, before a kink
  double rate = 0.0;   ///< growth per cycle, or per pass of the spectrum; 0: below the threshold
  double turn = 0.0;   ///< the way on against the last part of the crack [rad], left positive
  base::Vec3 x = base::Vec3::Zero();
  /// Where friction makes K a history: K_max and K_min of its first cycle or pass; else 0.
  double first_max = 0.0, first_min = 0.0;
};

/// One finite-element solution of the growth.
struct GrowthStation {
  int increment = 0;                    ///< CrackLengthResult::number
  double cycles = 0.0;                  ///< or passes
  std::vector<GrownPointResult> points; ///< of all fronts
  int passes = 0;      ///< of the loads, where friction makes K a history, until K repeated itself
  double change = 0.0; ///< of K from the last pass but one to the last, over the largest K
};

/// A point of the dense curve between and at the stations.
struct LifeCurvePoint {
  double cycles = 0.0;
  std::vector<double> a; ///< [point] as point_names
};

/// The same growth counted otherwise: with K taken from a line instead of from every load, or with
/// other rules of how cycles act on each other.
struct ComparedLife {
  std::string name;   ///< short: "scaled", "line", or the card of the interaction
  std::string what;   ///< in words
  double ratio = 0.0; ///< its cycles over those of the growth, from the first to the last a
  std::vector<LifeCurvePoint> curve; ///< of one tip
};

/// Cycles of a spectrum whose peak, or range, lies from `low` to `high` [t of the load path].
struct SpectrumLevel {
  double low = 0.0, high = 0.0;
  double cycles = 0.0;  ///< of a pass
  double reached = 0.0; ///< cycles of this level and of all above it
  double crossed = 0.0; ///< of peaks: how often the load of a pass rises through `low`
  double growth = 0.0;  ///< part of the growth that these cycles make; not a number: unknown
  double life = 0.0;    ///< the same of the life
};

/// A life by the same K of the same stations, with another reading of the spectrum.
struct OtherSpectrumLife {
  std::string name; ///< "COUNT=PAIRS", "without CLIP"
  double cycles_per_pass = 0.0;
  std::optional<double> ratio; ///< its passes over those of the spectrum; empty: unknown
};

/// What a spectrum consists of, without interaction of its cycles.
struct SpectrumParts {
  std::vector<SpectrumLevel> peaks, ranges; ///< the highest first
  std::vector<OtherSpectrumLife> others;
};

/// Names of lives by one K that is scaled with the load, and by a line of K over a load path.
inline constexpr std::string_view life_of_scaled_K = "scaled";
inline constexpr std::string_view life_by_line_of_K = "line";

struct GrowthResult {
  std::string unit;                     ///< of N and per what the rates are: "cycle" or "pass"
  double cycles_per_pass = 1.0;         ///< of a spectrum
  std::vector<std::string> point_names; ///< of those that grow, in the order of all lists
  std::vector<GrowthStation> stations;
  std::vector<LifeCurvePoint> curve; ///< ascending cycles, ends at the end of the growth
  std::string ended;                 ///< one word: AMAX, CYCLES, KC, NET SECTION, EDGE, ...
  std::string reason;                ///< the same in a sentence, with the place
  /// In space: where fronts have gone through surfaces on the way, sentences.
  std::vector<std::string> passages;
  double error = 0.0;     ///< of the cycles, estimated, as a part of them
  bool corrected = false; ///< the law was given K without its estimated error where it has a bar
  std::string counted;    ///< of a spectrum: what its cycles were counted on
  /// Of a spectrum's pass: ranges of the load path's t, falling, and how many of its cycles,
  /// counted by rainflow on the loads, are as large or larger; of very many the ones that tell.
  std::vector<std::array<double, 2>> ranges;
  model::LawUse law_use = {}; ///< of all points and lengths, by their cycles
  SpectrumParts spectrum_parts;
  /// Of a spectrum whose life is told in these: "flights", "hours", "cycles"; else empty.
  std::string life_unit;
  double life_units_per_pass = 1.0;
  bool followed = false; ///< friction makes K a history, which was followed
  /// How the cycles of a spectrum act on each other, sentences; empty: they do not.
  std::vector<std::string> interaction;
  std::vector<ComparedLife> compared;

  [[nodiscard]] double final_cycles() const { return curve.empty() ? 0.0 : curve.back().cycles; }
  /// Passes in life_unit.
  [[nodiscard]] double in_life_unit(double N) const { return N * life_units_per_pass; }
};

/// Cycles until point `point` of the list has length `a` [length]; not a number outside the curve.
double cycles_at_length(const GrowthResult& growth, std::size_t point, double a);

} // namespace spricka::results
