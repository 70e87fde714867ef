// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/ellipse_ways.hpp"

#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/LU>
#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Advance as a part of the way to the surface, and to another crack, which may come the other way.
constexpr double of_way_to_surface = 0.6;
constexpr double of_way_to_front = 0.35;
/// A ligament that is less of the way from the centre to the surface is gone through in one go: a
/// front so near to the surface is hard to mesh and of no account for the life.
constexpr double leap_at = 0.1;
constexpr double leap_at_refused = 0.45;
/// The axis behind the surface over the way to it: the front meets the surface under an angle that
/// a tube can be laid to (28 degrees of a circle; steeper the farther).
constexpr double axis_behind = 1.15;
/// Where no front would be left behind the surface, this part of the way counts as cut through.
constexpr double cut_through = 0.03;
constexpr double nearly_through = 0.2;
/// Gap between two cracks that counts as closed, as a part of an arm.
constexpr double met = 0.1;
/// Parametric angles beside an end of an axis at which the body is looked for [rad].
constexpr std::array beside_end{0.1, 0.2, 0.3, 0.5};
/// An arm that ends outside of the body grows at most so many times as fast as the front moves: of
/// a front that has become straight the axis that leads out says nothing any more.
constexpr double farthest_lever = 20.0;
constexpr double same_rate = 1e-9;
/// Points of an ellipse that are looked at.
constexpr int looks_round = 72;

Vec3 on_ellipse(const model::Crack& crack, double phi) {
  const model::CrackPlane& p = crack.plane;
  return p.place + p.c * std::cos(phi) * p.along + p.a * std::sin(phi) * p.across();
}

Vec3 outwards(const model::Crack& crack, double phi) {
  const model::CrackPlane& p = crack.plane;
  return (std::cos(phi) / p.c * p.along + std::sin(phi) / p.a * p.across()).normalized();
}

double angle_at(const model::Crack& crack, const Vec3& x) {
  const model::CrackPlane& p = crack.plane;
  const Vec3 off = x - p.place;
  return std::atan2(off.dot(p.across()) / p.a, off.dot(p.along) / p.c);
}

double end_angle(bool on_a, double sign) {
  return on_a ? sign * 0.5 * std::numbers::pi : (sign > 0.0 ? 0.0 : std::numbers::pi);
}

} // namespace

EllipseWays::EllipseWays(const model::Model& model)
    : model_(model), around_(model.mesh), cracks_(model.cracks) {
  find_tips();
}

