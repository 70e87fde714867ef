// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_ways.hpp"

#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Advance as a part of the way to the surface, and to another front, which may come the other way.
constexpr double part_to_surface = 0.6;
constexpr double part_to_front = 0.35;
/// A ligament that is less of the way to the surface is gone through in one go.
constexpr double gone_through = 0.1;
constexpr double gone_through_refused = 0.45;
/// Points with less than so many times that before them are left out of the front behind it, which
/// goes straight on from those that stay: it meets the surface under an angle that can be meshed.
constexpr double left_out = 2.0;
constexpr double nothing_left = 0.03;
constexpr double next_to_nothing_left = 0.2;
constexpr double fronts_met = 0.1;
/// Ends on the surface look along it from a little further in, as a part of the front.
constexpr double further_in = 0.02;
constexpr std::size_t fewest_points = 4;
/// An advance as a part of the way from the crack's place.
constexpr double longest_advance = 0.2;
constexpr double usual_exponent = 3.0; // of a table

} // namespace

FreeWays::FreeWays(const model::Model& model)
    : model_(model), around_(model.mesh), cracks_(model.cracks) {
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    if (!crack_grows(model_, c)) {
      continue;
    }
    std::optional<FrontArc> arc = arc_in_body(cracks_[c], around_);
    if (!arc) {
      continue;
    }
    const std::size_t count = arc->closed() ? closed_points : open_points;
    growing_.push_back({.crack = c, .first = tips_.size(), .count = count});
    arcs_.push_back(std::move(arc));
    for (std::size_t i = 0; i < count; ++i) {
      tips_.push_back(
          {.name = fmt::format("{}.{}", cracks_[c].name, i + 1), .line = c, .at_first = false});
      first_arm_.push_back((frame(growing_.back(), i).x - cracks_[c].plane.place).norm());
    }
  }
  find_ligaments();
}

mesh::FrontFrame FreeWays::frame(const Growing& of, std::size_t number) const {
  const FrontArc& arc = *arcs_[static_cast<std::size_t>(&of - growing_.data())];
  return arc.curve.at(arc.place(number, of.count));
}

const FreeWays::Growing& FreeWays::crack_of(std::size_t tip) const {
  return *std::ranges::find_if(
      growing_, [&](const Growing& of) { return tip >= of.first && tip < of.first + of.count; });
}

// Of the fronts of the last station that counts.
void FreeWays::find_ligaments() {
  ligaments_.assign(tips_.size(), {});
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    const Growing& of = growing_[g];
    const FrontArc& arc = *arcs_[g];
    std::vector<std::size_t> own;
    const Vec3 middle = arc.curve.at(0.5 * arc.curve.length()).x;
    for (const double s : {0.0, arc.curve.length()}) {
      const auto piece = around_.piece_at(arc.curve.at(s).x, middle, cracks_[of.crack].net);
      if (!arc.closed() && piece) {
        own.push_back(*piece);
      }
    }
    for (std::size_t i = 0; i < of.count; ++i) {
      const double edge = arc.closed() ? 0.0 : further_in * arc.curve.length();
      const double s = std::clamp(arc.place(i, of.count), edge, arc.curve.length() - edge);
      const mesh::FrontFrame at = arc.curve.at(s);
      const model::Crack& crack = cracks_[of.crack];
      // The surface that an end lies on is none ahead: the front slides along it.
      const auto ahead = around_.to_surface(at.x, at.m, crack.net);
      const bool slides = ahead && std::ranges::find(own, ahead->piece) != own.end();
      const double left =
          ahead && !slides ? ahead->distance : std::numeric_limits<double>::infinity();
      ligaments_[of.first + i] = {
          .left = left,
          .part = std::isfinite(left) ? left / ((at.x - crack.plane.place).norm() + left) : 1.0};
    }
  }
}

CrackState FreeWays::state_of(const std::vector<model::Crack>& cracks,
                              const std::vector<std::optional<FrontArc>>& arcs) const {
  CrackState state{.lines = {}, .solids = cracks};
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    for (std::size_t i = 0; i < growing_[g].count; ++i) {
      state.aims.push_back(arcs[g]->curve.at(arcs[g]->place(i, growing_[g].count)).x);
    }
  }
  return state;
}

