// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "results/k_bar.hpp"
#include "results/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

/// What is found along the front of a crack: K belongs to its points, and a tip in the plane is a
/// front of one point.
namespace spricka::results {

/// K at one point of a front; stresses and K in deck units.
struct FrontPointResult {
  int number = 1;                    ///< counts along the front from 1
  base::Vec3 x = base::Vec3::Zero(); ///< undeformed; in space a corner node
  double s = 0.0;                    ///< length along the front from its first point
  double phi = 0.0;                  ///< of an ellipse: parametric angle from its axis C [rad]
  /// K that counts: printed, checked and given to the law; in the plane K3 is 0.
  double K1 = 0.0, K2 = 0.0, K3 = 0.0;
  double G = 0.0;                ///< energy release rate [force/length]
  double G_from_K = 0.0;         ///< what raw K stands for; in space in plane strain
  double T = 0.0;                ///< stress along `direction` that K leaves [stress]
  double spread = 0.0;           ///< (largest - smallest K1 of the domains) over K
  std::vector<double> K1_domain; ///< [domain] in the plane
  /// K as a smooth function along the front; next to an end on the surface what the places further
  /// in go on to, as K at the end itself depends on the mesh. K1, K2, K3
  std::array<double, 3> smooth{};
  /// K1, K2, K3 as the mesh has them, and their smooth function, where the estimated error has been
  /// taken out of those above; empty: those above are the mesh's.
  std::optional<std::array<double, 3>> raw, raw_smooth;
  std::optional<std::array<double, 3>> opening; ///< by the opening of the faces, on request
  bool at_surface = false; ///< the front leaves the body here: K is a number of the mesh
  bool closed = false;     ///< the faces touch, so that K1 is 0
  /// Of K1, K2, K3, where `missing_bar_reason` of the front is empty; at the surface those of the
  /// next point.
  std::array<KErrorBar, 3> bar;
  base::Vec3 direction = base::Vec3::Zero(); ///< unit, the way the crack grows; zero: unknown

  [[nodiscard]] std::array<double, 3> K() const { return {K1, K2, K3}; }
  [[nodiscard]] std::array<double, 3> raw_K() const { return raw.value_or(K()); }
  [[nodiscard]] std::array<double, 3> raw_smooth_K() const { return raw_smooth.value_or(smooth); }
};

/// One front at the end of one step.
struct FrontResult {
  std::string name;        ///< the crack's, or NAME.1 and NAME.2 where it has several tips or parts
  double a = 0.0;          ///< size of the crack [length]
  double length = 0.0;     ///< of the front, 0 in the plane
  bool is_loop = false;    ///< the last point joins the first
  bool has_angles = false; ///< points have phi
  std::vector<FrontPointResult> points;
  std::string missing_bar_reason =
      "not estimated";        ///< why there is no error bar; empty: there is one
  std::string invalid_reason; ///< why K is not an answer; empty: it is one
  bool two_materials = false; ///< on both sides of the crack: G only, K and T are 0
  FrontKSensitivities sensitivities;

  /// In the plane: one point and no length.
  [[nodiscard]] bool is_tip() const { return points.size() == 1; }
  [[nodiscard]] const FrontPointResult& single_point() const { return points.front(); }
  [[nodiscard]] FrontPointResult& single_point() { return points.front(); }
  [[nodiscard]] bool has_error_bar() const { return missing_bar_reason.empty(); }
  /// Whether K of some points has had its estimated error taken out.
  [[nodiscard]] bool is_corrected() const {
    return std::ranges::any_of(points, [](const auto& point) { return point.raw.has_value(); });
  }
};

/// Makes K with its estimated error taken out the K that counts, where the bars are its own
/// (manual, error_bar.md); what was there stays as raw K. Once for each front.
void take_out_estimated_errors(FrontResult& front);
/// Makes raw K of a point the K that counts again.
void put_back_raw_K(FrontPointResult& point);

} // namespace spricka::results
