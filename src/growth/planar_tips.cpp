// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/planar_tips.hpp"

#include "base/damaged_field.hpp"
#include "geometry/polyline.hpp"
#include "growth/crack_lines.hpp"
#include "growth/smooth_line.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

/// Turn [rad] of an advance.
constexpr double turn_of_advance = 0.3;

double angle_of(const base::Vec3& d) {
  return std::atan2(d.y(), d.x());
}

base::Vec3 unit(double angle) {
  return {std::cos(angle), std::sin(angle), 0.0};
}

// Of the crack's last part at a tip, away from the crack.
base::Vec3 last_part(const mesh::CrackLine& line, bool at_first) {
  const std::vector<base::Vec3>& p = line.points;
  return (at_first ? p[0] - p[1] : p.back() - p[p.size() - 2]).normalized();
}

const base::Vec3& tip_point(const mesh::CrackLine& line, bool at_first) {
  return at_first ? line.points.front() : line.points.back();
}

// Tips of the cracks that grow, in the order of the cracks.
std::vector<TrackedTip> growing_tips(const model::Model& model,
                                     const std::vector<mesh::CrackLine>& lines) {
  std::vector<TrackedTip> tips;
  const auto add = [&](std::string name, std::size_t line, bool at_first) {
    tips.push_back({.name = std::move(name), .line = line, .at_first = at_first});
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_growing_crack(model, lines[i].crack.index())) {
      continue;
    }
    if (lines[i].embedded) {
      add(lines[i].name + ".1", i, true);
      add(lines[i].name + ".2", i, false);
    } else {
      add(lines[i].name, i, false);
    }
  }
  return tips;
}

} // namespace

PlanarTips::PlanarTips(const model::Model& model, std::vector<mesh::CrackLine> lines)
    : model_(model), lines_(std::move(lines)), around_(model.mesh) {
  tips_ = growing_tips(model, lines_);
}

bool PlanarTips::can_kink() const {
  return model_.growth->direction != model::GrowthDirection::path;
}

void PlanarTips::resume_from(const GrowthState& state) {
  if (state.cracks.size() != lines_.size()) {
    throw base::CorruptStoredField("crack.kind", "it has other cracks than the deck");
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (state.cracks[i].points.size() < 2) {
      throw base::CorruptStoredField("crack.points", "a crack without a line");
    }
    lines_[i].points = state.cracks[i].points;
  }
}

CrackGeometry PlanarTips::current_cracks() {
  trial_ = lines_;
  return {.lines = trial_};
}

double PlanarTips::initial_tip_extent(std::size_t tip) const {
  const mesh::CrackLine& line = lines_[tips_[tip].line];
  return (line.embedded ? 0.5 : 1.0) * geometry::polyline_length(line.points);
}

TipGrowthDirection PlanarTips::heading_of(const GrowthState& state, std::size_t tip) const {
  const TrackedTip& t = tips_[tip];
  const mesh::CrackLine& line = lines_[t.line];
  // Where cracks turn, the way on is that found at the last station; else the crack's own.
  const double angle = state.stations.empty() || !can_kink()
                           ? angle_of(last_part(line, t.at_first))
                           : state.stations.back().tips[tip].heading;
  return {tip_point(line, t.at_first), unit(angle)};
}

// To AMAX and to the last node of a path.
double PlanarTips::remaining_growth_length(const GrowthState& state, std::size_t tip) const {
  const mesh::CrackLine& line = lines_[tips_[tip].line];
  double longest = model_.growth->last_length.value_or(std::numeric_limits<double>::infinity());
  if (!line.path.empty() && !can_kink()) {
    std::vector<base::Vec3> path;
    for (const base::NodeId n : line.path) {
      path.push_back(model_.mesh.x[n.index()]);
    }
    longest = std::min(longest, geometry::polyline_length(path));
  }
  return longest - state.stations.back().tips[tip].a;
}

AdvanceLimit PlanarTips::advance_limit(const GrowthState& state, std::size_t tip, double share,
                                       double ds) const {
  const TrackedTip& t = tips_[tip];
  const TipStation& here = state.stations.back().tips[tip];
  AdvanceLimit limit{.ds = ds};
  const double left = remaining_growth_length(state, tip);
  if (left <= 1e-9 * here.a) { // AMAX has ended it before
    limit.event =
        GrowthEvent{.kind = GrowthEventKind::path_end,
                    .reason = fmt::format("the path of {} ends at a = {:.6g}", t.name, here.a)};
    return limit;
  }
  limit.ds = std::min(limit.ds, left / share);
  if (can_kink() && state.stations.size() > 1) {
    const TipStation& before = state.stations[state.stations.size() - 2].tips[tip];
    const double curvature = std::abs(tip_path_curvature(before, here));
    // The curvature of the last advance is no guess of the way for a larger turn.
    limit.ds = curvature * limit.ds * share > turn_of_advance
                   ? turn_of_advance / (curvature * share)
                   : limit.ds;
  }
  limit_by_obstacles(state, tip, share, limit);
  return limit;
}

