// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/load_path_fronts.hpp"

#include "analysis/recover/judge_faces.hpp"
#include "analysis/recover/path_functions.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// K1, K2, K3 of the points as a smooth curve along the front.
void smooth_front(const mesh::CrackFront& is, const crack::FrontIntegralDomains& domains,
                  Eigen::Index first, const solve::SolutionPath& found,
                  results::LoadPathFront& front) {
  const std::size_t n = front.points.size();
  std::vector<std::array<std::vector<double>, 3>> value(n);
  std::vector<std::array<std::vector<double>, 3>> slope(n);
  for (const solve::SolutionPathSegment& s : found.segments) {
    const auto values = smooth_K_along_front(is, domains, s.value, first);
    const auto slopes = smooth_K_along_front(is, domains, s.slope, first);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        value[i][k].push_back(values[i][k]);
        slope[i][k].push_back(slopes[i][k]);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      front.points[i].smooth[k] =
          base::PiecewiseLinear(path_knots(found), std::move(value[i][k]), std::move(slope[i][k]));
    }
  }
}

// The lowest K1 of the points inside the body, and the largest of any mode, on the whole path.
struct FrontKRange {
  double lowest = 0.0, largest = 0.0;
};
FrontKRange range_of(const results::LoadPathFront& front) {
  FrontKRange range;
  for (const results::LoadPathFrontPoint& point : front.points) {
    if (point.point_at_start.at_surface) {
      continue;
    }
    range.lowest = std::min(range.lowest, point.K[0].smallest_value());
    for (const base::PiecewiseLinear& K : point.K) {
      range.largest =
          std::max({range.largest, std::abs(K.smallest_value()), std::abs(K.largest_value())});
    }
  }
  return range;
}

// K1 is 0 where the faces of the crack touch, as steps have it; at how many points on some part of
// the path. rows: [point] among those of the path's problem.
std::size_t close_path_points(const std::vector<std::optional<std::size_t>>& rows,
                              const solve::SolutionPath& found, results::LoadPathFront& front) {
  std::size_t touching = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    results::LoadPathFrontPoint& point = front.points[i];
    if (!rows[i] || !zero_K1_where_closed(found, *rows[i], point.K[0])) {
      continue;
    }
    ++touching;
    zero_K1_where_closed(found, *rows[i], point.smooth[0]);
  }
  return touching;
}

void tell_touching(std::size_t touching, bool tip, const results::LoadPathFront& front,
                   results::LoadPathResult& path) {
  if (touching > 0) {
    const std::string where =
        tip ? "at the tip"
            : fmt::format("at {} of {} points of the front", touching, front.points.size());
    path.notes.push_back(results::make_note(
        fmt::format("{}: the crack faces touch {} on a part of the path: K1 = 0 there",
                    front.front_without_points.name, where)));
  }
}

void tell_negative_tip(bool of_law, const results::LoadPathFront& front,
                       results::LoadPathResult& path) {
  const base::PiecewiseLinear& K1 = front.single_point().K[0];
  if (!(K1.smallest_value() < -1e-9 * K1.largest_value())) {
    return;
  }
  path.notes.push_back(
      of_law ? results::make_note(
                   fmt::format("{}: K1 is negative on a part of the path, as FACES=FREE "
                               "lets the crack faces overlap: the law of $GROW knows it "
                               "as a K_min",
                               front.front_without_points.name))
             : results::invalid_result_note(fmt::format(
                   "{}: K1 is negative on a part of the path: there this K is not an "
                   "answer (the crack faces overlap, or the mesh at the tip is too coarse)",
                   front.front_without_points.name)));
}

void tell_negative_front(bool bear, const FrontKRange& range, const results::LoadPathFront& front,
                         results::LoadPathResult& path) {
  const double allowed = bear ? worst_open_front : 1e-9;
  if (front.front_without_points.invalid_reason.empty() &&
      range.lowest < -allowed * range.largest) {
    path.notes.push_back(results::invalid_result_note(
        fmt::format("{}: K1 is negative at some points on a part of the path: there this K is "
                    "not an answer ({})",
                    front.front_without_points.name,
                    bear ? "the mesh at the front is too coarse" : "the crack faces overlap")));
  }
}

