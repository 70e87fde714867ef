// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_front_shape.hpp"

#include "base/damaged_field.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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
/// The same of K2, as a part of K1: headings scatter by it.
constexpr double scatter_of_K2 = 0.04;

// [front][point] The tips of a crack's fronts in the order along them.
std::vector<std::vector<std::size_t>> tips_along(const std::vector<PartMovedByTip>& tips,
                                                 std::size_t crack) {
  std::vector<std::vector<std::size_t>> fronts;
  for (std::size_t tip = 0; tip < tips.size(); ++tip) {
    if (tips[tip].crack == crack) {
      fronts.resize(std::max(fronts.size(), tips[tip].front + 1));
      fronts[tips[tip].front].push_back(tip);
    }
  }
  for (std::vector<std::size_t>& front : fronts) {
    std::ranges::sort(front, {}, [&](std::size_t tip) { return tips[tip].number; });
    for (std::size_t i = 0; i < front.size(); ++i) {
      if (tips[front[i]].number != i) {
        throw base::CorruptStoredField("tip.number", "points of a front are missing");
      }
    }
  }
  return fronts;
}

// [tip] The same the other way: on which front of its crack each of so many tips is.
std::vector<PartMovedByTip> places_of_tips(const MovingFronts& now, std::size_t count) {
  std::vector<PartMovedByTip> places(count);
  std::vector<std::size_t> fronts(now.cracks.size(), 0);
  for (const GrowingFront& of : now.growing) {
    for (std::size_t i = 0; i < of.tips.size(); ++i) {
      places[of.tips[i]] = {.crack = of.crack, .front = fronts[of.crack], .number = i};
    }
    ++fronts[of.crack];
  }
  return places;
}

// The cracks of fronts, and where K of so many tips is taken.
CrackGeometry state_of(const MovingFronts& fronts, std::size_t tips) {
  CrackGeometry state{.lines = {}, .solids = fronts.cracks};
  state.aims.resize(tips, Vec3::Zero());
  state.fronts.resize(tips);
  for (const GrowingFront& of : fronts.growing) {
    for (std::size_t i = 0; i < of.tips.size(); ++i) {
      state.aims[of.tips[i]] = of.frame_at(i).x;
      state.fronts[of.tips[i]] = of.crack;
    }
  }
  return state;
}

// Of the law.
double law_exponent(const model::Model& model) {
  const double m = model.growth->constants.m;
  return m > 0.0 ? m : usual_exponent;
}

// How the waves of a front die, nothing else of it.
FrontGrowthRates waves_of(const GrowingFront& of, double exponent) {
  FrontGrowthRates front;
  front.stiffness = exponent / of.arc.curve.length();
  front.kind = of.kind();
  return front;
}

// Of all that a front has made on its way to the last station.
FrontGrowthRates rates_of(const GrowingFront& of, const GrowthState& state, double exponent) {
  FrontGrowthRates front = waves_of(of, exponent);
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

// The longest way to a surface from the points of a front.
std::optional<LigamentDepths> longest_ligament(const GrowingFront& of,
                                               const model::CrackDefinition& crack,
                                               const SolidBodyQuery& around) {
  std::optional<LigamentDepths> longest;
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    const mesh::FrontFrame at = of.frame_at(i);
    const auto ahead = around.surface_ahead(at.x, at.m, crack.net);
    if (ahead && (!longest || ahead->distance > longest->left)) {
      longest =
          LigamentDepths{.behind = (at.x - crack.plane.place).norm(), .left = ahead->distance};
    }
  }
  return longest;
}

} // namespace

