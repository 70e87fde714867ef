// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_front_shape.hpp"

#include "growth/crack_lines.hpp"
#include "growth/turned_front.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// An advance as a part of the way from the crack's place.
constexpr double longest_part = 0.2;
constexpr double usual_exponent = 3.0; // of a table
/// What K scatters by along a front from mesh to mesh, rms.
constexpr double scatter_of_K = 0.015;
/// Cosine of what a front turns by from end to end at least if it is no straight one: 45 degrees.
constexpr double hardly_turned = 0.7;

} // namespace

FrontKind FreeFrontShape::kind_of(const BodyFrontArc& arc) {
  const double turned = arc.curve.at(0.0).m.dot(arc.curve.at(arc.curve.length()).m);
  return arc.is_closed()          ? FrontKind::closed
         : turned > hardly_turned ? FrontKind::straight
                                  : FrontKind::round;
}

FreeFrontShape::FreeFrontShape(const model::Model& model) : FrontKinematics(model) {
  now_.cracks = model.cracks;
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    const model::CrackDefinition& crack = now_.cracks[c];
    if (!crack_grows(model_, c)) {
      continue;
    }
    std::vector<BodyFrontArc> arcs = arcs_in_body(crack, around_);
    if (can_kink() && arcs.size() > 1) {
      continue; // heights of a front history are those behind one
    }
    std::size_t number = 0;
    for (BodyFrontArc& arc : arcs) {
      const std::size_t count = arc.is_closed() ? closed_points : open_points;
      GrowingFront& of = now_.growing.emplace_back(GrowingFront{c, {}, std::move(arc)});
      for (std::size_t i = 0; i < count; ++i) {
        of.tips.push_back(tips_.size() + i);
      }
      for (std::size_t i = 0; i < count; ++i) {
        tips_.push_back(
            {.name = fmt::format("{}.{}", crack.name, ++number), .line = c, .at_first = false});
        first_arm_.push_back((of.frame_at(i).x - crack.plane.place).norm());
      }
    }
  }
  turning_.assign(tips_.size(), {});
  part_.assign(tips_.size(), 0.0);
  find_ligaments();
}

FreeFrontShape::TipOnFront FreeFrontShape::place_of(std::size_t tip) const {
  for (std::size_t g = 0; g < now_.growing.size(); ++g) {
    const GrowingFront& of = now_.growing[g];
    const auto at = std::ranges::find(of.tips, tip);
    if (at != of.tips.end()) {
      return {of, g, static_cast<std::size_t>(at - of.tips.begin())};
    }
  }
  return {now_.growing.front(), 0, 0}; // every tip has a front
}

CrackGeometry FreeFrontShape::state_of(const MovingFronts& fronts) const {
  CrackGeometry state{.lines = {}, .solids = fronts.cracks};
  state.aims.resize(tips_.size(), Vec3::Zero());
  state.fronts.resize(tips_.size());
  for (const GrowingFront& of : fronts.growing) {
    for (std::size_t i = 0; i < of.tips.size(); ++i) {
      state.aims[of.tips[i]] = of.frame_at(i).x;
      state.fronts[of.tips[i]] = of.crack;
    }
  }
  return state;
}

// A crack is as the deck has it (nothing is kept), or one number tells how many tips its front has:
// none, and it has become a part of another; and one how many fronts it has in its history. Its
// place, the tips, each with the number of its front, the fronts of the history with the normals of
// the last, and the points follow.
void FreeFrontShape::resume_from(const GrowthState& state) {
  const std::vector<GrowingFront> first = std::move(now_.growing);
  now_.growing.clear();
  for (std::size_t c = 0; c < state.lines.size(); ++c) {
    model::CrackDefinition& crack = now_.cracks[c];
    const std::vector<Vec3>& kept = state.lines[c];
    std::vector<std::vector<std::size_t>> tips; // [front]
    if (kept.empty()) {
      std::ranges::copy_if(first, std::back_inserter(now_.growing),
                           [&](const GrowingFront& of) { return of.crack == c; });
    } else {
      const std::size_t count = checked_index(kept[0].y(), kept.size());
      crack.kind = model::CrackDefinitionKind::drawn;
      crack.points.clear();
      if (count > 0) {
        crack.plane.closed = kept[0].x() != 0.0;
        crack.plane.place = kept.at(1);
        for (std::size_t i = 0; i < count; ++i) {
          tips.resize(checked_index(kept.at(2 + i).y(), count) + 1);
          tips.back().push_back(checked_index(kept.at(2 + i).x(), tips_.size()));
        }
        auto at = kept.begin() + 2 + static_cast<std::ptrdiff_t>(count);
        const auto take = [&](std::size_t many) {
          if (static_cast<std::size_t>(kept.end() - at) < many) {
            throw std::out_of_range("fronts of a wake"); // as `at` does: files may be broken
          }
          const auto from = at;
          at += static_cast<std::ptrdiff_t>(many);
          return std::vector<Vec3>(from, at);
        };
        crack.front_history = {};
        for (std::size_t left = checked_index(kept[0].z(), kept.size()); left > 0; --left) {
          const std::size_t many = checked_index(take(1).front().x(), kept.size());
          crack.front_history.fronts.push_back(take(many));
          crack.front_history.normals.resize(many);
        }
        crack.front_history.normals = take(crack.front_history.normals.size());
        crack.points.assign(at, kept.end());
      }
    }
    std::vector<BodyFrontArc> arcs =
        tips.empty() ? std::vector<BodyFrontArc>() : arcs_in_body(crack, around_);
    for (std::size_t i = 0; i < std::min(arcs.size(), tips.size()); ++i) {
      now_.growing.push_back({c, std::move(tips[i]), std::move(arcs[i])});
    }
  }
  find_turning(state);
  find_ligaments();
}

