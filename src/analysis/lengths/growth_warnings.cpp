// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_warnings.hpp"

#include "analysis/lengths/load_history.hpp"
#include "life/growth_law.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// K2 beyond this part of K1 on a given path is worth a word, and K2 or K3 along a front in space,
/// which would leave its plane.
constexpr double much_shear = 0.25;
constexpr std::string_view of_station = " (station "; // what is said of a mesh
constexpr double worst_mismatch = 1e-6; // of K against that of recovered displacements

} // namespace

void GrowthWarnings::keep_first_mesh_warning(const std::string& code, const std::string& text,
                                             std::size_t station) {
  const bool known = std::ranges::any_of(
      warnings_, [&](const results::Warning& warning) { return warning.code == code; });
  if (!known) {
    warnings_.insert({code, fmt::format("{}{}{})", text, of_station, station)});
  }
}

void GrowthWarnings::warn_of_constant_threshold(const std::string& crack, double a, double K_max,
                                                double K_min) {
  const std::string of = crack + ": DKTH is one threshold for all R";
  if (std::ranges::any_of(warnings_, [&](const results::Warning& warning) {
        return warning.text.starts_with(of);
      })) {
    return;
  }
  const double k_unit = rules_.constants.k_unit;
  const double range = life::tensile_K_range(K_max, K_min);
  const double least = rules_.constants.threshold;
  warnings_.insert(
      {"W456",
       fmt::format(
           "{}: at a = {:.6g} a cycle with R = {:.3g} has delta K = {:.4g}, {:.2f} of "
           "DKTH = {:.4g} (in KUNIT). A threshold falls with R; give DK0, that at R = 0, or "
           "DK1, that for R to 1, with CTHP and CTHM, unless DKTH holds for this R",
           of, a, K_min / K_max, range / k_unit, range / least, least / k_unit)});
}

void GrowthWarnings::warn_of_missing_error_bar(const std::string& name, const std::string& why) {
  if (rules_.correction_wanted && !why.empty()) {
    warnings_.insert(
        {"W456", fmt::format("CORRECT=YES, but {} has no error bar everywhere ({}): there K is "
                             "as computed",
                             name, why)});
  }
}

void GrowthWarnings::warn_of_invalid_result(const results::FrontResult& front, double K1) {
  if (!front.invalid_reason.empty() && K1 > 0.0) {
    warnings_.insert(
        {"W508", fmt::format("{}: K at KMAX is in doubt: {}", front.name, front.invalid_reason)});
  }
}

void GrowthWarnings::warn_of_missing_error_bar(const results::FrontResult& end) {
  // A tip whose faces touch there needs none.
  if (!end.is_tip() || !end.single_point().closed) {
    warn_of_missing_error_bar(end.name, end.missing_bar_reason);
  }
}

void GrowthWarnings::warn_of_K2(const std::string& name, const base::Vec2& K) {
  if (stays_on_path() && K[0] > 0.0 && std::abs(K[1]) > much_shear * K[0]) {
    warnings_.insert(
        {"W456", fmt::format("{} grows along its path although K2 is {:.2f} of K1; the law is "
                             "given K1 alone",
                             name, K[1] / K[0])});
  }
}

void GrowthWarnings::note_neglected_shear_K(const std::string& crack, const base::Vec3& K) {
  const double K2 = stays_on_path() ? std::abs(K[1]) : 0.0;
  const double part = std::max(K2, std::abs(K[2])) / K[0];
  if (K[0] > 0.0 && part > std::max(much_shear, shear_[crack].part)) {
    shear_[crack] = {K2 > std::abs(K[2]) ? "K2" : "K3", part};
  }
}

std::set<results::Warning> GrowthWarnings::all() const {
  std::set<results::Warning> all = warnings_;
  const bool stays = stays_on_path();
  for (const auto& [crack, shear] : shear_) {
    if (shear.part > 0.0) {
      all.insert(
          {"W456", fmt::format("{} grows {} although {} is up to {:.2f} of K1; the law is given K1 "
                               "{}",
                               crack, stays ? "in its plane" : "as K1 and K2 turn it", shear.what,
                               shear.part, stays ? "alone" : "of the turned crack alone")});
    }
  }
  return all;
}

void GrowthWarnings::warn_of_closing_faces(const std::string& name, double a) {
  warnings_.insert(
      {"W456", fmt::format("{}: at a = {:.6g} its faces close and there is no solution with "
                           "faces that overlap: K_min is 0 there, though the law knows R < 0; "
                           "the life may come out too long",
                           name, a)});
}

void GrowthWarnings::warn_of_load_history(const LoadHistoryKResult& loads, double a) {
  if (!(loads.change <= repeats_to)) {
    warnings_.insert(
        {"W507",
         fmt::format(
             "K did not repeat itself within {} passes of the loads: at a = {:.6g} it still "
             "changes by {:.1e} of the largest K from one to the next",
             loads.passes, a, loads.change)});
  }
  if (!(loads.mismatch <= worst_mismatch)) {
    warnings_.insert({"W507", fmt::format("K of the loads that were followed differs from K of the "
                                          "displacements by {:.1e} of the largest",
                                          loads.mismatch)});
  }
  if (rules_.correction_wanted) {
    warnings_.insert(
        {"W456", "CORRECT=YES, but with friction K has no error bar: K is as computed"});
  }
}

void GrowthWarnings::save_state(results::NamedArrays& arrays) const {
  arrays.texts["growth.warnings"] =
      results::text_with_code(std::vector<results::Warning>(warnings_.begin(), warnings_.end()));
  for (const auto& [crack, shear] : shear_) {
    arrays.texts["growth.shear"].insert(arrays.texts["growth.shear"].end(), {crack, shear.what});
    arrays.reals["growth.shear"].push_back(shear.part);
  }
}

void GrowthWarnings::restore_state(const results::NamedArrays& arrays) {
  for (results::Warning& warning :
       results::parse_warnings(results::required_array(arrays.texts, "growth.warnings"))) {
    warnings_.insert(std::move(warning));
  }
  if (const auto parts = arrays.reals.find("growth.shear"); parts != arrays.reals.end()) {
    const std::vector<std::string>& names =
        results::required_array(arrays.texts, "growth.shear", 2 * parts->second.size());
    for (std::size_t i = 0; i < parts->second.size(); ++i) {
      shear_[names[2 * i]] = {names[2 * i + 1], parts->second[i]};
    }
  }
}

void GrowthWarnings::restore_mesh_warnings(const results::NamedArrays& arrays) {
  const auto kept = arrays.texts.find("growth.warnings");
  if (kept == arrays.texts.end()) {
    return;
  }
  for (results::Warning& warning : results::parse_warnings(kept->second)) {
    if (warning.text.find(of_station) != std::string::npos) {
      warnings_.insert(std::move(warning));
    }
  }
}

} // namespace spricka::analysis