FreeFrontShape::FreeFrontShape(const model::Model& model)
    : FrontKinematics(model), kinks_(model), ligaments_(around_, kinks_) {
  now_.cracks = model.cracks;
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    const model::CrackDefinition& crack = now_.cracks[c];
    if (!is_growing_crack(model_, c)) {
      continue;
    }
    std::vector<BodyFrontArc> arcs = front_arcs_in_body(crack, around_);
    if (can_kink() && arcs.size() > 1) {
      continue; // heights of a front history are those behind one
    }
    std::size_t number = 0;
    for (BodyFrontArc& arc : arcs) {
      const std::size_t count = arc.is_closed() ? closed_front_points : open_front_points;
      GrowingFront& of = now_.growing.emplace_back(GrowingFront{c, {}, std::move(arc)});
      of.tips.resize(count);
      std::iota(of.tips.begin(), of.tips.end(), tips_.size());
      for (std::size_t i = 0; i < count; ++i) {
        tips_.push_back(
            {.name = fmt::format("{}.{}", crack.name, ++number), .line = c, .at_first = false});
        first_arm_.push_back((of.frame_at(i).x - crack.plane.place).norm());
      }
    }
  }
  kinks_.start_without_turns(tips_.size());
  ligaments_.measure_ligaments(now_, tips_.size());
}

void FreeFrontShape::resume_from(const GrowthState& state) {
  restore_cracks(state, now_.cracks);
  now_.growing.clear();
  for (std::size_t c = 0; c < now_.cracks.size(); ++c) {
    std::vector<std::vector<std::size_t>> tips = tips_along(state.tips, c);
    if (tips.empty()) {
      continue;
    }
    std::vector<BodyFrontArc> arcs = front_arcs_in_body(now_.cracks[c], around_);
    if (arcs.size() != tips.size()) {
      throw base::CorruptStoredField("tip.front", "the crack has another number of fronts");
    }
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      now_.growing.push_back({c, std::move(tips[i]), std::move(arcs[i])});
    }
  }
  kinks_.take_turns_of_last_stations(state);
  ligaments_.measure_ligaments(now_, tips_.size());
}

CrackGeometry FreeFrontShape::current_cracks() {
  trial_ = now_;
  kinks_.reset_trial();
  return state_of(trial_, tips_.size());
}

double FreeFrontShape::crack_depth_behind_tip(std::size_t tip) const {
  const TipOnFront at = now_.find_tip_on_front(tip);
  return (at.tip_frame().x - now_.cracks[at.of.crack].plane.place).norm();
}

double FreeFrontShape::longest_advance(std::size_t tip) const {
  return longest_part * crack_depth_behind_tip(tip);
}

bool FreeFrontShape::goes_beyond_surface(std::size_t tip, const LigamentDepths& /*before*/) const {
  const TipOnFront at = now_.find_tip_on_front(tip);
  const double gap = passage_policy.left_out * surface_policy.passed;
  const std::size_t fronts = ligaments_.remaining_point_runs(at.of, at.growing, gap, {}).size();
  // Heights of a front history are those behind one.
  return fronts == 1 || (fronts > 1 && !can_kink());
}

