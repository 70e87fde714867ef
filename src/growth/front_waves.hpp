// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

/// Waves of a front that takes its own shape: points spread evenly along it, what K makes of the
/// waves that they stand for, and the scatter of meshes in it.
namespace spricka::growth {

/// A front all round; from surface to surface on a bend, as that of a surface or corner crack;
/// nearly straight, as one behind the faces of a plate, with few points of the mesh along it.
enum class FrontKind { closed, round, straight };

/// Points of an open front and of one that is closed at first.
inline constexpr int open_front_points = 17;
inline constexpr int closed_front_points = 32;

/// Values [point] along an arc, all above 0, without their scatter from mesh to mesh: their
/// logarithms as the polynomial of degree 8 (round; straight: 4) or by twelve harmonics (closed)
/// that fits best; and what that leaves, as far as it is more than `scatter` (rms of a logarithm):
/// waves that rates did not know would stay for ever (growth.16).
std::vector<double> smooth_front_rates(const std::vector<double>& values, FrontKind kind,
                                       double scatter);

/// The same of angles [point] as they are.
std::vector<double> smooth_front_angles(const std::vector<double>& angles, FrontKind kind);

/// What is known of a front that goes on.
struct FrontGrowthRates {
  std::vector<double> rate;             ///< [point]
  std::vector<double> rate_before;      ///< [point] one advance ago; empty: not known
  std::vector<double> last;             ///< [point] that advance [length]
  std::vector<double> deferred_advance; ///< [point] what is to be made up for [length]
  double stiffness = 0.0; ///< exponent of the law over the length of the arc [1/length]
  FrontKind kind = FrontKind::closed;

  /// Its advances [point] by `mean` on the whole, of the second order in it, each wave on its way
  /// to the shape that it tends to (growth.13) [length].
  [[nodiscard]] std::vector<double> point_advances(double mean) const;
  /// The advance still deferred [point] after an advance by `mean`, whose waves die away [length].
  [[nodiscard]] std::vector<double> remaining_deferred_advance(double mean) const;
  /// Part by which rates [point] are wrong where the front is not where it should be; of a
  /// straight front that of their sum, on which cycles are counted: its ends swing about where they
  /// should be.
  [[nodiscard]] std::vector<double> uncertain_fraction() const;
};

} // namespace spricka::growth
