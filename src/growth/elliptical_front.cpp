// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/elliptical_front.hpp"

#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Parametric angles beside an end of an axis at which the body is looked for [rad].
constexpr std::array beside_end{0.1, 0.2, 0.3, 0.5};
/// Of an end on a surface K is taken so far inside, as a parametric angle, as life programs do (5
/// to 10 degrees): beside a bore K rises in a narrow peak that a whole ellipse does not follow.
/// Where less than a quarter of the ellipse is left in the body it is this part of what is.
constexpr double inside_end = 10.0 * std::numbers::pi / 180.0;
constexpr double inside_part = 1.0 / 9.0;
/// Steps along the ellipse to where it leaves the body, and halvings of the last.
constexpr int steps_inside = 18;
constexpr int halvings = 20;
/// An arm that ends outside of the body grows at most so many times as fast as the front moves: of
/// a front that has become straight the axis that leads out says nothing any more.
constexpr double farthest_extent_rate_ratio = 20.0;
constexpr double same_rate = 1e-9;
/// Points of an ellipse that are looked at.
constexpr int looks_round = 72;

Vec3 outwards(const model::CrackDefinition& crack, double phi) {
  const model::PlanarCrack& p = crack.plane;
  return (std::cos(phi) / p.c * p.along + std::sin(phi) / p.a * p.transverse_axis()).normalized();
}

double angle_at(const model::CrackDefinition& crack, const Vec3& x) {
  const model::PlanarCrack& p = crack.plane;
  const Vec3 off = x - p.place;
  return std::atan2(off.dot(p.transverse_axis()) / p.a, off.dot(p.along) / p.c);
}

double end_angle(bool on_a, double sign) {
  return on_a ? sign * 0.5 * std::numbers::pi : (sign > 0.0 ? 0.0 : std::numbers::pi);
}

// The angle along the ellipse from an end on a surface to where it leaves the body, up to a
// quarter.
double angle_inside(const SolidBodyQuery& around, const model::CrackDefinition& crack, double end,
                    double sign) {
  const auto inside = [&](double angle) {
    return around.inside(crack.plane.ellipse_point(end + sign * angle), crack.net);
  };
  const double step = 0.5 * std::numbers::pi / steps_inside;
  double within = step;
  while (within < 0.5 * std::numbers::pi - 0.5 * step && inside(within + step)) {
    within += step;
  }
  double low = inside(within) ? within : 0.0;
  double high = inside(within) ? within + step : within;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (inside(middle) ? low : high) = middle;
  }
  return low;
}

// The parametric angle at which K of an arm is taken. An end whose other axis has one arm lies on
// the surface that the centre lies on.
double aim_of(const SolidBodyQuery& around, const EllipticalFront::Ellipses& ellipses,
              const PartMovedByTip& arm) {
  const double end = end_angle(arm.on_a, arm.sign);
  for (const PartMovedByTip& other : ellipses.arms) {
    if (other.crack == arm.crack && other.on_a != arm.on_a && !other.paired) {
      const double turn = std::sin(end_angle(other.on_a, other.sign) - end);
      const double sign = std::copysign(1.0, turn);
      const double left = angle_inside(around, ellipses.cracks[arm.crack], end, sign);
      return end + sign * std::min(inside_end, inside_part * left);
    }
  }
  return end;
}

CrackGeometry geometry_of(const SolidBodyQuery& around, const EllipticalFront::Ellipses& ellipses) {
  const std::vector<model::CrackDefinition>& cracks = ellipses.cracks;
  CrackGeometry state{.lines = {}, .solids = cracks};
  for (const PartMovedByTip& arm : ellipses.arms) {
    state.aims.push_back(cracks[arm.crack].plane.ellipse_point(aim_of(around, ellipses, arm)));
    state.fronts.push_back(arm.crack);
  }
  return state;
}