std::optional<FrontKinematics::NeighbourCrack> FreeFrontShape::neighbour(std::size_t tip) const {
  const TipOnFront at = now_.find_tip_on_front(tip);
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

bool FreeFrontShape::smooth_advances(const GrowthState& state, std::vector<double>& by) const {
  for (const GrowingFront& of : now_.growing) {
    const FrontGrowthRates front = rates_of(of, state, law_exponent(model_));
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

void FreeFrontShape::damp_deferred_advance(std::vector<double>& deferred_advance,
                                           const std::vector<double>& by) const {
  for (const GrowingFront& of : now_.growing) {
    FrontGrowthRates front = waves_of(of, law_exponent(model_));
    double mean = 0.0;
    for (const std::size_t tip : of.tips) {
      front.deferred_advance.push_back(deferred_advance[tip]);
      mean += by[tip] / static_cast<double>(of.tips.size());
    }
    const std::vector<double> left = front.remaining_deferred_advance(mean);
    for (std::size_t i = 0; i < left.size(); ++i) {
      deferred_advance[of.tips[i]] = left[i];
    }
  }
}

std::optional<CrackGeometry> FreeFrontShape::advance_cracks(const GrowthState& /*state*/,
                                                            const AdvanceToNextStation& advance,
                                                            base::Diagnostics& diagnostics) {
  trial_ = now_;
  kinks_.set_trial_advances(advance.by);
  trial_.growing.clear();
  FrontDrawing drawing(around_, kinks_, ligaments_, now_, trial_);
  for (std::size_t g = 0; g < now_.growing.size(); ++g) {
    const std::size_t crack = now_.growing[g].crack;
    const bool last = g + 1 == now_.growing.size() || now_.growing[g + 1].crack != crack;
    if (!drawing.draw_successors(g, advance) ||
        (last && !drawing.draw_crack_fronts_as_one(crack))) {
      diagnostics.error(now_.cracks[crack].span, "E425",
                        fmt::format("crack {}: its front would fall into several parts",
                                    now_.cracks[crack].name));
      return std::nullopt;
    }
  }
  if (advance.leads_through(GrowthEventKind::coalescence) && !join(advance, drawing)) {
    const model::CrackDefinition& other = now_.cracks[advance.passage->crack];
    diagnostics.error(
        other.span, "E425",
        fmt::format("crack {}: it and the one it meets would have no common front", other.name));
    return std::nullopt;
  }
  return state_of(trial_, tips_.size());
}

void FreeFrontShape::evaluate_trial_tips(std::vector<TipStation>& found) const {
  for (const GrowingFront& of : trial_.growing) {
    kinks_.add_smoothed_turns(of, found);
    std::vector<double> rate;
    for (const std::size_t tip : of.tips) {
      rate.push_back(found[tip].rate);
    }
    if (std::ranges::any_of(rate, [](double r) { return !std::isfinite(r); })) {
      continue;
    }
    const std::vector<double> smooth =
        smooth_front_rates(rate, of.kind(), law_exponent(model_) * scatter_of_K);
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
  kinks_.take_turns_of_last_stations(state);
  ligaments_.measure_ligaments(now_, tips_.size());
  for (const GrowingFront& of : now_.growing) {
    const FrontGrowthRates rates = rates_of(of, state, law_exponent(model_));
    const std::vector<double> own = rates.uncertain_fraction();
    for (std::size_t i = 0; i < own.size(); ++i) {
      double& part = state.stations.back().tips[of.tips[i]].uncertain_fraction;
      part = std::max(part, std::abs(own[i]));
    }
  }
  accept_cracks(now_.cracks, state);
  state.tips = places_of_tips(now_, tips_.size());
}

double FreeFrontShape::heading_mesh_scatter() const {
  return scatter_of_K2;
}

AdvanceLimit FreeFrontShape::advance_limit(const GrowthState& state, std::size_t tip, double share,
                                           double ds) const {
  const TipOnFront at = now_.find_tip_on_front(tip);
  const Vec3& normal = now_.cracks[at.of.crack].plane.normal;
  if (std::abs(kinks_.tip_growth_direction(at.tip_frame(), tip, 0.0).dot(normal)) >
      futility_policy.steepest) {
    return {.ds = ds,
            .event = GrowthEvent{.kind = GrowthEventKind::curl,
                                 .reason = fmt::format(
                                     "{} has turned by more than 75 degrees out of its first plane",
                                     tips_[tip].name)}};
  }
  return FrontKinematics::advance_limit(state, tip, share, ds);
}

std::optional<LigamentDepths> FreeFrontShape::ligament_in_corner(std::size_t tip) const {
  const GrowingFront& of = now_.find_tip_on_front(tip).of;
  if (of.arc.is_closed() || std::ranges::any_of(of.tips, [&](std::size_t other) {
        return ligaments_.ligament_before_tip(other).has_value();
      })) {
    return std::nullopt;
  }
  return longest_ligament(of, now_.cracks[of.crack], around_);
}

} // namespace spricka::growth
