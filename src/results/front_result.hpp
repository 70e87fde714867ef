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

/// What is found along a front of a crack in space: the records, and a row for each quantity of a
/// point of it, from which all that shows, keeps or checks them is made (manual, new_result.md).
namespace spricka::results {

/// K at one point of a front, a corner node on it; stresses and K in deck units.
struct FrontPointResult {
  int number = 0; ///< counts along the front from 1
  base::Vec3 x = base::Vec3::Zero();
  double s = 0.0;   ///< length along the front from its first point
  double phi = 0.0; ///< of an ellipse: parametric angle from its axis C [rad]
  double K1 = 0.0, K2 = 0.0, K3 = 0.0;
  double G = 0.0;        ///< energy release rate [force/length]
  double G_from_K = 0.0; ///< what K stands for, in plane strain
  double T = 0.0;        ///< stress along m that K leaves [stress]
  double spread = 0.0;   ///< largest less smallest K1 of the domains over K
  /// K as a smooth function along the front; next to an end on the surface what the places further
  /// in go on to, as K at the end itself depends on the mesh. K1, K2, K3
  std::array<double, 3> smooth{};
  std::optional<std::array<double, 3>> opening; ///< by the opening of the faces, on request
  bool at_surface = false; ///< the front leaves the body here: K is a number of the mesh
  bool closed = false;     ///< the faces touch, so that K1 is 0
  /// Of K1, K2, K3, where `no_bar` of the front is empty; at the surface those of the next point.
  std::array<KErrorBar, 3> bar;
  base::Vec3 growth = base::Vec3::Zero(); ///< m, unit
};

/// One front of a crack at the end of one step.
struct FrontResult {
  std::string name; ///< the crack's, or NAME.1 and NAME.2 where the front has several parts
  double a = 0.0;   ///< size of the crack [length]
  double length = 0.0;
  bool closed = false; ///< the last point joins the first
  bool angles = false; ///< points have phi
  std::vector<FrontPointResult> points;
  std::string no_bar = "not estimated"; ///< why there is no error bar; empty: there is one
  std::string invalid_reason;           ///< why K is not an answer; empty: it is one
  FrontSensitivityResults sensitivities;
};

/// One quantity of a place of a front.
struct FrontQuantity {
  const char* name; ///< as columns have it
  base::Quantity kind;
  std::string_view doc;
  double FrontPointResult::*member = nullptr;            ///< where the record has it, or
  double (*computed)(const FrontPointResult&) = nullptr; ///< how it follows from the record
  bool listed = false;                                   ///< in the listing and report.html
  bool checked = false;                                  ///< $CHECK asks for it: K1.AT and so on
  bool (*given)(const FrontResult&) = nullptr;           ///< whether a front has it; null: always
  bool inside = false;        ///< points at the surface have none of their own
  std::string_view word = {}; ///< what $CHECK calls it; empty: its name

