// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/tube_sizes.hpp"

#include "mesh/plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::mesh {
namespace {

// Measured on pennies and ellipses, a/c down to 0.2: K within 0.7 % everywhere.
constexpr double radius_of_width = 0.1;
constexpr double radius_of_curvature = 0.5;
// Layers of tetrahedra reach as far as 2 radii: all within the centre of curvature.
constexpr double free_of_curvature = 0.33;
constexpr double radius_of_room = 0.4;
/// Domains of K reach over the tetrahedra beside the tube, and faces are straight in them.
constexpr double radius_of_straight = 0.5;
/// Of a square of the length over radius and radius of curvature: wedges at the front, a third of
/// the radius wide with nodes at a quarter of that, hold what the front bends by between corners.
constexpr double length_of_arc = 0.2;
constexpr double length_of_width = 0.15;
constexpr double length_of_curvature = 0.25;
constexpr double shortest = 0.5; // element over radius of the tube
constexpr double longest = 3.0;
constexpr double steepest = 0.2; // change of a size for each length along the front
// Where a front leaves the body K varies over short ways: corner cracks at bores, 0.5 % at 10 and
// 80 degrees.
constexpr double length_at_surface = 0.05; // of width and radius of curvature
constexpr double growth_from_surface = 0.3;
constexpr double shortest_at_surface = 0.2;

// Sections run together by the curvature and by the shear at leaning ends; this part of a length
// along the front they may lose, together.
constexpr double most_run_together = 0.85;
constexpr double steepest_shear = 1.5; // of the shear over its reach
constexpr double fewest_radii = 3.0;   // of that reach

constexpr std::size_t samples = 1024;
constexpr std::size_t fewest_of_closed = 8; // elements round a closed front
/// Of an open one, so that it has a point inside the body: K has no limit where a front leaves it.
constexpr std::size_t fewest_of_open = 2;

/// No size changes faster along the front than `steepest`.
void smooth(std::vector<double>& size, double step, bool closed, double slope = steepest) {
  const double most = slope * step;
  const std::size_t n = size.size();
  for (int round = 0; round < (closed ? 2 : 1); ++round) {
    for (std::size_t i = 1; i < n; ++i) {
      size[i] = std::min(size[i], size[i - 1] + most);
    }
    for (std::size_t i = n - 1; i-- > 0;) {
      size[i] = std::min(size[i], size[i + 1] + most);
    }
    if (closed) {
      size.front() = size.back() = std::min(size.front(), size.back());
    }
  }
}

/// Of an open front near the end `from_end` away, for sections not to meet; no limit farther in.
double radius_by_shear(double lean, double from_end, double bend, double length) {
  const double most = most_run_together - steepest_shear / fewest_radii * std::min(1.0, lean);
  const double radius = std::min(bend > 0.0 ? most / bend : std::numeric_limits<double>::max(),
                                 most_run_together / (bend + 2.0 * steepest_shear * lean / length));
  return from_end < shear_fade_length(radius, lean * radius, length)
             ? radius
             : std::numeric_limits<double>::max();
}

} // namespace

double shear_fade_length(double radius, double sheared, double front_length) {
  return std::min(fewest_radii * std::max(radius, sheared), 0.5 * front_length);
}

double TubeSizes::radius_at(double at) const {
  const double step = s[1] - s[0];
  const double place = std::clamp((at - s[0]) / step, 0.0, static_cast<double>(s.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), s.size() - 2);
  const double part = place - static_cast<double>(i);
  return (1.0 - part) * radius[i] + part * radius[i + 1];
}

std::vector<double> TubeSizes::numbers() const {
  std::vector<double> number{0.0};
  for (std::size_t i = 1; i < s.size(); ++i) {
    number.push_back(number.back() +
                     0.5 * (s[i] - s[i - 1]) * (1.0 / length[i] + 1.0 / length[i - 1]));
  }
  return number;
}

std::vector<double> TubeSizes::stations(bool closed) const {
  const std::vector<double> number = numbers();
  const auto wanted = static_cast<std::size_t>(std::ceil(number.back() - same));
  const std::size_t elements =
      std::max<std::size_t>(wanted, closed ? fewest_of_closed : fewest_of_open);
  std::vector<double> result{s.front()};
  std::size_t i = 1;
  for (std::size_t k = 1; k < elements; ++k) {
    const double at = number.back() * static_cast<double>(k) / static_cast<double>(elements);
    while (number[i] < at) {
      ++i;
    }
    result.push_back(s[i - 1] +
                     (s[i] - s[i - 1]) * (at - number[i - 1]) / (number[i] - number[i - 1]));
  }
  if (!closed) {
    result.push_back(s.back());
  }
  return result;
}

TubeSizes tube_sizes(const FrontCurve& curve, const TubeSizeLimits& room,
                     const TubeMeshParameters& given) {
  TubeSizes sizes;
  const double step = curve.length() / static_cast<double>(samples);
  for (std::size_t i = 0; i <= samples; ++i) {
    const FrontFrame frame = curve.at(static_cast<double>(i) * step);
    const double width = room.width(frame.s);
    const double bend = std::abs(frame.curvature());
    const double round = bend > 0.0 ? 1.0 / bend : std::numeric_limits<double>::max();
    sizes.s.push_back(static_cast<double>(i) * step);
    sizes.room.push_back(room.free(frame.s));
    double radius = given.radius;
    if (radius <= 0.0) {
      radius = given.size > 0.0 ? given.size * given.rings : radius_of_width * width;
      const double bent = given.tube ? radius_of_curvature : free_of_curvature;
      radius = std::min({radius, bent * round, radius_of_room * sizes.room.back()});
      if (room.straight) {
        radius = std::min(radius, radius_of_straight * room.straight(frame.s));
      }
      for (const std::size_t end : {0U, 1U}) {
        const double from_end = end == 0 ? frame.s : curve.length() - frame.s;
        if (given.tube && !curve.closed()) {
          radius =
              std::min(radius, radius_by_shear(room.lean[end], from_end, bend, curve.length()));
        }
      }
    }
    sizes.radius.push_back(radius / given.finer);
    double length = std::min(length_of_width * width, length_of_curvature * round);
    if (!curve.closed()) {
      const double from_end = std::min(frame.s, curve.length() - frame.s);
      length = std::min(length, length_at_surface * std::min(width, round) +
                                    growth_from_surface * std::max(from_end, 0.0));
    }
    sizes.length.push_back((given.length > 0.0 ? given.length : length) / given.finer);
  }
  smooth(sizes.radius, step, curve.closed());
  smooth(sizes.length, step, curve.closed(), curve.closed() ? steepest : growth_from_surface);
  if (given.length <= 0.0) {
    const double least = curve.closed() ? shortest : shortest_at_surface;
    for (std::size_t i = 0; i < sizes.s.size(); ++i) {
      sizes.length[i] =
          std::clamp(sizes.length[i], least * sizes.radius[i], longest * sizes.radius[i]);
      if (room.straight) { // thin for its bends
        const double all_bends = curve.at(sizes.s[i]).dt.norm();
        sizes.length[i] = std::min(sizes.length[i], std::sqrt(length_of_arc * sizes.radius[i] /
                                                              std::max(all_bends, same)));
      }
    }
  }
  return sizes;
}

} // namespace spricka::mesh