void PlanarTips::limit_by_obstacles(const GrowthState& state, std::size_t tip, double share,
                                    AdvanceLimit& limit) const {
  const TrackedTip& t = tips_[tip];
  const double a = state.stations.back().tips[tip].a;
  const TipGrowthDirection heading = heading_of(state, tip);
  if (const auto edge = around_.edge_ahead(lines_[t.line], heading)) {
    limit_advance_by_obstacle(
        edge_policy,
        {.distance = edge->distance,
         .part = edge->distance / a,
         .reason = fmt::format("{} reaches {}: {:.3g} is left of the ligament, in which "
                               "K grows without bound",
                               t.name, edge->what, edge->distance)},
        share, false, limit);
  }
  const auto crack = PlaneBoundaryAhead::crack_ahead(lines_, t.line, heading);
  if (crack && !limit.event) {
    limit_advance_by_obstacle(plane_crack_policy,
                              {.distance = crack->distance,
                               .part = crack->distance / a,
                               .reason = fmt::format("{} meets {}: {:.3g} is left between them",
                                                     t.name, crack->what, crack->distance)},
                              share, false, limit);
  }
}

std::optional<CrackGeometry> PlanarTips::advance_cracks(const GrowthState& state,
                                                        const AdvanceToNextStation& advance,
                                                        base::Diagnostics& diagnostics) {
  if (can_kink()) {
    std::vector<mesh::CrackLine> lines = lines_;
    for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
      extend(state, tip, advance.by[tip], lines[tips_[tip].line]);
    }
    trial_ = std::move(lines);
    return CrackGeometry{.lines = trial_};
  }
  // On ways that the deck draws, lines are cut anew to the arms; zero stands for the first length.
  std::vector<CrackLengthsByTip> arms(model_.cracks.size());
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    CrackLengthsByTip& of = arms[lines_[tips_[tip].line].crack.index()];
    (tips_[tip].at_first ? of.first : of.last) =
        state.stations.back().tips[tip].a + advance.by[tip];
  }
  std::optional<std::vector<mesh::CrackLine>> lines = crack_lines(model_, arms, diagnostics);
  if (!lines) {
    return std::nullopt;
  }
  trial_ = std::move(*lines);
  return CrackGeometry{.lines = trial_};
}

// An arc that goes on with the curvature of the last advance, as a polyline with small kinks.
void PlanarTips::extend(const GrowthState& state, std::size_t tip, double by,
                        mesh::CrackLine& line) const {
  const bool at_first = tips_[tip].at_first;
  if (by <= 0.0) {
    return;
  }
  std::vector<base::Vec3>& points = line.points;
  if (at_first) {
    std::reverse(points.begin(), points.end());
  }
  const double before = angle_of((points.back() - points[points.size() - 2]).normalized());
  const TipStation& here = state.stations.back().tips[tip];
  double curvature = 0.0;
  if (state.stations.size() > 1) {
    curvature = tip_path_curvature(state.stations[state.stations.size() - 2].tips[tip], here);
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(curvature) * by / turn_of_chord)));
  for (int k = 0; k < pieces; ++k) {
    // The heading in the middle of a piece, so that chords follow the arc (growth.10).
    const double angle = here.heading + curvature * by * (k + 0.5) / pieces;
    const base::Vec3 next = points.back() + by / pieces * unit(angle);
    // A kink too small to mean anything would only be one more point for the mesh to meet.
    if (k == 0 && std::abs(std::remainder(angle - before, 2.0 * std::numbers::pi)) < 1e-7) {
      points.back() = next; // straight on
    } else {
      points.push_back(next);
    }
  }
  if (!line.symmetric_half) {
    line.path.clear(); // it leaves the nodes
  }
  if (at_first) {
    std::reverse(points.begin(), points.end());
  }
}

void PlanarTips::evaluate_trial_tips(std::vector<TipStation>& found) const {
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const TrackedTip& t = tips_[tip];
    const mesh::CrackLine& line = trial_[t.line];
    found[tip].heading = angle_of(last_part(line, t.at_first)) + found[tip].turn;
    found[tip].x = tip_point(line, t.at_first).x();
    found[tip].y = tip_point(line, t.at_first).y();
  }
}

void PlanarTips::accept_trial(GrowthState& state) {
  lines_ = trial_;
  state.cracks.clear();
  for (const mesh::CrackLine& line : lines_) {
    state.cracks.emplace_back().points = line.points;
  }
}

std::optional<GrowthEvent> PlanarTips::handle_unmeshable_advance(bool /*passage*/,
                                                                 const std::string& why) {
  return GrowthEvent{.reason = fmt::format("the next advance could not be meshed: {}", why)};
}

CrackGeometry PlanarTips::extend_cracks_straight(const GrowthState& state, double advance) const {
  std::vector<mesh::CrackLine> lines = lines_;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const TipGrowthDirection heading = heading_of(state, tip);
    const auto edge = around_.edge_ahead(lines_[tips_[tip].line], heading);
    // A look ahead must not leave the body.
    const double by = edge ? std::min(advance, 0.9 * edge->distance) : advance;
    std::vector<base::Vec3>& points = lines[tips_[tip].line].points;
    const bool at_first = tips_[tip].at_first;
    const base::Vec3 next = tip_point(lines[tips_[tip].line], at_first) + by * heading.direction;
    if (last_part(lines[tips_[tip].line], at_first).dot(heading.direction) > 1.0 - 1e-12) {
      (at_first ? points.front() : points.back()) = next;
    } else {
      points.insert(at_first ? points.begin() : points.end(), next);
    }
  }
  return {.lines = std::move(lines)};
}

} // namespace spricka::growth