CrackGeometry FreeFrontShape::current_state() {
  trial_ = now_;
  std::ranges::fill(part_, 0.0);
  return state_of(trial_);
}

double FreeFrontShape::behind(std::size_t tip) const {
  const TipOnFront at = place_of(tip);
  return (at.tip_frame().x - now_.cracks[at.of.crack].plane.place).norm();
}

double FreeFrontShape::longest_advance(std::size_t tip) const {
  return longest_part * behind(tip);
}

bool FreeFrontShape::goes_on_behind(std::size_t tip, const SurfaceLigament& /*before*/) const {
  const std::size_t fronts = staying(place_of(tip).growing, left_out * gone_through, {}).size();
  return fronts == 1 ||
         (fronts > 1 && !can_kink()); // heights of a front history are those behind one
}

std::optional<FrontKinematics::NeighbourCrack> FreeFrontShape::neighbour(std::size_t tip) const {
  const TipOnFront at = place_of(tip);
  const Vec3 x = at.tip_frame().x;
  std::optional<NeighbourCrack> nearest;
  for (const GrowingFront& other : now_.growing) {
    const Vec3 there = other.arc.nearest(x);
    const double gap = (there - x).norm();
    if (other.crack != at.of.crack && (!nearest || gap < nearest->gap) &&
        around_.is_line_inside(x, there, now_.cracks[other.crack].net)) {
      nearest = NeighbourCrack{.gap = gap, .crack = other.crack};
    }
  }
  return nearest;
}

FrontRates FreeFrontShape::waves_of(const GrowingFront& of) const {
  FrontRates front;
  front.stiffness = exponent() / of.arc.curve.length();
  front.kind = kind_of(of.arc);
  return front;
}

double FreeFrontShape::exponent() const {
  const double m = model_.growth->constants.m;
  return m > 0.0 ? m : usual_exponent;
}

FrontRates FreeFrontShape::rates_of(const GrowingFront& of, const GrowthState& state) const {
  FrontRates front = waves_of(of);
  const SolvedStation& here = state.stations.back();
  const std::size_t count = state.stations.size();
  // A breakthrough has nothing in common with what was before.
  const SolvedStation* before =
      count > 1 && here.breakthroughs == 0 ? &state.stations[count - 2] : nullptr;
  for (const std::size_t tip : of.tips) {
    front.rate.push_back(here.tips[tip].rate);
    front.deferred_advance.push_back(here.tips[tip].deferred_advance);
    if (before != nullptr) {
      front.rate_before.push_back(before->tips[tip].rate);
      front.last.push_back(here.tips[tip].a - before->tips[tip].a);
    }
  }
  return front;
}

bool FreeFrontShape::smooth_front(const GrowthState& state, std::vector<double>& by) const {
  for (const GrowingFront& of : now_.growing) {
    const FrontRates front = rates_of(of, state);
    double sum = 0.0;
    double rates = 0.0;
    for (const std::size_t tip : of.tips) {
      sum += by[tip];
      rates += state.stations.back().tips[tip].rate;
    }
    if (!(rates > 0.0) || !std::isfinite(rates)) {
      continue;
    }
    const std::vector<double> own = front.point_advances(sum / static_cast<double>(of.tips.size()));
    for (std::size_t i = 0; i < own.size(); ++i) {
      by[of.tips[i]] = own[i];
    }
  }
  return true;
}

void FreeFrontShape::damp_deferred(std::vector<double>& deferred_advance,
                                   const std::vector<double>& by) const {
  for (const GrowingFront& of : now_.growing) {
    FrontRates front = waves_of(of);
    double mean = 0.0;
    for (const std::size_t tip : of.tips) {
      front.deferred_advance.push_back(deferred_advance[tip]);
      mean += by[tip] / static_cast<double>(of.tips.size());
    }
    const std::vector<double> left = front.remaining_deferred(mean);
    for (std::size_t i = 0; i < left.size(); ++i) {
      deferred_advance[of.tips[i]] = left[i];
    }
  }
}

