// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "base/vec.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// K at places of fronts, which lie between their points or are tips.
namespace spricka::analysis {

/// A place between two points of a front, or nothing.
struct PlaceOnFront {
  std::size_t front = 0, from = 0, to = 0;
  double part = 0.0; ///< of the way from one to the other
  double away = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool found() const { return std::isfinite(away); }
};

/// The place that is nearest to x, of the fronts of a crack, or the tip of that name; no name: of
/// any.
PlaceOnFront nearest_place(const std::vector<results::FrontResult>& fronts, const std::string& name,
                           const base::Vec3& x);
/// The same of the fronts of a load path.
PlaceOnFront nearest_place(const std::vector<results::LoadPathFront>& fronts,
                           const std::string& name, const base::Vec3& x);

/// Whether a front in space is that of a surface or corner crack, or of one inside the body: it
/// turns by more than 45 degrees between its ends. That of a through crack runs from face to face.
bool is_part_through(const results::FrontResult& front);

/// A place on the curve through the points, not on its chords.
base::Vec3 point_on_front_curve(const results::FrontResult& front, const PlaceOnFront& at);

/// K1, K2, K3 as smooth functions along the front.
base::Vec3 interpolate_smooth_K(const results::FrontResult& front, const PlaceOnFront& at);

/// part[0] K1 + part[1] K2 on the path, smooth along the front.
base::PiecewiseLinear combined_K_over_path(const results::LoadPathFront& front,
                                           const PlaceOnFront& at, const base::Vec2& part);

/// K1 (mode 1) or K2 at a place of a step's fronts out of the K of all points of all its fronts
/// [crack::KLayout].
std::function<double(const base::Vector&)> make_K_interpolator(const results::LoadStepResult& step,
                                                               const PlaceOnFront& place, int mode);

/// K1 on a load path at the place of all fronts that is nearest to x; empty: there is none.
std::optional<base::PiecewiseLinear> path_K1_at_nearest_place(const results::LoadPathResult& path,
                                                              const base::Vec3& x);

} // namespace spricka::analysis
