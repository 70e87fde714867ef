// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/piecewise_linear.hpp"
#include "results/front_result.hpp"
#include "results/note.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// K and contact along straight paths between the loads and fits of two steps.
namespace spricka::results {

/// K at one point of a front.
struct LoadPathFrontPoint {
  FrontPointResult point_at_start; ///< where it is; its K are those at the beginning
  /// K1, K2, K3 [stress * length^0.5], the estimated errors at both ends taken out as there.
  std::array<base::PiecewiseLinear, 3> K;
  std::array<base::PiecewiseLinear, 3> smooth; ///< as those of FrontPointResult
};

/// One front by t, exact between all knots.
struct LoadPathFront {
  FrontResult front_without_points; ///< name, size and flags; all K stand at `points`
  std::vector<LoadPathFrontPoint> points;

  /// In the plane: one point.
  [[nodiscard]] bool is_tip() const { return points.size() == 1; }
  [[nodiscard]] const LoadPathFrontPoint& single_point() const { return points.front(); }
  /// The front as steps have it, with K at t (of the path) alone.
  [[nodiscard]] FrontResult at(double t) const;
};

/// One contact at the breakpoints: the longest run of closed pairs.
struct LoadPathContact {
  std::string name;
  std::optional<double> opening; ///< t at which the first closed pair opens; empty: none does
  bool round = false;            ///< angles [rad], else length along the surface
  std::vector<double> from, to;  ///< [knot] first and last closed pair behind the knot
  std::vector<int> closed;       ///< [knot] pairs closed behind the knot
  int rows = 0;
};

struct ContactStatusChange {
  double t = 0.0;
  std::string contact;
  base::NodeId node;
  double place = 0.0; ///< angle [rad] or length along the surface
  bool closes = false;
};

/// Loads and fits (1 - t) of step `from` and t of step `to`.
struct LoadPathResult {
  std::string name, from, to;
  std::vector<double> t; ///< [knot] first, breakpoints, last
  std::vector<LoadPathFront> fronts;
  std::vector<LoadPathContact> contacts;
  std::vector<ContactStatusChange> changes;
  std::string stopped; ///< why it ends before its time; empty: it does not
  /// All gaps, loads and temperatures of both steps scale with their factors, so that a times
  /// `from` and b times `to` together are (a + b) times the path at b / (a + b).
  bool homogeneous = false;
  int pivots = 0, factorisations = 0;
  double residual = 0.0; ///< largest violation of the contact conditions, scaled
  double mismatch = 0.0; ///< largest difference of K to the steps' own, over the largest K
  std::vector<Note> notes;
};

/// The entries of that name, or null.
const LoadPathFront* find_front(const LoadPathResult& path, std::string_view front);
/// The contact of that name on a load path; null: none.
const LoadPathContact* find_contact(const LoadPathResult& path, std::string_view contact);

/// K1 (mode 1) or K2 under a times the loads and fits of `from` plus b times those of `to`, by
/// homogeneity (manual, solve.33) from the path of one parameter. Empty outside what it covers: a +
/// b <= 0, the ratio beyond the path, or a path that is not homogeneous unless a + b = 1.
std::optional<double> k_at_load_combination(const LoadPathResult& path,
                                            const LoadPathFrontPoint& point, int mode, double a,
                                            double b);

} // namespace spricka::results
