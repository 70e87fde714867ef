// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_front.hpp"
#include "analysis/recover/load_paths.hpp"
#include "analysis/recover/path_functions.hpp"
#include "analysis/steps/solid_face_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

/// K along fronts in space on load paths.
namespace spricka::analysis {

namespace {

// K1, K2, K3 of a point that a front begins with.
struct FrontStart {
  const FrontWithDomains& at;
  Eigen::Index first = 0; ///< among the functionals
};

results::LoadPathFront follow_front(const FrontStart& front, const solve::SolutionPath& found,
                                    const results::FrontResult& is) {
  results::LoadPathFront out;
  out.is = is;
  for (const results::FrontPointResult& place : is.points) {
    out.points.emplace_back().is = place;
  }
  out.is.points.clear();
  out.is.sensitivities = {};
  const std::size_t n = out.points.size();
  std::vector<std::array<std::vector<double>, 3>> value(n);
  std::vector<std::array<std::vector<double>, 3>> slope(n);
  for (const solve::PathSegment& s : found.segments) {
    const auto values = smooth_front_K(front.at, s.value, front.first);
    const auto slopes = smooth_front_K(front.at, s.slope, front.first);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        value[i][k].push_back(values[i][k]);
        slope[i][k].push_back(slopes[i][k]);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    results::LoadPathFrontPoint& point = out.points[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Index at = front.first + static_cast<Eigen::Index>(3 * i + k);
      point.K[k] = path_functional(found, at);
      point.smooth[k] =
          base::PiecewiseLinear(path_knots(found), std::move(value[i][k]), std::move(slope[i][k]));
    }
  }
  return out;
}

// The lowest K1 of the points inside the body, and the largest of any mode, on the whole path.
struct FrontKRange {
  double lowest = 0.0, largest = 0.0;
};
FrontKRange range_of(const results::LoadPathFront& front) {
  FrontKRange range;
  for (const results::LoadPathFrontPoint& point : front.points) {
    if (point.is.at_surface) {
      continue;
    }
    range.lowest = std::min(range.lowest, point.K[0].lowest());
    for (const base::PiecewiseLinear& K : point.K) {
      range.largest = std::max({range.largest, std::abs(K.lowest()), std::abs(K.highest())});
    }
  }
  return range;
}

// K1 is 0 where the faces of the crack touch, as steps have it; at how many points on some part of
// the path. rows: [point] among those of the path's problem.
std::size_t close_points(const std::vector<std::optional<std::size_t>>& rows,
                         const solve::SolutionPath& found, results::LoadPathFront& front) {
  std::size_t touching = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    results::LoadPathFrontPoint& point = front.points[i];
    if (!rows[i] || !zero_where_closed(found, *rows[i], point.K[0])) {
      continue;
    }
    ++touching;
    zero_where_closed(found, *rows[i], point.smooth[0]);
  }
  return touching;
}

// The largest difference to K of a step.
double apart_from(const results::LoadPathFront& front, double t, const results::FrontResult& step) {
  double apart = 0.0;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const results::FrontPointResult& own = step.points[i];
    const std::array<double, 3> K{own.K1, own.K2, own.K3};
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = front.points[i].K[k](t);
      // Of faces in contact steps take what the mesh finds a little below 0 for 0.
      const bool at_zero = k == 0 && K[k] == 0.0;
      apart = std::max(apart, std::abs((at_zero ? std::max(0.0, value) : value) - K[k]));
    }
  }
  return apart;
}

} // namespace

std::vector<std::optional<std::size_t>>
LoadPathSolver::rows_behind(std::size_t f, const std::vector<std::size_t>& in_force) const {
  std::vector<std::optional<std::size_t>> out;
  const mesh::CrackFront& front = scene_.fronts[f].front;
  for (const std::optional<std::size_t>& row : rows_at_front(scene_, front)) {
    std::optional<std::size_t>& place = out.emplace_back();
    if (!row) {
      continue;
    }
    const std::size_t pair = scene_.crack_face_pairs[front.crack.index()]->pair;
    const auto at = std::ranges::find(in_force, scene_.table.first[pair] + *row);
    if (at != in_force.end()) {
      place = static_cast<std::size_t>(at - in_force.begin());
    }
  }
  return out;
}

base::Matrix LoadPathSolver::front_columns(Eigen::Index first, Eigen::Index most) const {
  return base::Matrix(front_rows_.middleCols(first, std::min(most, front_rows_.cols() - first)));
}

void LoadPathSolver::fronts(const solve::SolutionPath& found, const LoadPathEnd& from,
                            const LoadPathEnd& to, results::LoadPathResult& path) const {
  double size = 0.0;
  double apart = 0.0;
  const crack::KLayout layout = scene_.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene_.fronts.size(); ++f) {
    results::LoadPathFront front =
        follow_front({scene_.fronts[f], layout.first_index(first)}, found, from.result.fronts[f]);
    first += front.points.size();
    const std::size_t touching = close_points(rows_behind(f, from.problem.rows), found, front);
    if (touching > 0) {
      path.notes.push_back(results::note(fmt::format(
          "{}: the crack faces touch at {} of {} points of the front on a part of the path: "
          "K1 = 0 there",
          front.is.name, touching, front.points.size())));
    }
    const FrontKRange range = range_of(front);
    size = std::max(size, range.largest);
    front.is.invalid_reason.clear();
    for (const LoadPathEnd* end : {&from, &to}) {
      if (const std::string& invalid_reason = end->result.fronts[f].invalid_reason;
          !invalid_reason.empty() && front.is.invalid_reason.empty()) {
        front.is.invalid_reason = invalid_reason;
        path.notes.push_back(results::invalid_result_note(
            fmt::format("{}: at an end of the path {}", front.is.name, invalid_reason)));
      }
    }
    const bool bear = scene_.crack_face_pairs[scene_.fronts[f].front.crack.index()].has_value();
    const double allowed = bear ? worst_open_front : 1e-9;
    if (front.is.invalid_reason.empty() && range.lowest < -allowed * range.largest) {
      path.notes.push_back(results::invalid_result_note(
          fmt::format("{}: K1 is negative at some points on a part of the path: there this K is "
                      "not an answer ({})",
                      front.is.name,
                      bear ? "the mesh at the front is too coarse" : "the crack faces overlap")));
    }
    for (const auto& [t, end] : {std::pair(0.0, &from), std::pair(1.0, &to)}) {
      if (found.end >= t) {
        apart = std::max(apart, apart_from(front, t, end->result.fronts[f]));
      }
    }
    path.fronts.push_back(std::move(front));
  }
  path.mismatch = size > 0.0 ? apart / size : 0.0;
  warn_of_mismatch(path);
}

} // namespace spricka::analysis
