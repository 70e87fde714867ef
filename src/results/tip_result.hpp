// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "base/vec.hpp"
#include "results/k_bar.hpp"
#include "results/sensitivity.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What is found at a crack tip: the record, and a row for each of its quantities, from which all
/// that shows, keeps or checks them is made (manual, new_result.md).
namespace spricka::results {

/// K of one tip at the end of one step; stresses and K in deck units.
struct TipResult {
  std::string name; ///< crack name, "C1" or "C1.2" for a second tip
  double a = 0.0;
  double K1 = 0.0;
  double K2 = 0.0;
  double G = 0.0;        ///< energy release rate [force/length]
  double G_from_K = 0.0; ///< (K1^2 + K2^2) / E'
  double T = 0.0;        ///< stress along the crack at the tip that K leaves [stress]
  double spread = 0.0;   ///< (max - min of K1 over domains) / hypot(K1, K2)
  std::optional<std::array<double, 2>> K_opening; ///< K1, K2 of the faces' opening, on request
  std::vector<double> K1_domain;
  std::array<KErrorBar, 2> bar;         ///< of K1 and K2, where `no_bar` is empty
  std::string no_bar = "not estimated"; ///< why there is no error bar; empty: there is one
  bool closed = false;                  ///< its crack's faces touch at the tip, so that K1 is 0
  std::string invalid_reason;           ///< why this K is not an answer; empty: it is one
  bool two_materials = false;           ///< on both sides of the crack: G only, K and T are 0
  TipSensitivityResults sensitivities;
  base::Vec3 x = base::Vec3::Zero();         ///< the tip, undeformed
  base::Vec3 direction = base::Vec3::Zero(); ///< unit, the way the crack grows; zero: unknown
};

/// When a tip has a quantity.
enum class TipQuantityCondition {
  always,
  in_one_material, ///< not on the border of two
  with_bar,
  with_opening ///< where `$VCE CHECK=OPENING` asks for it
};

/// Where a quantity of a tip is found, to be added up.
enum TipOutput : unsigned {
  in_k_csv = 1,
  in_results_h5 = 2, ///< its table k
  in_listing = 4,    ///< and in report.html
  in_shell = 8,      ///< the answer to `k`
  in_output = 16,    ///< what $OUTPUT FORMAT=CSV writes for K
  in_sweep = 32,
  in_check = 64,
  everywhere = 127
};

/// How the listing writes a quantity: six digits, these but 0 where only round-off is left beside
/// the largest, or two digits.
enum class TipQuantityDigits { six, six_beside_largest, two };

/// One quantity of a tip.
struct TipQuantity {
  const char* name; ///< as columns have it: "K1_bar"; $OUTPUT K1_BAR, $CHECK K1.BAR
  base::Quantity kind;
  std::string_view doc;
  double TipResult::*member = nullptr;            ///< where the record has it, or
  double (*computed)(const TipResult&) = nullptr; ///< how it follows from the record
  unsigned places = everywhere;
  TipQuantityCondition given = TipQuantityCondition::always;
  bool judges = false; ///< tells how good another is: in results.h5 behind those that do not
  int bar = -1;        ///< its error bar in TipResult::bar; -1: none
  std::string_view heading = {}; ///< in the listing, where it is not the name
  TipQuantityDigits digits = TipQuantityDigits::six;
  int shell_digits = 7;

