// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/by_dimension.hpp"
#include "base/quantity.hpp"
#include "results/front_result.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

/// A row for each quantity of a front's point, from which all that shows, keeps or checks them is
/// made (manual, new_result.md).
namespace spricka::results {

/// When a point has a quantity.
enum class KQuantityCondition {
  always,
  in_one_material, ///< not on the border of two
  with_bar,        ///< and within the body: points at the surface have none of their own
  with_opening,    ///< where `$VCE CHECK=OPENING` asks for it
  with_angles      ///< on an ellipse
};

/// Where a quantity is found, to be added up.
enum KOutputPlace : unsigned {
  in_k_csv = 1,
  in_results_h5 = 2, ///< its table k
  in_listing = 4,    ///< and in report.html
  in_output = 16,    ///< what $OUTPUT FORMAT=CSV writes for K
  in_sweep = 32,
  in_check = 64,
  in_files = in_k_csv | in_results_h5,
  everywhere = in_files | in_listing | in_output | in_sweep | in_check
};

/// How the listing writes a quantity: six digits, these but 0 where only round-off is left beside
/// the largest, or two digits.
enum class KQuantityDigits { six, six_beside_largest, two };

/// One quantity of a point of a front.
struct KQuantity {
  /// How a quantity follows from the records of a front and of a point of it.
  using Function = double(const FrontResult&, const FrontPointResult&);

  const char* name; ///< as columns have it: "K1_bar"; $OUTPUT K1_BAR, $CHECK K1.BAR
  base::QuantityKind kind;
  std::string_view doc;
  double FrontPointResult::*member = nullptr; ///< where the record has it, or
  /// how it follows from the records.
  Function* computed = nullptr;
  base::ByDimension<unsigned> places{0, 0}; ///< where it is found of tips and of fronts in space
  KQuantityCondition given = KQuantityCondition::always;
  /// Tells how good another quantity is: stored behind the others of a step's point.
  bool is_quality_measure = false;
  int mode = -1;                 ///< 0, 1, 2: K1, K2, K3 or its smooth curve; -1: another quantity
  std::string_view heading = {}; ///< in the listing, where it is not the name
  KQuantityDigits digits = KQuantityDigits::six;

