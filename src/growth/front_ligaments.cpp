// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_ligaments.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Ends on the surface look along it from a little further in, as a part of the front.
constexpr double further_in = 0.02;
/// A front that has less than this part of the way to a surface before it is looked at between its
/// points, too, at so many places for each.
constexpr double near_surface = 0.5;
constexpr std::size_t looks_between = 8;
/// A crack reaches back by as much of the way from its place at least.
constexpr double least_reach = 0.3;
/// Sine of the angle below which a line runs along a surface rather than to it: 30 degrees.
constexpr double grazing = 0.5;

double number_of(std::size_t place) {
  return static_cast<double>(place) / static_cast<double>(looks_between);
}

// Runs of places that stay, in the order along a front; a closed one opens where places are left
// out, it then begins behind that.
std::vector<std::vector<std::size_t>> staying_runs(const std::vector<bool>& stays, bool closed) {
  const auto out = std::ranges::find(stays, false);
  const auto begin =
      closed && out != stays.end() ? static_cast<std::size_t>(out - stays.begin()) : 0;
  std::vector<std::vector<std::size_t>> runs(1);
  for (std::size_t k = 0; k < stays.size(); ++k) {
    const std::size_t i = (begin + k) % stays.size();
    if (stays[i]) {
      runs.back().push_back(i);
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  if (runs.back().empty()) {
    runs.pop_back();
  }
  return runs;
}

} // namespace

void FrontLigaments::measure_ligaments(const MovingFronts& fronts, std::size_t tips) {
  at_tip_.assign(tips, {});
  between_.clear();
  for (const GrowingFront& of : fronts.growing) {
    between_.push_back(look_ahead(fronts.cracks[of.crack], of));
  }
}

FrontLigaments::Ligaments FrontLigaments::look_ahead(const model::CrackDefinition& crack,
                                                     const GrowingFront& of) {
  const BodyFrontArc& arc = of.arc;
  std::vector<std::size_t> own;
  const Vec3 middle = arc.curve.at(0.5 * arc.curve.length()).x;
  for (const double s : {0.0, arc.curve.length()}) {
    const auto piece = around_.surface_piece(arc.curve.at(s).x, middle, crack.net);
    if (!arc.is_closed() && piece) {
      own.push_back(*piece);
    }
  }
  const std::size_t count = of.tips.size();
  bool near = false;
  for (std::size_t i = 0; i < count; ++i) {
    std::optional<LigamentDepths>& before = at_tip_[of.tips[i]];
    before = ligament_at(crack, of, static_cast<double>(i), own);
    near = near || (before && before->ligament_to_depth_ratio() < near_surface);
  }
  Ligaments between;
  const std::size_t places =
      arc.is_closed() ? count * looks_between : (count - 1) * looks_between + 1;
  for (std::size_t k = 0; near && k < places; ++k) {
    between.push_back(ligament_at(crack, of, number_of(k), own));
  }
  return between;
}

std::optional<LigamentDepths>
FrontLigaments::ligament_at(const model::CrackDefinition& crack, const GrowingFront& of,
                            double number, const std::vector<std::size_t>& own) const {
  const BodyFrontArc& arc = of.arc;
  const double edge = arc.is_closed() ? 0.0 : further_in * arc.curve.length();
  const double s =
      std::clamp(arc.arc_position(number, of.tips.size()), edge, arc.curve.length() - edge);
  const mesh::FrontFrame at = arc.curve.at(s);
  // The surface that an end lies on is none ahead: the front slides along it.
  const Vec3 way = kinks_.tip_growth_direction(at, of.nearest_tip(number), 0.0);
  const auto ahead = around_.surface_ahead(at.x, way, crack.net);
  if (!ahead || std::ranges::find(own, ahead->piece) != own.end()) {
    return std::nullopt;
  }
  return LigamentDepths{.behind = reach_back(crack, of, at.x, way), .left = ahead->distance};
}

// Towards a far face a wide crack reaches back by its depth, not by the way from its place.
double FrontLigaments::reach_back(const model::CrackDefinition& crack, const GrowingFront& of,
                                  const Vec3& x, const Vec3& way) const {
  const Vec3 whole = x - crack.plane.place;
  if (of.arc.is_closed()) {
    return std::max(whole.dot(way), least_reach * whole.norm());
  }
  const auto back = around_.surface_ahead(x, -way, crack.net);
  // Beside an end of the front it is the surface along which that runs.
  const bool met = back && back->sine > grazing;
  return met ? std::min(whole.norm(), back->distance) : whole.norm();
}

std::vector<FrontPointRun>
FrontLigaments::remaining_point_runs(const GrowingFront& of, std::size_t number, double gap,
                                     const std::vector<double>& by) const {
  const auto stays = [&](const std::optional<LigamentDepths>& before, double at) {
    return !before || (before->ligament_to_depth_ratio() > gap &&
                       (by.empty() || before->left > of.advance_between(at, by)));
  };
  std::vector<bool> points;
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    points.push_back(stays(at_tip_[of.tips[i]], static_cast<double>(i)));
  }
  std::vector<FrontPointRun> found;
  std::size_t fewest = of.tips.size();
  for (const std::vector<std::size_t>& run : staying_runs(points, of.arc.is_closed())) {
    fewest = std::min(fewest, run.size());
    found.emplace_back(run.begin(), run.end());
  }
  const Ligaments& between = between_[number];
  if ((!found.empty() && fewest >= fewest_front_points) || between.empty()) {
    std::erase_if(found, [](const FrontPointRun& run) { return run.size() < fewest_front_points; });
    return found;
  }
  std::vector<bool> places;
  for (std::size_t k = 0; k < between.size(); ++k) {
    places.push_back(stays(between[k], number_of(k)));
  }
  found.clear();
  for (const std::vector<std::size_t>& run : staying_runs(places, of.arc.is_closed())) {
    if (run.size() <= looks_between) {
      continue;
    }
    const std::size_t count = std::max(fewest_front_points, run.size() / looks_between + 1);
    FrontPointRun& spread = found.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      spread.push_back(number_of(run[i * (run.size() - 1) / (count - 1)]));
    }
  }
  return found;
}

} // namespace spricka::growth
