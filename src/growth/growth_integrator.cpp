// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_integrator.hpp"

#include "base/damaged_field.hpp"
#include "growth/advance_error.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

/// Logarithm of the ratio by which an arm grows at most.
constexpr double first_step = 0.1;
/// An advance that leads so far of the way to a tip's last length leads to it.
constexpr double nearly_there = 0.95;
constexpr double little_left = 0.03; ///< that is left, as a part of the arm
constexpr double same_size = 1e-6;   ///< relative

// Parts of the next advance by tip: rates extrapolated to its middle (Adams and Bashforth), once
// there are two stations. `step`: logarithm of the ratio by which an arm grows at most.
std::vector<double> predicted_shares(const std::vector<SolvedStation>& all, double step) {
  std::vector<double> share;
  const auto of = [](const SolvedStation& station, std::size_t tip) {
    return station.tips[tip].rate / station.growth_rate();
  };
  for (std::size_t tip = 0; tip < all.back().tips.size(); ++tip) {
    double p = of(all.back(), tip);
    if (all.size() > 1 && p > 0.0) {
      const SolvedStation& before = all[all.size() - 2];
      const double h = all.back().s - before.s;
      // A guess of the advance of s: obstacles and lengths that cut it are looked at afterwards.
      const double next = all.back().s * (std::exp(step) - 1.0);
      // (growth.2). Cut, so that a line through two stations makes no share negative or far too
      // large.
      p = std::clamp(p + 0.5 * next / h * (p - of(before, tip)), 0.5 * p, 2.0 * p);
    }
    share.push_back(p);
  }
  double sum = 0.0;
  for (const double p : share) {
    sum += p;
  }
  for (double& p : share) {
    p /= sum;
  }
  return share;
}

} // namespace

GrowthIntegrator::GrowthIntegrator(const model::Model& model, GrowthRateFunction law,
                                   std::unique_ptr<CrackKinematics> kinematics, GrowthState state,
                                   ExtentAfterCycles extent_after_cycles)
    : model_(model), law_(std::move(law)), extent_after_cycles_(std::move(extent_after_cycles)),
      kinematics_(std::move(kinematics)), state_(std::move(state)) {
  // A run that goes on stands where its last station was; whether that was the end follows anew.
  if (state_.stations.empty()) {
    state_.step = first_step;
  } else {
    kinematics_->resume_from(state_);
    if (state_.stations.front().tips.size() != tips().size()) {
      throw base::CorruptStoredField("station_tip.a", "stations of other tips");
    }
    end_ = ends().find_growth_end(trajectory());
  }
}

std::optional<CrackGeometry> GrowthIntegrator::propose_next_cracks(base::Diagnostics& diagnostics) {
  if (end_) {
    return std::nullopt;
  }
  if (state_.stations.empty()) {
    return kinematics_->current_cracks();
  }
  if (!plan()) {
    return std::nullopt;
  }
  return kinematics_->advance_cracks(
      state_, {.by = advance_, .passage = passage_, .lengthening = lengthening_}, diagnostics);
}

std::optional<CrackGeometry>
GrowthIntegrator::extend_cracks_to_size(double a, base::Diagnostics& diagnostics) {
  const auto no = [&](const std::string& why) {
    diagnostics.error(model_.growth->span, "E431", why);
    return std::nullopt;
  };
  const bool first = state_.stations.empty();
  advance_ = kinematics_->tip_extents_at_size(a);
  if (advance_.empty()) {
    return no("the size was given: only one tip in the plane, or ellipses (SHAPE=ELLIPSE), grow by "
              "a law over such fronts");
  }
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    const double begin =
        first ? kinematics_->initial_tip_extent(tip) : state_.stations.back().tips[tip].a;
    if (first && std::abs(advance_[tip] - begin) > same_size * begin) {
      return no(fmt::format("the growth begins with {} at {:.6g}, it is for {:.6g}",
                            tips()[tip].name, begin, advance_[tip]));
    }
    advance_[tip] -= begin;
    if (!first && !(advance_[tip] > 0.0)) {
      return no(fmt::format("the crack cannot grow to a = {:.6g} there", a));
    }
  }
  passage_.reset();
  return first ? kinematics_->current_cracks()
               : kinematics_->advance_cracks(state_, {.by = advance_, .passage = {}}, diagnostics);
}

bool GrowthIntegrator::plan() {
  const std::vector<double> share = predicted_shares(state_.stations, state_.step);
  const SolvedStation& here = state_.stations.back();
  const std::optional<double> ds = next_advance(share);
  if (!ds) {
    return false;
  }
  advance_.clear();
  bool to_last_length = false;
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    const double by = share[tip] * *ds;
    const double left = kinematics_->remaining_growth_length(state_, tip);
    // The last length is met exactly, and no advance is left over that is only round-off.
    const bool to_the_end = by >= left * (1.0 - 1e-9);
    to_last_length = to_last_length || to_the_end;
    // What earlier advances missed is made up for, within bounds that keep the tip going on.
    // A passage is as long as what it passes.
    const double deferred_advance = passage_ ? 0.0 : here.tips[tip].deferred_advance;
    const double all = std::clamp(by + deferred_advance, 0.5 * by, 2.0 * by);
    advance_.push_back(to_the_end ? left : std::min(all, left));
  }
  if (!passage_ && kinematics_->smooth_advances(state_, advance_)) {
    stop_at_last_length(to_last_length);
  }
  return true;
}

