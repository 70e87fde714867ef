// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/half_axes.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace spricka::results {

using base::Vec3;

namespace {

// An end of the front counts as the end of an axis up to this angle from it: a bore or a corner
// lies askew to the axes.
constexpr double beside_axis = 0.45; // its sine

// Sine of the parametric angle inside an end on a surface at which values are taken, as life
// programs do: 10 degrees. Beside a bore K rises in a narrow peak.
constexpr double inside_end = 0.17365;

// Where a front crosses the ray from the crack's place along `way`, or ends beside it.
std::optional<FrontAxisEnd> end_on(const std::vector<Vec3>& points, bool closed, const Vec3& place,
                                   const Vec3& way, const Vec3& aside) {
  const std::size_t n = points.size();
  const auto off = [&](std::size_t i) { return (points[i] - place).dot(aside); };
  const auto ahead = [&](std::size_t i) { return (points[i] - place).dot(way) > 0.0; };
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::size_t k = (i + 1) % n;
    if (ahead(i) && ahead(k) && (off(i) <= 0.0) != (off(k) <= 0.0)) {
      const double part = off(i) / (off(i) - off(k));
      const Vec3 x = (1.0 - part) * points[i] + part * points[k];
      return FrontAxisEnd{.from = i, .to = k, .part = part, .size = (x - place).norm()};
    }
  }
  std::optional<FrontAxisEnd> nearest;
  double least = beside_axis;
  for (const std::size_t i : {std::size_t{0}, n - 1}) {
    const double size = (points[i] - place).norm();
    if (!closed && ahead(i) && std::abs(off(i)) < least * size) {
      least = std::abs(off(i)) / size;
      nearest = FrontAxisEnd{.from = i, .to = i, .size = size};
    }
  }
  return nearest;
}

// Of an end on a surface: to where the front is so far beside the axis.
void move_inside(const std::vector<Vec3>& points, const Vec3& place, const Vec3& beside,
                 FrontAxisEnd& end) {
  const std::size_t n = points.size();
  const bool at_first = end.from == 0 && end.to <= 1;
  const bool at_last = end.to == n - 1 && end.from + 2 >= n;
  const auto off = [&](std::size_t k) {
    return std::abs((points[at_first ? k : n - 1 - k] - place).dot(beside.normalized()));
  };
  for (std::size_t k = 0; k + 1 < n && (at_first || at_last); ++k) {
    if (off(k + 1) >= beside.norm()) {
      const double part = (beside.norm() - off(k)) / (off(k + 1) - off(k));
      end.from = at_first ? k : n - 1 - k;
      end.to = at_first ? k + 1 : n - 2 - k;
      end.part = std::clamp(part, 0.0, 1.0);
      return;
    }
  }
}

} // namespace

std::vector<FrontAxisEnd> find_front_axis_ends(const model::CrackDefinition& crack,
                                               const std::vector<Vec3>& points, bool closed) {
  const model::PlanarCrack& plane = crack.plane;
  std::vector<FrontAxisEnd> ends;
  for (const bool on_a : {true, false}) {
    const Vec3 way = on_a ? plane.transverse_axis() : plane.along;
    const Vec3 aside = on_a ? plane.along : plane.transverse_axis();
    std::array<std::optional<FrontAxisEnd>, 2> both{
        end_on(points, closed, plane.place, way, aside),
        end_on(points, closed, plane.place, -way, aside)};
    for (std::size_t k = 0; k < 2; ++k) {
      if (both.at(k)) {
        FrontAxisEnd& end = ends.emplace_back(*both.at(k));
        end.on_a = on_a;
        end.tip = fmt::format("{}.{}{}", crack.name, on_a ? "A" : "C",
                              !(both[0] && both[1]) ? ""
                              : k == 0              ? "1"
                                                    : "2");
      }
    }
  }
  const std::array<double, 2> half = half_axes(ends);
  for (FrontAxisEnd& end : ends) {
    const Vec3 aside = end.on_a ? half[1] * plane.along : half[0] * plane.transverse_axis();
    if (!closed && aside.norm() > 0.0) {
      move_inside(points, plane.place, inside_end * aside, end);
    }
  }
  return ends;
}

std::array<double, 2> half_axes(const std::vector<FrontAxisEnd>& ends) {
  std::array<double, 2> half{};
  for (const bool on_a : {true, false}) {
    double sum = 0.0;
    int count = 0;
    for (const FrontAxisEnd& end : ends) {
      sum += end.on_a == on_a ? end.size : 0.0;
      count += end.on_a == on_a ? 1 : 0;
    }
    half.at(on_a ? 0 : 1) = count > 0 ? sum / count : 0.0;
  }
  return half;
}

const model::CrackDefinition* find_crack_by_front(const model::Model& model,
                                                  std::string_view front) {
  const auto found = std::ranges::find_if(model.cracks, [&](const model::CrackDefinition& crack) {
    return front == crack.name || front.starts_with(crack.name + ".");
  });
  return found == model.cracks.end() ? nullptr : &*found;
}

} // namespace spricka::results
