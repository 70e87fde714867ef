// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_kinks.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::growth {

using base::Vec3;

bool FrontKinks::may_leave_plane() const {
  return model_.growth->direction != model::GrowthDirection::path;
}

void FrontKinks::start_without_turns(std::size_t tips) {
  turning_.assign(tips, {});
  part_.assign(tips, 0.0);
}

void FrontKinks::take_turns_of_last_stations(const GrowthState& state) {
  const std::size_t count = state.stations.size();
  for (std::size_t tip = 0; may_leave_plane() && count > 0 && tip < turning_.size(); ++tip) {
    const TipStation& here = state.stations.back().tips[tip];
    turning_[tip] = {.heading = here.heading, .turn = here.turn, .curvature = 0.0};
    // Over two advances, as headings scatter from mesh to mesh; the kink at the first front is no
    // curvature, and a breakthrough has nothing in common with what was before.
    if (count > 3 && state.stations[count - 1].breakthroughs == 0 &&
        state.stations[count - 2].breakthroughs == 0) {
      turning_[tip].curvature = tip_path_curvature(state.stations[count - 3].tips[tip], here);
    }
  }
}

void FrontKinks::reset_trial() {
  for (std::size_t tip = 0; tip < part_.size(); ++tip) {
    part_[tip] = turning_[tip].heading - turning_[tip].turn;
  }
}

void FrontKinks::set_trial_advances(const std::vector<double>& by) {
  for (std::size_t tip = 0; may_leave_plane() && tip < turning_.size(); ++tip) {
    part_[tip] = turning_[tip].heading - turning_[tip].turn + turn_on(tip, by[tip]);
  }
}

// Chords follow the arc that goes on with the curvature so far (growth.15).
double FrontKinks::turn_on(std::size_t tip, double by) const {
  return turning_[tip].turn + 0.5 * turning_[tip].curvature * by;
}

Vec3 FrontKinks::tip_growth_direction(const mesh::FrontFrame& at, std::size_t tip,
                                      double by) const {
  if (!may_leave_plane()) {
    return at.m;
  }
  const double angle = turn_on(tip, by);
  return std::cos(angle) * at.m + std::sin(angle) * at.b;
}

// Turns without the scatter from mesh to mesh, as rates are.
void FrontKinks::add_smoothed_turns(const GrowingFront& of, std::vector<TipStation>& found) const {
  if (!may_leave_plane()) {
    return;
  }
  std::vector<double> turn;
  for (const std::size_t tip : of.tips) {
    turn.push_back(found[tip].turn);
  }
  const std::vector<double> smooth = smooth_front_angles(turn, of.kind());
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    found[of.tips[i]].turn = smooth[i];
    found[of.tips[i]].heading = part_[of.tips[i]] + found[of.tips[i]].turn;
  }
}

} // namespace spricka::growth