void EllipseWays::find_tips() {
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    const model::Crack& crack = cracks_[c];
    if (!crack_grows(model_, c) || crack.kind != model::CrackKind::ellipse) {
      continue;
    }
    for (const bool on_a : {true, false}) {
      std::vector<double> ends;
      for (const double sign : {1.0, -1.0}) {
        const double phi = end_angle(on_a, sign);
        const bool in_body = std::ranges::any_of(beside_end, [&](double off) {
          return around_.inside(on_ellipse(crack, phi + off), crack.net) ||
                 around_.inside(on_ellipse(crack, phi - off), crack.net);
        });
        if (in_body) {
          ends.push_back(sign);
        }
      }
      for (const double sign : ends) {
        const bool paired = ends.size() == 2;
        arms_.push_back({.crack = c, .on_a = on_a, .sign = sign, .paired = paired});
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

CrackState EllipseWays::state_of(const std::vector<model::Crack>& cracks) const {
  CrackState state{.lines = {}, .solids = cracks};
  for (const Arm& arm : arms_) {
    state.aims.push_back(on_ellipse(cracks[arm.crack], end_angle(arm.on_a, arm.sign)));
  }
  return state;
}

void EllipseWays::go_on(const State& state) {
  for (std::size_t c = 0; c < state.lines.size() && c < cracks_.size(); ++c) {
    model::CrackPlane& plane = cracks_[c].plane;
    plane.place = state.lines[c].at(0);
    plane.a = state.lines[c].at(1).x();
    plane.c = state.lines[c].at(1).y();
  }
}

CrackState EllipseWays::here() {
  trial_ = cracks_;
  return state_of(trial_);
}

double EllipseWays::first_arm(std::size_t tip) const {
  const model::CrackPlane& plane = model_.cracks[arms_[tip].crack].plane;
  return arms_[tip].on_a ? plane.a : plane.c;
}

double EllipseWays::length_left(const State& state, std::size_t tip) const {
  return model_.growth->last_length.value_or(std::numeric_limits<double>::infinity()) -
         state.stations.back().tips[tip].a;
}

std::optional<EllipseWays::Ligament> EllipseWays::ligament(std::size_t tip) const {
  const Arm& arm = arms_[tip];
  const model::Crack& crack = cracks_[arm.crack];
  const double end = end_angle(arm.on_a, arm.sign);
  const auto in_body = [&](double phi) {
    return around_.inside(on_ellipse(crack, phi), crack.net);
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
  const auto left = around_.to_surface(on_ellipse(crack, *from), outwards(crack, *from), crack.net);
  if (!left) {
    return std::nullopt;
  }
  return Ligament{.axis = arm.on_a ? crack.plane.a : crack.plane.c, .left = left->distance};
}

// Whether something of the front is left in the body once an arm has gone through the surface.
bool EllipseWays::goes_on_behind(std::size_t tip, const Ligament& before) const {
  const Arm& arm = arms_[tip];
  model::Crack crack = cracks_[arm.crack];
  (arm.on_a ? crack.plane.a : crack.plane.c) = axis_behind * (before.axis + before.left);
  for (int k = 0; k < looks_round; ++k) {
    if (around_.inside(on_ellipse(crack, 2.0 * std::numbers::pi * k / looks_round), crack.net)) {
      return true;
    }
  }
  return false;
}

WayLimit EllipseWays::limit(const State& state, std::size_t tip, double share, double ds) const {
  WayLimit limit{.ds = std::min(ds, length_left(state, tip) / share)};
  if (const auto way = limit_by_cracks(tip, share, limit.ds)) {
    limit = *way;
  }
  const std::optional<Ligament> before = ligament(tip);
  if (limit.end || !before) {
    return limit;
  }
  const bool behind = goes_on_behind(tip, *before);
  if (behind && before->part() < (leap_early_ ? leap_at_refused : leap_at)) {
    limit.leap = before->left / share;
  } else if (before->part() < cut_through) {
    limit.end = WayEnd{"EDGE", fmt::format("{} reaches the surface: {:.3g} is left of the "
                                           "ligament, in which K grows without bound",
                                           tips_[tip].name, before->left)};
  }
  limit.ds = std::min(limit.ds, of_way_to_surface * before->left / share);
  return limit;
}

std::optional<WayLimit> EllipseWays::limit_by_cracks(std::size_t tip, double share,
                                                     double ds) const {
  const Arm& arm = arms_[tip];
  const model::Crack& own = cracks_[arm.crack];
  const Vec3 end = on_ellipse(own, end_angle(arm.on_a, arm.sign));
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t other = arm.crack;
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    const model::Crack& crack = cracks_[c];
    if (c == arm.crack || crack.kind == model::CrackKind::front) {
      continue;
    }
    const auto look = [&](const Vec3& x) {
      if ((x - end).norm() < nearest) {
        nearest = (x - end).norm();
        other = c;
      }
    };
    if (crack.kind != model::CrackKind::ellipse) {
      std::ranges::for_each(crack.points, look);
      continue;
    }
    for (int k = 0; k < looks_round; ++k) {
      look(on_ellipse(crack, 2.0 * std::numbers::pi * k / looks_round));
    }
  }
  if (other == arm.crack) {
    return std::nullopt;
  }
  WayLimit limit{.ds = std::min(ds, of_way_to_front * nearest / share)};
  if (nearest < met * (arm.on_a ? own.plane.a : own.plane.c)) {
    limit.end = WayEnd{"LINK-UP", fmt::format("{} meets crack {}: {:.3g} is left between them",
                                              tips_[tip].name, cracks_[other].name, nearest)};
  }
  return limit;
}

std::optional<CrackState> EllipseWays::advanced(const State& /*state*/, const Advance& advance,
                                                base::Diagnostics& /*diagnostics*/) {
  trial_ = cracks_;
  for (std::size_t tip = 0; tip < arms_.size(); ++tip) {
    const Arm& arm = arms_[tip];
    model::CrackPlane& plane = trial_[arm.crack].plane;
    double by = advance.by[tip];
    if (advance.leap > 0.0) {
      const std::optional<Ligament> before = ligament(tip);
      if (before && by >= before->left * (1.0 - 1e-9)) {
        by = axis_behind * advance.leap * (before->axis + before->left) - before->axis;
      }
    }
    double& axis = arm.on_a ? plane.a : plane.c;
    if (arm.paired) {
      axis += 0.5 * by;
      plane.place += 0.5 * by * arm.sign * (arm.on_a ? plane.across() : plane.along);
    } else {
      axis += by;
    }
  }
  return state_of(trial_);
}

// How far the front moves outwards at x for a unit of an arm.
double EllipseWays::moved_by(const Arm& arm, const model::Crack& crack, const Vec3& x) const {
  const double phi = angle_at(crack, x);
  const Vec3 along = arm.on_a ? crack.plane.across() : crack.plane.along;
  const double by_axis = arm.on_a ? std::sin(phi) : std::cos(phi);
  const double way = arm.paired ? 0.5 * (by_axis + arm.sign) : by_axis;
  return way * along.dot(outwards(crack, phi));
}

void EllipseWays::place(std::vector<TipStation>& found) const {
  for (std::size_t c = 0; c < trial_.size(); ++c) {
    std::vector<std::size_t> own;
    for (std::size_t tip = 0; tip < arms_.size(); ++tip) {
      if (arms_[tip].crack == c) {
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
            moved_by(arms_[own[static_cast<std::size_t>(j)]], trial_[c], {at.x, at.y, at.z});
      }
      rate[i] = at.rate;
    }
    if (n == 0 || !rate.allFinite()) {
      continue;
    }
    const base::Vector arm = moved.fullPivLu().solve(rate);
    for (Eigen::Index i = 0; i < n; ++i) {
      TipStation& at = found[own[static_cast<std::size_t>(i)]];
      const double most = at.rate * farthest_lever;
      const double of_arm = std::clamp(std::isfinite(arm[i]) ? arm[i] : most, 0.0, most);
      // Where the end of the axis is the place itself the two are one to round-off.
      if (at.rate > 0.0 && std::abs(of_arm - at.rate) > same_rate * at.rate) {
        at.lever = of_arm / at.rate;
        at.rate = of_arm;
      }
    }
  }
}

void EllipseWays::settle(State& state) {
  cracks_ = trial_;
  leap_early_ = false;
  state.lines.clear();
  for (const model::Crack& crack : cracks_) {
    state.lines.push_back({crack.plane.place, {crack.plane.a, crack.plane.c, 0.0}});
  }
}

std::optional<WayEnd> EllipseWays::refused(const State& /*state*/, bool leapt,
                                           const std::string& why) {
  std::optional<Ligament> least;
  std::size_t at = 0;
  for (std::size_t tip = 0; tip < arms_.size(); ++tip) {
    const std::optional<Ligament> before = ligament(tip);
    if (before && (!least || before->part() < least->part())) {
      least = before;
      at = tip;
    }
  }
  if (!leapt && !leap_early_ && least && least->part() < leap_at_refused &&
      goes_on_behind(at, *least)) {
    leap_early_ = true;
    return std::nullopt;
  }
  if (least && least->part() < nearly_through) {
    return WayEnd{"EDGE", fmt::format("{} is {:.3g} from the surface, and no front can be meshed "
                                      "in what is left: {}",
                                      tips_[at].name, least->left, why)};
  }
  return WayEnd{"MESH", fmt::format("the next advance could not be meshed: {}", why)};
}

CrackState EllipseWays::straight_on(const State& /*state*/, double /*advance*/) const {
  return state_of(cracks_);
}

} // namespace spricka::growth