// A crack as the deck has it, or the points of its front: a first entry tells which.
void FreeWays::go_on(const State& state) {
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    model::Crack& crack = cracks_[growing_[g].crack];
    const std::vector<Vec3>& points = state.lines.at(growing_[g].crack);
    if (points.empty()) {
      continue;
    }
    crack.kind = model::CrackKind::drawn;
    crack.plane.closed = points.front().x() != 0.0;
    crack.points.assign(points.begin() + 1, points.end());
    arcs_[g] = arc_in_body(crack, around_);
  }
  find_ligaments();
}

CrackState FreeWays::here() {
  trial_ = cracks_;
  trial_arcs_ = arcs_;
  return state_of(trial_, trial_arcs_);
}

double FreeWays::length_left(const State& state, std::size_t tip) const {
  return model_.growth->last_length.value_or(std::numeric_limits<double>::infinity()) -
         state.stations.back().tips[tip].a;
}

bool FreeWays::goes_on_behind(const Growing& of, double gap) const {
  std::size_t stay = 0;
  for (std::size_t i = 0; i < of.count; ++i) {
    stay += ligaments_[of.first + i].part > left_out * gap ? 1U : 0U;
  }
  return stay >= fewest_points;
}

WayLimit FreeWays::limit(const State& state, std::size_t tip, double share, double ds) const {
  const Growing& of = crack_of(tip);
  const double size = (frame(of, tip - of.first).x - cracks_[of.crack].plane.place).norm();
  WayLimit limit{
      .ds = std::min({ds, length_left(state, tip) / share, longest_advance * size / share})};
  if (const auto way = limit_by_fronts(of, tip, share, limit.ds)) {
    limit = *way;
  }
  const Ligament& before = ligaments_[tip];
  if (limit.end || !std::isfinite(before.left)) {
    return limit;
  }
  const double gap = leap_early_ ? gone_through_refused : gone_through;
  if (before.part < gap && goes_on_behind(of, gone_through)) {
    limit.leap = before.left / share;
  } else if (before.part < nothing_left) {
    limit.end = WayEnd{"EDGE", fmt::format("{} reaches the surface: {:.3g} is left of the "
                                           "ligament, in which K grows without bound",
                                           tips_[tip].name, before.left)};
  }
  limit.ds = std::min(limit.ds, part_to_surface * before.left / share);
  return limit;
}

std::optional<WayLimit> FreeWays::limit_by_fronts(const Growing& of, std::size_t tip, double share,
                                                  double ds) const {
  const mesh::FrontFrame at = frame(of, tip - of.first);
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t other = 0;
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    for (std::size_t i = 0; i < growing_[g].count && growing_[g].crack != of.crack; ++i) {
      const double away = (frame(growing_[g], i).x - at.x).norm();
      if (away < nearest) {
        nearest = away;
        other = growing_[g].crack;
      }
    }
  }
  if (!std::isfinite(nearest)) {
    return std::nullopt;
  }
  WayLimit limit{.ds = std::min(ds, part_to_front * nearest / share)};
  if (nearest < fronts_met * (at.x - cracks_[of.crack].plane.place).norm()) {
    limit.end = WayEnd{"LINK-UP", fmt::format("{} meets crack {}: {:.3g} is left between them",
                                              tips_[tip].name, cracks_[other].name, nearest)};
  }
  return limit;
}

void FreeWays::damp(std::vector<double>& by) const {
  const double exponent =
      model_.growth->constants.m > 0.0 ? model_.growth->constants.m : usual_exponent;
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    const auto first = by.begin() + static_cast<std::ptrdiff_t>(growing_[g].first);
    const auto last = first + static_cast<std::ptrdiff_t>(growing_[g].count);
    const std::vector<double> damped =
        without_waves({first, last}, exponent / arcs_[g]->curve.length(), arcs_[g]->closed());
    std::ranges::copy(damped, first);
  }
}

