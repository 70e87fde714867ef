// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_front_shape.hpp"

#include "growth/turned_front.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

/// Free fronts that leave their plane by K1 and K2.
namespace spricka::growth {

namespace {

using base::Vec3;

/// Sine of the angle that a crack may make with its first plane: heights over that stand for it.
constexpr double steepest = 0.966;

} // namespace

bool FreeFrontShape::can_kink() const {
  return model_.growth->direction != model::GrowthDirection::path;
}

// K2 scatters by some per cent of K1 along fronts.
double FreeFrontShape::kink_scatter() const {
  constexpr double scatter = 0.04;
  return scatter;
}

void FreeFrontShape::find_turning(const GrowthState& state) {
  const std::size_t count = state.stations.size();
  for (std::size_t tip = 0; can_kink() && count > 0 && tip < tips_.size(); ++tip) {
    const TipStation& here = state.stations.back().tips[tip];
    turning_[tip] = {.heading = here.heading, .turn = here.turn, .curvature = 0.0};
    // Over two advances, as headings scatter from mesh to mesh; the kink at the first front is no
    // curvature, and a breakthrough has nothing in common with what was before.
    if (count > 3 && state.stations[count - 1].breakthroughs == 0 &&
        state.stations[count - 2].breakthroughs == 0) {
      const TipStation& last = state.stations[count - 3].tips[tip];
      turning_[tip].curvature =
          here.a > last.a ? (here.heading - last.heading) / (here.a - last.a) : 0.0;
    }
  }
}

// Chords follow the arc that goes on with the curvature so far (growth.15).
double FreeFrontShape::turn_on(std::size_t tip, double by) const {
  return turning_[tip].turn + 0.5 * turning_[tip].curvature * by;
}

Vec3 FreeFrontShape::way_on(const mesh::FrontFrame& at, std::size_t tip, double by) const {
  if (!can_kink()) {
    return at.m;
  }
  const double angle = turn_on(tip, by);
  return std::cos(angle) * at.m + std::sin(angle) * at.b;
}

AdvanceLimit FreeFrontShape::step_limit(const GrowthState& state, std::size_t tip, double share,
                                        double ds) const {
  const TipOnFront at = place_of(tip);
  const Vec3& normal = now_.cracks[at.of.crack].plane.normal;
  if (std::abs(way_on(at.tip_frame(), tip, 0.0).dot(normal)) > steepest) {
    return {.ds = ds,
            .end =
                GrowthStop{"CURL", fmt::format("{} has turned by more than 75 degrees out of its "
                                               "first plane",
                                               tips_[tip].name)}};
  }
  return FrontKinematics::step_limit(state, tip, share, ds);
}

// Turns without the scatter from mesh to mesh, as rates are.
void FreeFrontShape::place_turns(const GrowingFront& of, std::vector<TipStation>& found) const {
  if (!can_kink()) {
    return;
  }
  std::vector<double> turn;
  for (const std::size_t tip : of.tips) {
    turn.push_back(found[tip].turn);
  }
  const std::vector<double> smooth = smooth_angles(turn, kind_of(of.arc));
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    found[of.tips[i]].turn = smooth[i];
    found[of.tips[i]].heading = part_[of.tips[i]] + found[of.tips[i]].turn;
  }
}

// Behind what its front has left since the last station that counts.
void FreeFrontShape::leave_front_history(std::size_t crack, const NextPoints& next,
                                         model::CrackDefinition& drawn) const {
  const auto from = std::ranges::find(now_.growing, crack, &GrowingFront::crack);
  const model::CrackDefinition& before = now_.cracks[crack];
  drawn.front_history = extend_history(
      before, from->arc.curve,
      mesh::FrontCurve(next.points, crack_normals(before, next.points), next.closed));
}

} // namespace spricka::growth