  [[nodiscard]] bool appears_in(TipOutput place) const { return (places & place) != 0; }
  [[nodiscard]] double extract_value(const TipResult& tip) const {
    return member != nullptr ? tip.*member : computed(tip);
  }
  [[nodiscard]] bool is_given(const TipResult& tip) const;
  /// Given, or the 0 that K is between two materials.
  [[nodiscard]] bool is_number(const TipResult& tip) const {
    return is_given(tip) || given == TipQuantityCondition::in_one_material;
  }
  [[nodiscard]] std::string check_word() const; ///< "K1.BAR"
};

template <std::size_t k> double error_bar_size(const TipResult& tip) {
  return tip.bar[k].size();
}
template <std::size_t k, double KErrorBar::*part> double error_bar_part(const TipResult& tip) {
  return tip.bar[k].*part;
}

/// The error bar of K1 or K2, or a part of it.
constexpr TipQuantity error_bar_quantity(const char* name, std::string_view doc,
                                         double (*computed)(const TipResult&), unsigned places) {
  return {.name = name,
          .kind = base::Quantity::stress_intensity,
          .doc = doc,
          .computed = computed,
          .places = places,
          .given = TipQuantityCondition::with_bar,
          .judges = true};
}

/// In the order of k.csv: name of the tip and increment stand in front of them.
inline constexpr std::array tip_quantities{
    TipQuantity{.name = "a",
                .kind = base::Quantity::length,
                .doc = "crack length",
                .member = &TipResult::a,
                .places = everywhere & ~(in_sweep | in_check)},
    TipQuantity{.name = "K1",
                .kind = base::Quantity::stress_intensity,
                .doc = "stress intensity of mode I",
                .member = &TipResult::K1,
                .given = TipQuantityCondition::in_one_material,
                .bar = 0,
                .digits = TipQuantityDigits::six_beside_largest},
    TipQuantity{.name = "K2",
                .kind = base::Quantity::stress_intensity,
                .doc = "stress intensity of mode II",
                .member = &TipResult::K2,
                .given = TipQuantityCondition::in_one_material,
                .bar = 1,
                .digits = TipQuantityDigits::six_beside_largest},
    TipQuantity{.name = "G",
                .kind = base::Quantity::energy_release,
                .doc = "energy release rate",
                .member = &TipResult::G,
                .digits = TipQuantityDigits::six_beside_largest},
    TipQuantity{.name = "G_from_K",
                .kind = base::Quantity::energy_release,
                .doc = "energy release rate that K1 and K2 stand for",
                .member = &TipResult::G_from_K,
                .places = in_listing,
                .given = TipQuantityCondition::in_one_material,
                .heading = "(K1^2+K2^2)/E'",
                .digits = TipQuantityDigits::six_beside_largest},
    TipQuantity{.name = "spread",
                .kind = base::Quantity::number,
                .doc = "largest less smallest K1 of the domains over K",
                .member = &TipResult::spread,
                .places = in_k_csv | in_results_h5 | in_listing,
                .given = TipQuantityCondition::in_one_material,
                .judges = true,
                .digits = TipQuantityDigits::two},
    TipQuantity{.name = "T",
                .kind = base::Quantity::stress,
                .doc = "stress along the crack at the tip",
                .member = &TipResult::T,
                .places = everywhere & ~(in_output | in_sweep),
                .given = TipQuantityCondition::in_one_material,
                .shell_digits = 5},
    error_bar_quantity("K1_bar", "error bar of K1, half its width", error_bar_size<0>,
                       everywhere & ~(in_listing | in_shell)),
    error_bar_quantity("K1_best", "K1 with its estimated error taken out",
                       error_bar_part<0, &KErrorBar::best>,
                       everywhere & ~(in_listing | in_shell | in_sweep)),
    error_bar_quantity("K1_eta", "estimated error of K1", error_bar_part<0, &KErrorBar::eta>,
                       in_k_csv),
    error_bar_quantity("K1_sum", "sum of the elements' parts of it without signs",
                       error_bar_part<0, &KErrorBar::sum>, in_k_csv),
    error_bar_quantity("K1_flip", "largest change of K1 by one pair beside the end of a contact",
                       error_bar_part<0, &KErrorBar::set_change>, in_k_csv),
    error_bar_quantity("K2_bar", "error bar of K2", error_bar_size<1>,
                       everywhere & ~(in_listing | in_shell)),
    error_bar_quantity("K2_best", "K2 with its estimated error taken out",
                       error_bar_part<1, &KErrorBar::best>,
                       everywhere & ~(in_listing | in_shell | in_sweep)),
    error_bar_quantity("K2_eta", "estimated error of K2", error_bar_part<1, &KErrorBar::eta>,
                       in_k_csv),
    error_bar_quantity("K2_sum", "sum of the elements' parts of it without signs",
                       error_bar_part<1, &KErrorBar::sum>, in_k_csv),
    error_bar_quantity("K2_flip", "largest change of K2 by one pair beside the end of a contact",
                       error_bar_part<1, &KErrorBar::set_change>, in_k_csv),
    TipQuantity{.name = "K1_opening",
                .kind = base::Quantity::stress_intensity,
                .doc = "K1 by the opening of the faces behind the tip",
                .computed = [](const TipResult& tip) { return (*tip.K_opening)[0]; },
                .places = in_k_csv | in_listing,
                .given = TipQuantityCondition::with_opening,
                .judges = true,
                .heading = "K1 by opening"},
    TipQuantity{.name = "K2_opening",
                .kind = base::Quantity::stress_intensity,
                .doc = "K2 by the opening of the faces behind the tip",
                .computed = [](const TipResult& tip) { return (*tip.K_opening)[1]; },
                .places = in_k_csv | in_listing,
                .given = TipQuantityCondition::with_opening,
                .judges = true,
                .heading = "K2 by opening"},
};

/// The quantity that $CHECK calls so ("K1.BAR"; "K" is K1), or null.
const TipQuantity* find_tip_quantity(std::string_view check_word);

} // namespace spricka::results