FreeWays::NextPoints FreeWays::next_points(const Growing& of, const Advance& advance) const {
  const FrontArc& arc = *arcs_[static_cast<std::size_t>(&of - growing_.data())];
  const double gap = left_out * gone_through * advance.leap;
  NextPoints next{.points = {}, .closed = arc.closed()};
  std::vector<bool> stays;
  for (std::size_t i = 0; i < of.count; ++i) {
    const Ligament& before = ligaments_[of.first + i];
    stays.push_back(advance.leap <= 0.0 ||
                    (before.part > gap && before.left > advance.by[of.first + i]));
  }
  // A closed front opens where points are left out; it then begins behind that.
  std::size_t begin = 0;
  if (next.closed && std::ranges::find(stays, false) != stays.end()) {
    next.closed = false;
    while (stays[begin]) {
      ++begin;
    }
    while (!stays[begin % of.count] && begin < 2 * of.count) {
      ++begin;
    }
  }
  for (std::size_t k = 0; k < of.count; ++k) {
    const std::size_t i = (begin + k) % of.count;
    if (stays[i]) {
      const mesh::FrontFrame at = frame(of, i);
      next.points.emplace_back(at.x + advance.by[of.first + i] * at.m);
    }
  }
  return next;
}

std::optional<CrackState> FreeWays::advanced(const State& /*state*/, const Advance& advance,
                                             base::Diagnostics& diagnostics) {
  trial_ = cracks_;
  trial_arcs_ = arcs_;
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    const Growing& of = growing_[g];
    const NextPoints next = next_points(of, advance);
    std::optional<model::Crack> crack;
    if (next.points.size() >= fewest_points) {
      crack = crack_through(cracks_[of.crack], next.points, next.closed, around_);
    }
    trial_arcs_[g] = crack ? arc_in_body(*crack, around_) : std::nullopt;
    if (!trial_arcs_[g]) {
      diagnostics.error(
          cracks_[of.crack].span, "E425",
          fmt::format("crack {}: its front would fall into several parts", cracks_[of.crack].name));
      return std::nullopt;
    }
    trial_[of.crack] = std::move(*crack);
  }
  return state_of(trial_, trial_arcs_);
}

void FreeWays::place(std::vector<TipStation>& found) const {
  for (std::size_t g = 0; g < growing_.size(); ++g) {
    const Growing& of = growing_[g];
    std::vector<double> rate;
    for (std::size_t i = 0; i < of.count; ++i) {
      rate.push_back(found[of.first + i].rate);
    }
    if (std::ranges::any_of(rate, [](double r) { return !std::isfinite(r); })) {
      continue;
    }
    const std::vector<double> smooth = smooth_along(rate, trial_arcs_[g]->closed());
    for (std::size_t i = 0; i < of.count; ++i) {
      TipStation& at = found[of.first + i];
      if (at.rate > 0.0) {
        at.lever = smooth[i] / at.rate;
        at.rate = smooth[i];
      }
    }
  }
}

void FreeWays::settle(State& state) {
  cracks_ = trial_;
  arcs_ = trial_arcs_;
  leap_early_ = false;
  find_ligaments();
  state.lines.assign(cracks_.size(), {});
  for (const Growing& of : growing_) {
    const model::Crack& crack = cracks_[of.crack];
    if (crack.kind == model::CrackKind::drawn) {
      std::vector<Vec3>& line = state.lines[of.crack];
      line.emplace_back(crack.plane.closed ? 1.0 : 0.0, 0.0, 0.0);
      line.insert(line.end(), crack.points.begin(), crack.points.end());
    }
  }
}

std::optional<WayEnd> FreeWays::refused(const State& /*state*/, bool leapt,
                                        const std::string& why) {
  const auto least = std::ranges::min_element(
      ligaments_, [](const Ligament& a, const Ligament& b) { return a.part < b.part; });
  const auto tip = static_cast<std::size_t>(least - ligaments_.begin());
  if (!leapt && !leap_early_ && least->part < gone_through_refused &&
      goes_on_behind(crack_of(tip), gone_through)) {
    leap_early_ = true;
    return std::nullopt;
  }
  if (least->part < next_to_nothing_left) {
    return WayEnd{"EDGE", fmt::format("{} is {:.3g} from the surface, and no front can be meshed "
                                      "in what is left: {}",
                                      tips_[tip].name, least->left, why)};
  }
  return WayEnd{"MESH", fmt::format("the next advance could not be meshed: {}", why)};
}

CrackState FreeWays::straight_on(const State& /*state*/, double /*advance*/) const {
  return state_of(cracks_, arcs_);
}

} // namespace spricka::growth