// A front that relaxes goes farther at some places, and less far at others, than was planned: all
// of it goes as far as the first tip may, which meets its last length exactly. Half of a little
// that is left, again and again, would have no end.
void GrowthIntegrator::stop_at_last_length(bool planned) {
  std::size_t first = 0;
  double most = 0.0;
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    const double part = advance_[tip] / kinematics_->remaining_growth_length(state_, tip);
    if (part > most) {
      most = part;
      first = tip;
    }
  }
  const double left = kinematics_->remaining_growth_length(state_, first);
  const bool the_last = planned && left < little_left * state_.stations.back().tips[first].a;
  if (most <= 0.0 || (most < nearly_there && !the_last)) {
    return;
  }
  for (double& by : advance_) {
    by /= most;
  }
  advance_[first] = left;
}

// The advance of all together; empty: the growth ends here.
std::optional<double> GrowthIntegrator::next_advance(const std::vector<double>& share) {
  const SolvedStation& here = state_.stations.back();
  // No arm may grow by more than the step; what each tip demands only makes it shorter.
  double ds = 1e300;
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    if (share[tip] > 0.0) {
      ds = std::min(ds, (std::exp(state_.step) - 1.0) * here.tips[tip].a / share[tip]);
    }
  }
  passage_.reset();
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    if (!(share[tip] > 0.0)) {
      continue;
    }
    if (model_.growth->largest_advance) {
      ds = std::min(ds, *model_.growth->largest_advance / share[tip]);
    }
    AdvanceLimit limit = kinematics_->advance_limit(state_, tip, share[tip], ds);
    ds = limit.ds;
    if (!limit.event) {
      continue;
    }
    if (!limit.event->is_passage()) {
      end_at_station(std::move(*limit.event));
      return std::nullopt;
    }
    if (!passage_ || limit.event->advance < passage_->advance) {
      passage_ = std::move(limit.event);
      passage_->tip = tip;
    }
  }
  return passage_ ? passage_->advance : ds;
}

void GrowthIntegrator::end_at_station(GrowthEvent end) {
  end.s = state_.stations.back().s;
  end_ = std::move(end);
}

std::vector<double> GrowthIntegrator::trial_extents() const {
  std::vector<double> all;
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    // The arms are the clock of the growth: summed from advances, not measured on polylines.
    all.push_back(state_.stations.empty() ? kinematics_->initial_tip_extent(tip)
                                          : state_.stations.back().tips[tip].a + advance_[tip]);
  }
  return all;
}

void GrowthIntegrator::append_station(std::vector<TipStation> found) {
  SolvedStation station;
  station.breakthroughs = passage_ ? passage_->tip + 1 : 0;
  station.met =
      passage_ && passage_->kind == GrowthEventKind::coalescence ? passage_->crack + 1 : 0;
  kinematics_->evaluate_trial_tips(found);
  const std::vector<double> extents = trial_extents();
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    TipStation& here = found[tip];
    here.a = extents[tip];
    station.s += here.a;
  }
  station.tips = std::move(found);
  state_.stations.push_back(std::move(station));
  // First, as the judgement counts what the advance is found to have missed.
  defer_advance_correction(*kinematics_, advance_, state_.stations);
}

bool GrowthIntegrator::accept_or_reject_station(std::vector<TipStation> found) {
  append_station(std::move(found));
  if (!judge_last_advance()) {
    state_.stations.pop_back();
    ++state_.rejected;
    return false;
  }
  accept_last_station();
  return true;
}

CrackGeometry GrowthIntegrator::go_to_cracks_of(const GrowthState& earlier) {
  if (earlier.stations.empty() || earlier.stations.back().tips.size() != tips().size()) {
    throw base::CorruptStoredField("station_tip.a", "stations of other tips");
  }
  const SolvedStation& there = earlier.stations.back();
  advance_.clear();
  for (std::size_t tip = 0; tip < tips().size(); ++tip) {
    advance_.push_back(there.tips[tip].a - (state_.stations.empty()
                                                ? kinematics_->initial_tip_extent(tip)
                                                : state_.stations.back().tips[tip].a));
  }
  passage_.reset();
  if (there.breakthroughs > 0) {
    passage_ = GrowthEvent{.kind = there.met > 0 ? GrowthEventKind::coalescence
                                                 : GrowthEventKind::breakthrough,
                           .tip = there.breakthroughs - 1,
                           .crack = there.met > 0 ? there.met - 1 : 0};
  }
  kinematics_->resume_from(earlier);
  return kinematics_->current_cracks();
}

bool GrowthIntegrator::accept_station_of_another_law(std::vector<TipStation> found) {
  append_station(std::move(found));
  SolvedStation& here = state_.stations.back();
  const double misplaced = deferred_cycle_error(here);
  if (misplaced > largest_error_over_tolerance * model_.growth->tolerance) {
    state_.stations.pop_back();
    go_back_to_last_station();
    return false;
  }
  for (TipStation& tip : here.tips) {
    tip.uncertain_fraction = misplaced;
  }
  static_cast<void>(judge_last_advance()); // the next step follows from it all the same
  accept_last_station();
  return true;
}

void GrowthIntegrator::go_back_to_last_station() {
  passage_.reset();
  if (!state_.stations.empty()) {
    kinematics_->resume_from(state_);
  }
}

void GrowthIntegrator::accept_last_station() {
  passage_.reset();
  lengthening_ = 1.0;
  kinematics_->accept_trial(state_);
  end_ = ends().find_growth_end(trajectory());
}

double GrowthIntegrator::cycle_error() const {
  return total_cycle_error(state_.stations, law_, end_);
}

} // namespace spricka::growth