// The front is in doubt where it is at an end of the path, but for K1 < 0 of a tip, which is
// reported of the path.
void mark_invalid_end(const results::FrontResult& end, results::LoadPathFront& front,
                      results::LoadPathResult& path) {
  const bool is_reported = end.is_tip() && end.single_point().K1 < 0.0;
  if (!end.invalid_reason.empty() && front.front_without_points.invalid_reason.empty() &&
      !is_reported) {
    front.front_without_points.invalid_reason = end.invalid_reason;
    path.notes.push_back(results::invalid_result_note(fmt::format(
        "{}: at an end of the path {}", front.front_without_points.name, end.invalid_reason)));
  }
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

// Whether K is scaled to a G by nodes that are moved, which makes it no linear functional of u.
bool is_shifted(const model::Model& model, base::CrackId crack) {
  return std::ranges::any_of(model.vces, [&](const model::VirtualCrackExtensionSettings& vce) {
    return vce.crack == crack && vce.shift.has_value();
  });
}

// [point of front f] its row among those in force, if faces bear behind it.
std::vector<std::optional<std::size_t>> rows_behind(const Discretisation& scene, std::size_t f,
                                                    const std::vector<std::size_t>& in_force) {
  std::vector<std::optional<std::size_t>> rows =
      find_face_row_by_front_point(scene, scene.cracked.fronts[f]);
  for (std::optional<std::size_t>& row : rows) {
    const auto at = row ? std::ranges::find(in_force, *row) : in_force.end();
    row = at != in_force.end() ? std::optional(static_cast<std::size_t>(at - in_force.begin()))
                               : std::nullopt;
  }
  return rows;
}

// K1, K2, K3 of the points of a front by t, which begin among the functionals at `first`.
results::LoadPathFront follow_front(const Discretisation& scene, std::size_t f, Eigen::Index first,
                                    const solve::SolutionPath& found,
                                    const results::FrontResult& is) {
  results::LoadPathFront out;
  out.front_without_points = is;
  out.front_without_points.points.clear();
  out.front_without_points.sensitivities = {};
  out.front_without_points.invalid_reason.clear();
  const Eigen::Index modes = scene.k_layout().mode_count();
  const std::vector<double> zeros(found.segments.size(), 0.0);
  for (std::size_t i = 0; i < is.points.size(); ++i) {
    results::LoadPathFrontPoint& point = out.points.emplace_back();
    point.point_at_start = is.points[i];
    std::ranges::for_each(point.point_at_start.bar,
                          [](results::KErrorBar& bar) { bar.of_element.clear(); });
    point.K.fill({path_knots(found), zeros, zeros});
    for (Eigen::Index k = 0; k < modes; ++k) {
      point.K[static_cast<std::size_t>(k)] =
          path_functional(found, first + modes * static_cast<Eigen::Index>(i) + k);
    }
    point.smooth = point.K;
  }
  if (!scene.cracked.fronts[f].is_tip()) {
    smooth_front(scene.cracked.fronts[f], scene.domains[f], first, found, out);
  }
  return out;
}

} // namespace

void add_front_K_to_path(const model::Model& model, const Discretisation& scene,
                         const solve::SolutionPath& found, const LoadPathEndStep& from,
                         const LoadPathEndStep& to, results::LoadPathResult& path) {
  double size = 0.0;
  double apart = 0.0;
  const crack::KLayout layout = scene.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    const results::FrontResult& is = from.result.fronts[f];
    const base::CrackId crack = scene.cracked.fronts[f].crack;
    results::LoadPathFront front =
        follow_front(scene, f, layout.first_mode_index(first), found, is);
    first += front.points.size();
    if (is.is_tip()) { // before its faces touch
      const base::PiecewiseLinear& K1 = front.single_point().K[0];
      size = std::max({size, std::abs(K1.smallest_value()), std::abs(K1.largest_value())});
    }
    tell_touching(close_path_points(rows_behind(scene, f, from.problem.rows), found, front),
                  is.is_tip(), front, path);
    if (is.is_tip()) {
      tell_negative_tip(model.growth && model.growth->spectrum &&
                            !model.cracks[crack.index()].faces_in_contact,
                        front, path);
    }
    mark_invalid_end(from.result.fronts[f], front, path);
    mark_invalid_end(to.result.fronts[f], front, path);
    if (!is.is_tip()) {
      const FrontKRange range = range_of(front);
      size = std::max(size, range.largest);
      tell_negative_front(scene.crack_face_pairs[crack.index()].has_value(), range, front, path);
    }
    if (is_shifted(model, crack)) {
      path.notes.push_back(
          results::make_note(fmt::format("{}: K on the path is the analytic one, without the SHIFT "
                                         "of $VCE",
                                         front.front_without_points.name)));
    } else {
      for (const auto& [t, end] : {std::pair(0.0, &from), std::pair(1.0, &to)}) {
        if (found.end >= t) {
          const results::FrontResult& own = end->result.fronts[f];
          // What is below 0 has been reported already.
          apart = std::max(apart, apart_from(front, t, own));
          size = is.is_tip() ? std::max(size, std::abs(own.single_point().K1)) : size;
        }
      }
    }
    path.fronts.push_back(std::move(front));
  }
  path.mismatch = size > 0.0 ? apart / size : 0.0;
  warn_of_K_mismatch(path);
}

// What the mesh finds a little below 0 for faces in contact is 0, as in steps
// (judge_K_by_faces_and_materials).
void smooth_K_on_all_fronts(const Discretisation& scene, base::Vector& value) {
  const crack::KLayout layout = scene.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene.cracked.fronts[f];
    if (front.is_tip()) {
      continue;
    }
    const bool bear = scene.crack_face_pairs[front.crack.index()].has_value();
    const auto smooth =
        smooth_K_along_front(front, scene.domains[f], value, layout.first_mode_index(first));
    for (const std::array<double, 3>& K : smooth) {
      layout.segment_of_point(value, first++) << (bear ? std::max(0.0, K[0]) : K[0]), K[1], K[2];
    }
  }
}

// Faces that touch do not part there: what is left is the error of the mesh.
void zero_K1_at_closed_points(const Discretisation& scene, const std::vector<std::size_t>& in_force,
                              const std::vector<bool>& closed, base::Vector& value) {
  const crack::KLayout layout = scene.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    const std::vector<std::optional<std::size_t>> rows = rows_behind(scene, f, in_force);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] && closed[*rows[i]]) {
        value[layout.at(first + i, 1)] = 0.0;
      }
    }
    first += scene.cracked.fronts[f].points.size();
  }
}

} // namespace spricka::analysis