// How far the front moves outwards at x for a unit of an arm.
double moved_by(const PartMovedByTip& arm, const model::CrackDefinition& crack, const Vec3& x) {
  const double phi = angle_at(crack, x);
  const Vec3 along = arm.on_a ? crack.plane.transverse_axis() : crack.plane.along;
  const double by_axis = arm.on_a ? std::sin(phi) : std::cos(phi);
  const double way = arm.paired ? 0.5 * (by_axis + arm.sign) : by_axis;
  return way * along.dot(outwards(crack, phi));
}

// Signs of the ends of an axis beside which the body is.
std::vector<double> ends_in_body(const SolidBodyQuery& around, const model::CrackDefinition& crack,
                                 bool on_a) {
  std::vector<double> ends;
  for (const double sign : {1.0, -1.0}) {
    const double phi = end_angle(on_a, sign);
    const bool in_body = std::ranges::any_of(beside_end, [&](double off) {
      return around.inside(crack.plane.ellipse_point(phi + off), crack.net) ||
             around.inside(crack.plane.ellipse_point(phi - off), crack.net);
    });
    if (in_body) {
      ends.push_back(sign);
    }
  }
  return ends;
}

} // namespace

EllipticalFront::EllipticalFront(const model::Model& model) : FrontKinematics(model) {
  now_.cracks = model.cracks;
  find_tips();
}

void EllipticalFront::find_tips() {
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    const model::CrackDefinition& crack = now_.cracks[c];
    if (!is_growing_crack(model_, c) || crack.kind != model::CrackDefinitionKind::ellipse) {
      continue;
    }
    for (const bool on_a : {true, false}) {
      const std::vector<double> ends = ends_in_body(around_, crack, on_a);
      for (const double sign : ends) {
        const bool paired = ends.size() == 2;
        now_.arms.push_back({.crack = c, .on_a = on_a, .sign = sign, .paired = paired});
        first_arm_.push_back(on_a ? crack.plane.a : crack.plane.c);
        tips_.push_back({.name = fmt::format("{}.{}{}", crack.name, on_a ? "A" : "C",
                                             !paired      ? ""
                                             : sign > 0.0 ? "1"
                                                          : "2"),
                         .line = c,
                         .at_first = false});
      }
    }
  }
}

CrackGeometry EllipticalFront::current_cracks() {
  trial_ = now_;
  return geometry_of(around_, trial_);
}

std::vector<double> EllipticalFront::tip_extents_at_size(double a) const {
  std::vector<double> arms;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    arms.push_back(first_arm_[tip] * a / model_.cracks[tips_[tip].line].plane.a);
  }
  return arms;
}

double EllipticalFront::crack_depth_behind_tip(std::size_t tip) const {
  const model::PlanarCrack& plane = now_.cracks[now_.arms[tip].crack].plane;
  return now_.arms[tip].on_a ? plane.a : plane.c;
}

double EllipticalFront::longest_advance(std::size_t /*tip*/) const {
  return std::numeric_limits<double>::infinity();
}

std::optional<LigamentDepths> EllipticalFront::ligament(std::size_t tip) const {
  const PartMovedByTip& arm = now_.arms[tip];
  const model::CrackDefinition& crack = now_.cracks[arm.crack];
  const double end = end_angle(arm.on_a, arm.sign);
  const auto in_body = [&](double phi) {
    return around_.inside(crack.plane.ellipse_point(phi), crack.net);
  };
  // At an end on the surface the way is measured a little beside it, within the body.
  std::optional<double> from;
  if (in_body(end - beside_end[0]) && in_body(end + beside_end[0])) {
    from = end;
  }
  for (const double phi : {end, end - beside_end[0], end + beside_end[0]}) {
    from = !from && in_body(phi) ? std::optional(phi) : from;
  }
  if (!from) {
    return std::nullopt;
  }
  const auto left =
      around_.surface_ahead(crack.plane.ellipse_point(*from), outwards(crack, *from), crack.net);
  if (!left) {
    return std::nullopt;
  }
  return LigamentDepths{.behind = crack_depth_behind_tip(tip), .left = left->distance};
}