  /// Whether runs in `dim` dimensions have it there.
  [[nodiscard]] bool appears_in(KOutputPlace place, int dim) const {
    return (places.at(dim) & place) != 0;
  }
  /// The number of this quantity at a point of a front, from its record or computed.
  [[nodiscard]] double extract_value(const FrontResult& front,
                                     const FrontPointResult& point) const {
    return member != nullptr ? point.*member : computed(front, point);
  }
  /// The number of this quantity at a tip in the plane.
  [[nodiscard]] double extract_value(const FrontResult& front) const {
    return extract_value(front, front.single_point());
  }
  /// Whether a front has it, at some points at least.
  [[nodiscard]] bool is_given(const FrontResult& front) const;
  /// Whether a point of a front has it: error bars are not given at surfaces.
  [[nodiscard]] bool is_given(const FrontResult& front, const FrontPointResult& point) const {
    return is_given(front) && !(given == KQuantityCondition::with_bar && point.at_surface);
  }
  /// Given, or the 0 that K is between two materials.
  [[nodiscard]] bool is_given_or_zero(const FrontResult& front) const {
    return is_given(front) || given == KQuantityCondition::in_one_material;
  }
  /// The same at a point of a front, where an error bar at a surface is none.
  [[nodiscard]] bool is_given_or_zero(const FrontResult& front,
                                      const FrontPointResult& point) const {
    return is_given(front, point) || given == KQuantityCondition::in_one_material;
  }
  /// K1, K2 or K3 itself, which an error bar goes with.
  [[nodiscard]] bool is_k() const { return member != nullptr && mode >= 0; }
  [[nodiscard]] std::string check_word() const; ///< "K1.BAR"
};

/// A coordinate x, y or z (c = 0, 1, 2) of a point.
template <int c>
double front_coordinate(const FrontResult& /*front*/, const FrontPointResult& point) {
  return point.x[c];
}
/// K1, K2 or K3 (k = 0, 1, 2) as a smooth function along the front, at a point.
template <std::size_t k>
double smooth_k(const FrontResult& /*front*/, const FrontPointResult& point) {
  return point.smooth[k];
}
/// K1 or K2 (k = 0, 1) by the opening of the faces behind a point that has it.
template <std::size_t k>
double k_by_opening(const FrontResult& /*front*/, const FrontPointResult& point) {
  return (*point.opening)[k];
}
/// Half width of the error bar of K1, K2 or K3 (k = 0, 1, 2) at a point.
template <std::size_t k>
double error_bar_size(const FrontResult& /*front*/, const FrontPointResult& point) {
  return point.bar[k].size();
}
/// K1, K2 or K3 (k = 0, 1, 2) as the mesh has it.
template <std::size_t k> double raw_K(const FrontResult& /*front*/, const FrontPointResult& point) {
  return point.raw_K()[k];
}
/// One part of the error bar of K1, K2 or K3 (k = 0, 1, 2) at a point.
template <std::size_t k, double KErrorBar::*part>
double error_bar_part(const FrontResult& /*front*/, const FrontPointResult& point) {
  return point.bar[k].*part;
}

/// A quantity that is a coordinate of the point.
constexpr KQuantity front_coordinate_quantity(const char* name, KQuantity::Function* computed) {
  return {.name = name,
          .kind = base::QuantityKind::length,
          .doc = "place",
          .computed = computed,
          .places = {in_results_h5, in_files | in_listing}};
}

/// A quantity that is K1, K2 or K3 (mode 0, 1, 2) itself.
constexpr KQuantity k_mode_quantity(const char* name, std::string_view doc,
                                    double FrontPointResult::*member, int mode,
                                    unsigned tip_places) {
  return {.name = name,
          .kind = base::QuantityKind::stress_intensity,
          .doc = doc,
          .member = member,
          .places = {tip_places, in_files | in_listing | in_output | in_check},
          .given = KQuantityCondition::in_one_material,
          .mode = mode,
          .digits = KQuantityDigits::six_beside_largest};
}

/// A quantity that is the smooth curve of a mode (0, 1, 2) along the front.
constexpr KQuantity smooth_k_quantity(const char* name, std::string_view doc,
                                      KQuantity::Function* computed, int mode) {
  return {.name = name,
          .kind = base::QuantityKind::stress_intensity,
          .doc = doc,
          .computed = computed,
          .places = {0, in_files},
          .mode = mode};
}

/// A quantity that is K of a mode (0, 1, 2) as the mesh has it: K but for its estimated error where
/// that is taken out.
constexpr KQuantity raw_k_quantity(const char* name, std::string_view doc,
                                   KQuantity::Function* computed, unsigned tip_places) {
  return {.name = name,
          .kind = base::QuantityKind::stress_intensity,
          .doc = doc,
          .computed = computed,
          .places = {tip_places, in_files | in_output | in_check},
          .given = KQuantityCondition::in_one_material,
          .is_quality_measure = true};
}

/// A quantity that is the error bar of K1, K2 or K3, or a part of it: given with a bar alone.
constexpr KQuantity error_bar_quantity(const char* name, std::string_view doc,
                                       KQuantity::Function* computed, unsigned tip_places,
                                       unsigned front_places) {
  return {.name = name,
          .kind = base::QuantityKind::stress_intensity,
          .doc = doc,
          .computed = computed,
          .places = {tip_places, front_places},
          .given = KQuantityCondition::with_bar,
          .is_quality_measure = true};
}

/// A quantity that is K of a mode by the opening of the faces.
constexpr KQuantity k_by_opening_quantity(const char* name, std::string_view doc,
                                          KQuantity::Function* computed, std::string_view heading) {
  return {.name = name,
          .kind = base::QuantityKind::stress_intensity,
          .doc = doc,
          .computed = computed,
          .places = {in_k_csv | in_listing, 0},
          .given = KQuantityCondition::with_opening,
          .is_quality_measure = true,
          .heading = heading};
}

/// In the order of k.csv: increment, step and crack stand before them.
inline constexpr std::array k_quantities{
    KQuantity{.name = "a",
              .kind = base::QuantityKind::length,
              .doc = "crack length",
              .computed = [](const FrontResult& front, const FrontPointResult&) { return front.a; },
              .places = {everywhere & ~(in_sweep | in_check), in_files}},
    KQuantity{
        .name = "point",
        .kind = base::QuantityKind::number,
        .doc = "number of the point along the front",
        .computed = [](const FrontResult&,
                       const FrontPointResult& point) { return static_cast<double>(point.number); },
        .places = {0, in_files}},
    KQuantity{
        .name = "at_surface",
        .kind = base::QuantityKind::number,
        .doc = "1 where the front ends at a surface",
        .computed = [](const FrontResult&,
                       const FrontPointResult& point) { return point.at_surface ? 1.0 : 0.0; },
        .places = {0, in_files}},
    KQuantity{.name = "closed",
              .kind = base::QuantityKind::number,
              .doc = "1 where the faces behind the front touch",
              .computed = [](const FrontResult&,
                             const FrontPointResult& point) { return point.closed ? 1.0 : 0.0; },
              .places = {0, in_files}},
    KQuantity{.name = "s",
              .kind = base::QuantityKind::length,
              .doc = "length along the front",
              .member = &FrontPointResult::s,
              .places = {0, in_files | in_listing}},
    KQuantity{.name = "phi",
              .kind = base::QuantityKind::angle,
              .doc = "parametric angle of an ellipse",
              .member = &FrontPointResult::phi,
              .places = {0, in_files | in_listing},
              .given = KQuantityCondition::with_angles},
    front_coordinate_quantity("x", front_coordinate<0>),
    front_coordinate_quantity("y", front_coordinate<1>),
    front_coordinate_quantity("z", front_coordinate<2>),
    k_mode_quantity("K1", "stress intensity of mode I", &FrontPointResult::K1, 0, everywhere),
    k_mode_quantity("K2", "stress intensity of mode II", &FrontPointResult::K2, 1, everywhere),
    k_mode_quantity("K3", "stress intensity of mode III", &FrontPointResult::K3, 2, 0),
    KQuantity{.name = "G",
              .kind = base::QuantityKind::energy_release,
              .doc = "energy release rate",
              .member = &FrontPointResult::G,
              .places = {everywhere, in_files | in_listing | in_output | in_check},
              .digits = KQuantityDigits::six_beside_largest},
    KQuantity{.name = "G_from_K",
              .kind = base::QuantityKind::energy_release,
              .doc = "energy release rate that raw K stands for",
              .member = &FrontPointResult::G_from_K,
              .places = {in_listing, in_files},
              .given = KQuantityCondition::in_one_material,
              .heading = "G of raw K",
              .digits = KQuantityDigits::six_beside_largest},
    KQuantity{.name = "spread",
              .kind = base::QuantityKind::number,
              .doc = "largest less smallest K1 of the domains over K",
              .member = &FrontPointResult::spread,
              .places = {in_files | in_listing, in_files | in_listing},
              .given = KQuantityCondition::in_one_material,
              .is_quality_measure = true,
              .digits = KQuantityDigits::two},
    KQuantity{.name = "T",
              .kind = base::QuantityKind::stress,
              .doc = "stress along the crack at the tip",
              .member = &FrontPointResult::T,
              .places = {everywhere & ~(in_output | in_sweep),
                         in_files | in_listing | in_output | in_check},
              .given = KQuantityCondition::in_one_material},
    smooth_k_quantity("K1_smooth", "K1 as a smooth function along the front", smooth_k<0>, 0),
    smooth_k_quantity("K2_smooth", "K2 as a smooth function along the front", smooth_k<1>, 1),
    smooth_k_quantity("K3_smooth", "K3 as a smooth function along the front", smooth_k<2>, 2),
    error_bar_quantity("K1_bar", "error bar of K1, half its width", error_bar_size<0>,
                       everywhere & ~in_listing, in_files | in_output | in_check),
    raw_k_quantity("K1_raw", "K1 as the mesh has it", raw_K<0>,
                   everywhere & ~(in_listing | in_sweep)),
    error_bar_quantity("K1_eta", "estimated error of K1", error_bar_part<0, &KErrorBar::eta>,
                       in_k_csv, 0),
    error_bar_quantity("K1_sum", "sum of the elements' parts of it without signs",
                       error_bar_part<0, &KErrorBar::sum>, in_k_csv, 0),
    error_bar_quantity("K1_flip", "largest change of K1 by one pair beside the end of a contact",
                       error_bar_part<0, &KErrorBar::set_change>, in_k_csv, 0),
    error_bar_quantity("K2_bar", "error bar of K2", error_bar_size<1>, everywhere & ~in_listing,
                       in_files | in_output | in_check),
    raw_k_quantity("K2_raw", "K2 as the mesh has it", raw_K<1>,
                   everywhere & ~(in_listing | in_sweep)),
    error_bar_quantity("K2_eta", "estimated error of K2", error_bar_part<1, &KErrorBar::eta>,
                       in_k_csv, 0),
    error_bar_quantity("K2_sum", "sum of the elements' parts of it without signs",
                       error_bar_part<1, &KErrorBar::sum>, in_k_csv, 0),
    error_bar_quantity("K2_flip", "largest change of K2 by one pair beside the end of a contact",
                       error_bar_part<1, &KErrorBar::set_change>, in_k_csv, 0),
    error_bar_quantity("K3_bar", "error bar of K3", error_bar_size<2>, 0,
                       in_files | in_output | in_check),
    raw_k_quantity("K3_raw", "K3 as the mesh has it", raw_K<2>, 0),
    k_by_opening_quantity("K1_opening", "K1 by the opening of the faces behind the tip",
                          k_by_opening<0>, "K1 by opening"),
    k_by_opening_quantity("K2_opening", "K2 by the opening of the faces behind the tip",
                          k_by_opening<1>, "K2 by opening"),
};

/// The quantity that $CHECK calls so ("K1.BAR"; "K" is K1) in `dim` dimensions, or null.
const KQuantity* find_k_quantity(std::string_view check_word, int dim);

/// What a quantity is at a place of the front, linear between its points (K and its best values on
/// a smooth curve); the nearest to x.
double front_value_near(const FrontResult& front, const KQuantity& quantity, const base::Vec3& x);

/// The same at an angle phi [rad], counted modulo a full turn; empty where the front has none of
/// it.
std::optional<double> front_value_at_angle(const FrontResult& front, const KQuantity& quantity,
                                           double phi);

/// The same at a length s along the front; empty where it has none of it.
std::optional<double> front_value_at_length(const FrontResult& front, const KQuantity& quantity,
                                            double s);

} // namespace spricka::results