  [[nodiscard]] double extract_value(const FrontPointResult& place) const {
    return member != nullptr ? place.*member : computed(place);
  }
};

/// Whether K along the front has an error bar.
inline bool has_error_bar(const FrontResult& front) {
  return front.no_bar.empty();
}

/// In the order of k.csv: increment, step, crack and point stand in front of them.
inline constexpr std::array front_quantities{
    FrontQuantity{.name = "s",
                  .kind = base::Quantity::length,
                  .doc = "length along the front",
                  .member = &FrontPointResult::s,
                  .listed = true},
    FrontQuantity{.name = "phi",
                  .kind = base::Quantity::angle,
                  .doc = "parametric angle of an ellipse",
                  .member = &FrontPointResult::phi,
                  .listed = true,
                  .given = [](const FrontResult& front) { return front.angles; }},
    FrontQuantity{.name = "x",
                  .kind = base::Quantity::length,
                  .doc = "place",
                  .computed = [](const FrontPointResult& place) { return place.x.x(); },
                  .listed = true},
    FrontQuantity{.name = "y",
                  .kind = base::Quantity::length,
                  .doc = "place",
                  .computed = [](const FrontPointResult& place) { return place.x.y(); },
                  .listed = true},
    FrontQuantity{.name = "z",
                  .kind = base::Quantity::length,
                  .doc = "place",
                  .computed = [](const FrontPointResult& place) { return place.x.z(); },
                  .listed = true},
    FrontQuantity{.name = "K1",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "stress intensity of mode I",
                  .member = &FrontPointResult::K1,
                  .listed = true,
                  .checked = true},
    FrontQuantity{.name = "K2",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "stress intensity of mode II",
                  .member = &FrontPointResult::K2,
                  .listed = true,
                  .checked = true},
    FrontQuantity{.name = "K3",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "stress intensity of mode III",
                  .member = &FrontPointResult::K3,
                  .listed = true,
                  .checked = true},
    FrontQuantity{.name = "G",
                  .kind = base::Quantity::energy_release,
                  .doc = "energy release rate",
                  .member = &FrontPointResult::G,
                  .listed = true,
                  .checked = true},
    FrontQuantity{.name = "G_from_K",
                  .kind = base::Quantity::energy_release,
                  .doc = "energy release rate that K stands for",
                  .member = &FrontPointResult::G_from_K},
    FrontQuantity{.name = "T",
                  .kind = base::Quantity::stress,
                  .doc = "stress in the crack's plane across the front",
                  .member = &FrontPointResult::T,
                  .listed = true,
                  .checked = true},
    FrontQuantity{.name = "spread",
                  .kind = base::Quantity::number,
                  .doc = "largest less smallest K1 of the domains over K",
                  .member = &FrontPointResult::spread,
                  .listed = true},
    FrontQuantity{.name = "K1_smooth",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K1 as a smooth function along the front",
                  .computed = [](const FrontPointResult& place) { return place.smooth[0]; }},
    FrontQuantity{.name = "K2_smooth",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K2 as a smooth function along the front",
                  .computed = [](const FrontPointResult& place) { return place.smooth[1]; }},
    FrontQuantity{.name = "K3_smooth",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K3 as a smooth function along the front",
                  .computed = [](const FrontPointResult& place) { return place.smooth[2]; }},
    FrontQuantity{.name = "K1_bar",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "error bar of K1",
                  .computed = [](const FrontPointResult& place) { return place.bar[0].size(); },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K1.BAR"},
    FrontQuantity{.name = "K2_bar",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "error bar of K2",
                  .computed = [](const FrontPointResult& place) { return place.bar[1].size(); },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K2.BAR"},
    FrontQuantity{.name = "K3_bar",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "error bar of K3",
                  .computed = [](const FrontPointResult& place) { return place.bar[2].size(); },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K3.BAR"},
    FrontQuantity{.name = "K1_best",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K1 with its estimated error taken out",
                  .computed = [](const FrontPointResult& place) { return place.bar[0].best; },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K1.BEST"},
    FrontQuantity{.name = "K2_best",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K2 with its estimated error taken out",
                  .computed = [](const FrontPointResult& place) { return place.bar[1].best; },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K2.BEST"},
    FrontQuantity{.name = "K3_best",
                  .kind = base::Quantity::stress_intensity,
                  .doc = "K3 with its estimated error taken out",
                  .computed = [](const FrontPointResult& place) { return place.bar[2].best; },
                  .checked = true,
                  .given = has_error_bar,
                  .inside = true,
                  .word = "K3.BEST"},
};

/// The quantity of that name ("K1", also as "K"; "K1.BAR" as K1_bar), or null.
const FrontQuantity* find_front_quantity(std::string_view name);

/// What a quantity is at a place of the front, linear between its points; the nearest to x.
double front_value_near(const FrontResult& front, const FrontQuantity& quantity,
                        const base::Vec3& x);

/// The same at an angle phi [rad], counted modulo a full turn; empty where the front has none of
/// it.
std::optional<double> front_value_at_angle(const FrontResult& front, const FrontQuantity& quantity,
                                           double phi);

/// The same at a length s along the front; empty where it has none of it.
std::optional<double> front_value_at_length(const FrontResult& front, const FrontQuantity& quantity,
                                            double s);

} // namespace spricka::results