std::optional<CrackGeometry> FreeFrontShape::advance_cracks(const GrowthState& /*state*/,
                                                            const TrialAdvance& advance,
                                                            base::Diagnostics& diagnostics) {
  trial_ = now_;
  for (std::size_t tip = 0; can_kink() && tip < tips_.size(); ++tip) {
    part_[tip] = turning_[tip].heading - turning_[tip].turn + turn_on(tip, advance.by[tip]);
  }
  trial_.growing.clear();
  for (std::size_t g = 0; g < now_.growing.size(); ++g) {
    const bool last =
        g + 1 == now_.growing.size() || now_.growing[g + 1].crack != now_.growing[g].crack;
    const std::size_t crack = now_.growing[g].crack;
    if (!draw_all(g, advance) || (last && !draw_together(crack))) {
      diagnostics.error(now_.cracks[crack].span, "E425",
                        fmt::format("crack {}: its front would fall into several parts",
                                    now_.cracks[crack].name));
      return std::nullopt;
    }
  }
  if (advance.meets > 0 && !join(advance)) {
    diagnostics.error(now_.cracks[advance.meets - 1].span, "E425",
                      fmt::format("crack {}: it and the one it meets would have no common front",
                                  now_.cracks[advance.meets - 1].name));
    return std::nullopt;
  }
  return state_of(trial_);
}

void FreeFrontShape::locate_tips(std::vector<TipStation>& found) const {
  for (const GrowingFront& of : trial_.growing) {
    place_turns(of, found);
    std::vector<double> rate;
    for (const std::size_t tip : of.tips) {
      rate.push_back(found[tip].rate);
    }
    if (std::ranges::any_of(rate, [](double r) { return !std::isfinite(r); })) {
      continue;
    }
    const std::vector<double> smooth =
        smooth_rates(rate, kind_of(of.arc), exponent() * scatter_of_K);
    for (std::size_t i = 0; i < of.tips.size(); ++i) {
      TipStation& at = found[of.tips[i]];
      if (at.rate > 0.0) {
        at.extent_rate_ratio = smooth[i] / at.rate;
        at.rate = smooth[i];
      }
    }
  }
}

void FreeFrontShape::accept_trial(GrowthState& state) {
  now_ = trial_;
  stands_anew();
  find_turning(state);
  find_ligaments();
  for (const GrowingFront& of : now_.growing) {
    const std::vector<double> uncertain_fraction = rates_of(of, state).uncertain_fraction();
    for (std::size_t i = 0; i < uncertain_fraction.size(); ++i) {
      double& part = state.stations.back().tips[of.tips[i]].uncertain_fraction;
      part = std::max(part, std::abs(uncertain_fraction[i]));
    }
  }
  state.lines.assign(now_.cracks.size(), {});
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    if (is_merged(now_.cracks[c])) {
      state.lines[c].emplace_back(Vec3::Zero());
    }
  }
  for (std::size_t g = 0; g < now_.growing.size(); ++g) {
    if (state.lines[now_.growing[g].crack].empty()) {
      keep_crack(now_.growing[g].crack, state.lines[now_.growing[g].crack]);
    }
  }
}

// As go_on reads it.
void FreeFrontShape::keep_crack(std::size_t number, std::vector<Vec3>& kept) const {
  const model::CrackDefinition& crack = now_.cracks[number];
  if (crack.kind != model::CrackDefinitionKind::drawn) {
    return;
  }
  double front = 0.0;
  std::vector<Vec3> tips;
  for (const GrowingFront& of : now_.growing) {
    for (const std::size_t tip : of.tips) {
      if (of.crack == number) {
        tips.emplace_back(static_cast<double>(tip), front, 0.0);
      }
    }
    front += of.crack == number ? 1.0 : 0.0;
  }
  kept.emplace_back(crack.plane.closed ? 1.0 : 0.0, static_cast<double>(tips.size()),
                    static_cast<double>(crack.front_history.fronts.size()));
  kept.push_back(crack.plane.place);
  kept.insert(kept.end(), tips.begin(), tips.end());
  for (const std::vector<Vec3>& front_history : crack.front_history.fronts) {
    kept.emplace_back(static_cast<double>(front_history.size()), 0.0, 0.0);
    kept.insert(kept.end(), front_history.begin(), front_history.end());
  }
  kept.insert(kept.end(), crack.front_history.normals.begin(), crack.front_history.normals.end());
  kept.insert(kept.end(), crack.points.begin(), crack.points.end());
}

CrackGeometry FreeFrontShape::extend_straight(const GrowthState& /*state*/,
                                              double /*advance*/) const {
  return state_of(now_);
}

} // namespace spricka::growth