namespace {

// Whether the body is on the straight way from the middle of an ellipse to each place of it. What
// lies behind a hole that the middle is at is no part of the crack; from a middle outside of the
// body all places count that lie in it. [place]
std::vector<bool> places_reached(const model::CrackDefinition& crack, const SolidBodyQuery& around,
                                 int places) {
  constexpr int looks_along = 20;
  const Vec3& middle = crack.plane.place;
  const auto inside = [&](int k, int i) {
    const Vec3 x = crack.plane.ellipse_point(2.0 * std::numbers::pi * k / places);
    return around.inside(middle + (x - middle) * i / looks_along, crack.net);
  };
  bool at_body = false;
  for (int k = 0; k < places; ++k) {
    at_body = at_body || inside(k, 1);
  }
  std::vector<bool> reached;
  for (int k = 0; k < places; ++k) {
    bool joined = true;
    for (int i = at_body ? 1 : looks_along; joined && i <= looks_along; ++i) {
      joined = inside(k, i);
    }
    reached.push_back(joined);
  }
  return reached;
}

} // namespace

std::optional<LigamentDepths> EllipticalFront::ligament_in_corner(std::size_t tip) const {
  constexpr int places = 3600; // what is left may be small
  const std::size_t number = now_.arms[tip].crack;
  for (std::size_t other = 0; other < now_.arms.size(); ++other) {
    if (now_.arms[other].crack == number && ligament(other)) {
      return std::nullopt;
    }
  }
  const model::CrackDefinition& crack = now_.cracks[number];
  const std::vector<bool> reached = places_reached(crack, around_, places);
  LigamentDepths longest{.behind = crack_depth_behind_tip(tip), .left = 0.0};
  for (int k = 0; k < places; ++k) {
    const double phi = 2.0 * std::numbers::pi * k / places;
    const Vec3 x = crack.plane.ellipse_point(phi);
    const auto left = reached[static_cast<std::size_t>(k)]
                          ? around_.surface_ahead(x, outwards(crack, phi), crack.net)
                          : std::nullopt;
    if (left && left->distance > longest.left) {
      longest = LigamentDepths{.behind = (x - crack.plane.place).norm(), .left = left->distance};
    }
  }
  return longest;
}

bool EllipticalFront::goes_beyond_surface(std::size_t tip, const LigamentDepths& before) const {
  const PartMovedByTip& arm = now_.arms[tip];
  model::CrackDefinition crack = now_.cracks[arm.crack];
  (arm.on_a ? crack.plane.a : crack.plane.c) =
      passage_policy.axis_behind * (before.behind + before.left);
  const std::vector<bool> reached = places_reached(crack, around_, looks_round);
  return std::ranges::find(reached, true) != reached.end();
}

std::optional<FrontKinematics::NeighbourCrack> EllipticalFront::neighbour(std::size_t tip) const {
  const PartMovedByTip& arm = now_.arms[tip];
  const model::CrackDefinition& own = now_.cracks[arm.crack];
  const Vec3 end = own.plane.ellipse_point(end_angle(arm.on_a, arm.sign));
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t other = arm.crack;
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    const model::CrackDefinition& crack = now_.cracks[c];
    if (c == arm.crack || crack.kind == model::CrackDefinitionKind::front) {
      continue;
    }
    const auto look = [&](const Vec3& x) {
      if ((x - end).norm() < nearest && around_.is_line_inside(end, x, own.net)) {
        nearest = (x - end).norm();
        other = c;
      }
    };
    if (crack.kind != model::CrackDefinitionKind::ellipse) {
      std::ranges::for_each(crack.points, look);
      continue;
    }
    for (int k = 0; k < looks_round; ++k) {
      look(crack.plane.ellipse_point(2.0 * std::numbers::pi * k / looks_round));
    }
  }
  if (other == arm.crack) {
    return std::nullopt;
  }
  return NeighbourCrack{.gap = nearest, .crack = other};
}

