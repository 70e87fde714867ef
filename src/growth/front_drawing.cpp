// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_drawing.hpp"

#include "growth/turned_front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::growth {

namespace {

using base::Vec3;

/// A front is laid through its points so many times; what a point may have missed of its advance.
constexpr int rounds = 2;
constexpr double largest_miss = 0.5;
/// Points of the way outside of the body from front to front, and how far apart the middles of
/// fronts drawn alone and together may lie: parts of the front.
constexpr double step_outside = 0.02;
constexpr double same_front = 0.05;

// Tips [front] in order, as many as the runs have points, four at least; all of them have a front.
std::vector<std::vector<std::size_t>> shared_out(const std::vector<std::size_t>& tips,
                                                 const std::vector<std::vector<double>>& runs) {
  std::size_t points = 0;
  for (const auto& run : runs) {
    points += run.size();
  }
  std::vector<std::vector<std::size_t>> shared;
  std::size_t next = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t after = fewest_front_points * (runs.size() - r - 1);
    const std::size_t request = (tips.size() * runs[r].size() + points / 2) / points;
    const std::size_t count =
        r + 1 == runs.size() ? tips.size() - next
                             : std::clamp(request, fewest_front_points, tips.size() - next - after);
    const auto from = tips.begin() + static_cast<std::ptrdiff_t>(next);
    shared.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
    next += count;
  }
  return shared;
}

} // namespace

std::vector<FrontDrawing::NextFront>
FrontDrawing::next_fronts(std::size_t growing, const AdvanceToNextStation& advance) const {
  const GrowingFront& of = from_.growing[growing];
  const bool through = advance.leads_through(GrowthEventKind::breakthrough);
  const double gap =
      through ? passage_policy.left_out * surface_policy.passed * advance.lengthening : -1.0;
  const std::vector<FrontPointRun> runs = ligaments_.remaining_point_runs(
      of, growing, gap, through ? advance.by : std::vector<double>());
  if ((kinks_.may_leave_plane() && runs.size() > 1) ||
      runs.size() * fewest_front_points > of.tips.size()) {
    return {}; // heights of a front history are those behind one; and all have points
  }
  std::vector<std::size_t> tips = of.tips;
  if (runs.size() > 1 && of.arc.is_closed()) { // from the first of them on
    const auto first = static_cast<std::ptrdiff_t>(runs[0].front());
    std::rotate(tips.begin(), tips.begin() + first, tips.end());
  }
  std::vector<NextFront> fronts;
  const std::vector<std::vector<std::size_t>> shared = shared_out(tips, runs);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    NextFront& front = fronts.emplace_back();
    front.tips = shared[r];
    front.next.closed = of.arc.is_closed() && runs.size() == 1 && runs[r].size() == of.tips.size();
    std::vector<mesh::FrontFrame> from;
    for (const double number : runs[r]) {
      const mesh::FrontFrame& at = from.emplace_back(of.frame_between(number));
      const double by = of.advance_between(number, advance.by);
      front.next.points.emplace_back(
          at.x + by * kinks_.tip_growth_direction(at, of.nearest_tip(number), by));
    }
    front.next.points = drop_crossing_points(from, front.next.points, front.next.closed);
  }
  return fronts;
}

bool FrontDrawing::draw_front(const NextFrontPoints& next, GrowingFront& of) {
  model::CrackDefinition& crack = to_.cracks[of.crack];
  std::optional<model::CrackDefinition> drawn;
  if (next.points.size() >= fewest_front_points) {
    drawn = make_crack_through_points(crack, next.points, next.closed, around_);
  }
  if (drawn && kinks_.may_leave_plane()) {
    // Behind what its front has left since the last station that counts.
    const model::CrackDefinition& before = from_.cracks[of.crack];
    drawn->front_history = extend_front_history(
        before, std::ranges::find(from_.growing, of.crack, &GrowingFront::crack)->arc.curve,
        mesh::FrontCurve(next.points, crack_normals(before, next.points), next.closed));
  }
  std::optional<BodyFrontArc> arc =
      drawn ? single_front_arc_in_body(*drawn, around_) : std::nullopt;
  if (!arc) {
    return false;
  }
  of.arc = std::move(*arc);
  of.line = drawn->points;
  crack = std::move(*drawn);
  return true;
}

bool FrontDrawing::draw_successors(std::size_t growing, const AdvanceToNextStation& advance) {
  const GrowingFront& before = from_.growing[growing];
  const std::vector<NextFront> fronts = next_fronts(growing, advance);
  for (const NextFront& front : fronts) {
    GrowingFront of{before.crack, front.tips, before.arc};
    if (!draw_front(front.next, of)) {
      return false;
    }
    if (!advance.passage && front.next.points.size() == of.tips.size()) {
      go_round(before, advance.by, of);
    }
    to_.growing.push_back(std::move(of));
  }
  return !fronts.empty();
}

bool FrontDrawing::draw_crack_fronts_as_one(std::size_t crack) {
  std::vector<GrowingFront*> parts;
  for (GrowingFront& of : to_.growing) {
    if (of.crack == crack) {
      parts.push_back(&of);
    }
  }
  if (parts.size() == 1) {
    return true;
  }
  model::CrackDefinition& drawn = to_.cracks[crack];
  std::vector<Vec3> points = parts.front()->line;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Vec3 from = points.back();
    const Vec3 way = parts[i]->line.front() - from;
    const auto steps =
        static_cast<int>(std::ceil(way.norm() / (step_outside * parts[i]->arc.curve.length())));
    for (int k = 1; k < steps; ++k) {
      points.emplace_back(from + way * k / steps);
      if (around_.inside(points.back(), drawn.net)) {
        return false;
      }
    }
    points.insert(points.end(), parts[i]->line.begin(), parts[i]->line.end());
  }
  drawn.points = std::move(points);
  // As a run that goes on finds them.
  std::vector<BodyFrontArc> arcs = front_arcs_in_body(drawn, around_);
  if (arcs.size() != parts.size()) {
    return false;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto middle = [](const BodyFrontArc& arc) {
      return arc.curve.at(0.5 * arc.curve.length()).x;
    };
    const double apart = (middle(arcs[i]) - middle(parts[i]->arc)).norm();
    if (apart > same_front * arcs[i].curve.length()) {
      return false;
    }
    parts[i]->arc = std::move(arcs[i]);
  }
  return true;
}

// Rates found later count along the front, whose points slide on it to stay evenly spread: each has
// gone its advance at right angles to the mean of the front's directions before and behind.
void FrontDrawing::go_round(const GrowingFront& from, const std::vector<double>& by,
                            GrowingFront& of) {
  if (of.arc.is_closed() != from.arc.is_closed()) {
    return;
  }
  for (int round = 0; round < rounds; ++round) {
    NextFrontPoints next{.points = {}, .closed = of.arc.is_closed()};
    for (std::size_t i = 0; i < of.tips.size(); ++i) {
      const mesh::FrontFrame before = from.frame_at(i);
      const mesh::FrontFrame behind = of.frame_at(i);
      const std::size_t tip = of.tips[i];
      const Vec3 way = (kinks_.tip_growth_direction(before, tip, by[tip]) + behind.m).normalized();
      const double missed = by[tip] - (behind.x - before.x).dot(way);
      if (std::abs(missed) > largest_miss * by[tip]) {
        return; // a notch, or a front that has come to lie otherwise
      }
      next.points.emplace_back(behind.x + missed * behind.m);
    }
    if (!draw_front(next, of)) {
      return;
    }
  }
}

} // namespace spricka::growth
