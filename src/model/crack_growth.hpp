// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How cracks grow: the law, the direction and what stops them.
namespace spricka::model {

/// What gives the growth of a crack in one load cycle; equations in manual/theory/life.md.
enum class CrackGrowthLaw {
  increment, ///< none: the lengths are given
  paris,     ///< (life.3)
  walker,    ///< (life.4)
  forman,    ///< (life.5)
  nasgro,    ///< (life.6)
  table,     ///< (life.9)
  hartman    ///< (life.28)
};
/// As a deck names them, in the order of CrackGrowthLaw.
inline constexpr std::array<std::string_view, 7> growth_law_words{
    "INCREMENT", "PARIS", "WALKER", "FORMAN", "NASGRO", "TABLE", "HARTMAN"};
/// What Walker's law makes of R < 0: nothing of K below 0, all of delta K with an exponent of its
/// own, or the law's own power of K_max (life.29).
enum class NegativeRatioRule { positive_part, whole_range, K_max };
enum class GrowthDirection { path, hoop, k2_zero };
/// In space: fronts as K shapes them, or held to ellipses.
enum class FrontShapeRule { ellipse, free };
enum class SlipHistoryOverGrowth { restart, carry_on };
enum class ContactMountingPolicy { each, first };

/// The threshold of delta K over R and the length of the crack (life.25). Lengths in the units of
/// the deck.
struct ThresholdOverRatio {
  double delta_k = 0.0;       ///< of long cracks, at R = 0 or for R to 1 [stress intensity]
  bool at_zero_ratio = false; ///< delta_k is that at R = 0
  double slope_above = 0.0;   ///< C_th+, for R >= 0
  double slope_below = 0.0;   ///< C_th-, for R < 0
  double intrinsic_length = 0.0;
  double largest_ratio = 0.7; ///< above it the threshold stays what it is there
};

/// Where on a crack a law is asked.
struct PlaceOnCrack {
  double a = std::numeric_limits<double>::infinity(); ///< length there; a long crack [length]
  std::optional<double> toughness = std::nullopt; ///< in place of the law's own [stress intensity]
};

/// Constants of a growth law. C and the table count K in `k_unit` and lengths in `a_unit`;
/// threshold and toughness are in the units of the deck.
struct GrowthLawConstants {
  double C = 0.0;
  double m = 0.0;
  double p = 0.0;            ///< Walker: gamma; NASGRO: exponent of the threshold term
  double q = 0.0;            ///< NASGRO: exponent of the toughness term
  double alpha = 2.0;        ///< NASGRO: constraint factor, 1 plane stress to 3 plane strain
  double stress_ratio = 0.3; ///< NASGRO: largest stress over flow stress
  double threshold = 0.0;    ///< of delta K, one for all R [stress intensity]
  std::optional<ThresholdOverRatio> threshold_over_ratio;                 ///< in its place
  NegativeRatioRule at_negative_ratio = NegativeRatioRule::positive_part; ///< Walker
  double p_below = 0.0; ///< Walker: gamma for R < 0 of the whole range
  /// Toughness of surface and corner cracks in its place [stress intensity].
  std::optional<double> k_part_through;
  std::optional<double> k_c; ///< fracture toughness [stress intensity]; Forman and NASGRO need it
  double k_unit = 1.0;       ///< one unit of K of the constants [stress intensity]
  double a_unit = 1.0;       ///< one unit of length of the constants [length]
  /// Table: ascending, in k_unit; over several R those of the first, then of the next ..
  std::vector<double> delta_k;
  std::vector<double> growth; ///< table: da/dN > 0 of each row, in a_unit per cycle
  /// Table over several R, ascending; its rates ascend, too. Empty: its rows hold for all R.
  std::vector<double> table_ratios;
};

/// Toughness over the thickness of a part (life.27).
struct ToughnessOverThickness {
  double plane_strain = 0.0; ///< K_1c [stress intensity]
  double A_k = 0.0;
  double B_k = 0.0;
  double yield = 0.0; ///< [stress]
};

/// What is known of the tests behind a law; empty: not stated.
struct GrowthLawData {
  std::string name;  ///< of the $LAW; empty: the constants stand on $GROW
  std::string place; ///< where it was found: "the deck"
  std::string source;
  std::string form; ///< of the material: "sheet"
  std::string orientation;
  std::string environment;
  std::optional<double> thickness;       ///< that the toughness is for [length]
  std::optional<double> lowest_delta_k;  ///< [stress intensity]
  std::optional<double> highest_delta_k; ///< [stress intensity]
  std::optional<double> lowest_ratio;    ///< R
  std::optional<double> highest_ratio;   ///< R
  std::optional<double> scatter;         ///< standard deviation of ln C
};

/// A growth law by name.
struct GrowthLawDefinition {
  CrackGrowthLaw law = CrackGrowthLaw::paris;
  GrowthLawConstants constants;
  std::optional<ToughnessOverThickness> toughness; ///< of constants.k_c
  GrowthLawData data;
};

struct CrackGrowthSettings {
  CrackGrowthLaw law = CrackGrowthLaw::increment;
  GrowthDirection direction = GrowthDirection::path;
  FrontShapeRule shape = FrontShapeRule::free;
  std::vector<base::CrackId> cracks; ///< empty: all
  base::StepId kmax;
  base::StepId kmin;
  std::optional<std::size_t> spectrum; ///< of Model::spectra, in place of the two steps
  /// How its cycles act on each other: of Model::interactions, empty entries are none. The first
  /// one counts.
  std::vector<std::optional<std::size_t>> interactions;
  SlipHistoryOverGrowth history = SlipHistoryOverGrowth::restart;
  ContactMountingPolicy mounted = ContactMountingPolicy::each;
  std::vector<double> lengths; ///< law increment [length]
  GrowthLawConstants constants;
  GrowthLawData data;
  std::optional<double> largest_advance; ///< of an increment [length]
  std::optional<double> last_length;     ///< stops the growth [length]
  std::optional<double> cycles;          ///< stops the growth; passes of a spectrum
  double tolerance = 1e-3;               ///< of the cycles, as a part of them
  std::optional<double> flow_stress;     ///< of the ligament, whose plastic limit stops the growth
  bool corrected = true;                 ///< K without its estimated error, where it has one
  bool correction_wanted = false;        ///< the deck says so: to be told where it is not possible
  base::SourceSpan span;

  /// Whether the law counts R < 0 as it is, and needs a K_min below 0.
  [[nodiscard]] bool knows_negative_ratio() const {
    return law == CrackGrowthLaw::nasgro || law == CrackGrowthLaw::walker ||
           (!constants.table_ratios.empty() && constants.table_ratios.front() < 0.0);
  }
  /// Whether a crack is one of those that grow.
  [[nodiscard]] bool grows(base::CrackId crack) const {
    return cracks.empty() || std::ranges::find(cracks, crack) != cracks.end();
  }
};

} // namespace spricka::model