std::optional<CrackGeometry> EllipticalFront::advance_cracks(const GrowthState& /*state*/,
                                                             const AdvanceToNextStation& advance,
                                                             base::Diagnostics& diagnostics) {
  trial_ = now_;
  for (std::size_t tip = 0; tip < now_.arms.size(); ++tip) {
    const PartMovedByTip& arm = now_.arms[tip];
    if (arm.shared) {
      continue;
    }
    model::PlanarCrack& plane = trial_.cracks[arm.crack].plane;
    double by = advance.by[tip];
    if (advance.passage) {
      const std::optional<LigamentDepths> before = ligament(tip);
      if (before && by >= before->left * (1.0 - 1e-9)) {
        by = passage_policy.axis_behind * advance.lengthening * (before->behind + before->left) -
             before->behind;
      }
    }
    double& axis = arm.on_a ? plane.a : plane.c;
    if (arm.paired) {
      axis += 0.5 * by;
      plane.place += 0.5 * by * arm.sign * (arm.on_a ? plane.transverse_axis() : plane.along);
    } else {
      axis += by;
    }
  }
  if (advance.leads_through(GrowthEventKind::coalescence)) {
    const std::size_t other = advance.passage->crack;
    auto both = joined(trial_, trial_.arms[advance.passage->tip].crack, other);
    if (!both) {
      const model::CrackDefinition& met = now_.cracks[other];
      diagnostics.error(
          met.span, "E425",
          fmt::format("crack {}: no ellipse is about it and the one it meets", met.name));
      return std::nullopt;
    }
    trial_ = std::move(*both);
  }
  return geometry_of(around_, trial_);
}

void EllipticalFront::evaluate_trial_tips(std::vector<TipStation>& found) const {
  const std::vector<PartMovedByTip>& arms = trial_.arms;
  for (std::size_t c = 0; c < trial_.cracks.size(); ++c) {
    std::vector<std::size_t> own;
    for (std::size_t tip = 0; tip < arms.size(); ++tip) {
      if (arms[tip].crack == c && !arms[tip].shared) {
        own.push_back(tip);
      }
    }
    const auto n = static_cast<Eigen::Index>(own.size());
    base::Matrix moved(n, n);
    base::Vector rate(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const TipStation& at = found[own[static_cast<std::size_t>(i)]];
      for (Eigen::Index j = 0; j < n; ++j) {
        moved(i, j) =
            moved_by(arms[own[static_cast<std::size_t>(j)]], trial_.cracks[c], {at.x, at.y, at.z});
      }
      rate[i] = at.rate;
    }
    if (n == 0 || !rate.allFinite()) {
      continue;
    }
    const base::Vector arm = moved.fullPivLu().solve(rate);
    for (Eigen::Index i = 0; i < n; ++i) {
      TipStation& at = found[own[static_cast<std::size_t>(i)]];
      const double most = at.rate * farthest_extent_rate_ratio;
      const double of_arm = std::clamp(std::isfinite(arm[i]) ? arm[i] : most, 0.0, most);
      // Where the end of the axis is the place itself the two are one to round-off.
      if (at.rate > 0.0 && std::abs(of_arm - at.rate) > same_rate * at.rate) {
        at.extent_rate_ratio = of_arm / at.rate;
        at.rate = of_arm;
      }
    }
  }
  for (std::size_t tip = 0; tip < arms.size(); ++tip) {
    if (arms[tip].shared) { // its place is that of the tip that moves it
      const TipStation& own = found[mover_of(arms, tip)];
      found[tip].extent_rate_ratio = own.extent_rate_ratio;
      found[tip].rate = own.rate;
    }
  }
}

} // namespace spricka::growth
