// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/damaged_field.hpp"
#include "growth/elliptical_front.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// Two ellipses that meet and go on as one, and what is kept of that from run to run.
namespace spricka::growth {

namespace {

using base::Vec3;
using model::PlanarCrack;

/// Axes that are parallel (cosine), and places on one wall (part of the longer axis).
constexpr double same = 1e-6;

/// An ellipse along an axis of the one it is seen from.
struct EllipseSpan {
  double place = 0.0;         ///< of its centre, from the other's [length]
  double half = 0.0;          ///< semi-axis [length]
  std::array<bool, 2> arms{}; ///< ends in the body: towards -, towards +

  [[nodiscard]] bool paired() const { return arms[0] && arms[1]; }
};

/// An arm of the ellipse that two have become, and the tip that moves it.
struct JointArm {
  PartMovedByTip arm;
  std::size_t mover = 0;
};

std::size_t side(double sign) {
  return sign > 0.0 ? 1 : 0;
}

// The arm as one of an ellipse with parallel axes.
PartMovedByTip seen_from(const PlanarCrack& plane, const PartMovedByTip& arm,
                         const PlanarCrack& own) {
  const Vec3 way = arm.sign * (arm.on_a ? own.transverse_axis() : own.along);
  const double along = way.dot(plane.along);
  const double across = way.dot(plane.transverse_axis());
  PartMovedByTip seen = arm;
  seen.on_a = std::abs(across) > std::abs(along);
  seen.sign = (seen.on_a ? across : along) > 0.0 ? 1.0 : -1.0;
  return seen;
}

bool are_parallel(const PlanarCrack& one, const PlanarCrack& other) {
  const double cosine = std::abs(one.along.dot(other.along));
  return cosine < same || cosine > 1.0 - same;
}

/// Two ellipses by their numbers, seen from the first.
class EllipseCoalescence {
public:
  EllipseCoalescence(const EllipticalFront::Ellipses& all, std::size_t one, std::size_t other)
      : all_(all), one_(one), other_(other), first_(all.cracks[one].plane) {}

  [[nodiscard]] std::optional<PlanarCrack> plane() const {
    const std::optional<EllipseSpan> a = span_of_both(true);
    const std::optional<EllipseSpan> c = span_of_both(false);
    if (!a || !c) {
      return std::nullopt;
    }
    PlanarCrack both = first_;
    both.place += c->place * first_.along + a->place * first_.transverse_axis();
    both.a = a->half;
    both.c = c->half;
    return both;
  }

  // Arms of both become those of the first; where two tips stand for one the farther moves it.
  [[nodiscard]] std::vector<PartMovedByTip> arms() const {
    const std::vector<JointArm> joint = joint_arms();
    std::vector<PartMovedByTip> arms = all_.arms;
    for (std::size_t tip = 0; tip < arms.size(); ++tip) {
      if (is_ours(arms[tip])) {
        const JointArm& stands_for = nearest(joint, seen(tip));
        arms[tip] = stands_for.arm;
        arms[tip].shared = tip != stands_for.mover;
      }
    }
    return arms;
  }

private:
  [[nodiscard]] bool is_ours(const PartMovedByTip& arm) const {
    return arm.crack == one_ || arm.crack == other_;
  }
  [[nodiscard]] const PlanarCrack& plane_of(const PartMovedByTip& arm) const {
    return all_.cracks[arm.crack].plane;
  }
  [[nodiscard]] PartMovedByTip seen(std::size_t tip) const {
    return seen_from(first_, all_.arms[tip], plane_of(all_.arms[tip]));
  }
  [[nodiscard]] Vec3 axis(bool on_a) const {
    return on_a ? first_.transverse_axis() : first_.along;
  }

  [[nodiscard]] EllipseSpan span_of(std::size_t crack, bool on_a) const {
    const PlanarCrack& plane = all_.cracks[crack].plane;
    const double cosine = std::abs(plane.along.dot(axis(on_a)));
    EllipseSpan span{.place = (plane.place - first_.place).dot(axis(on_a)),
                     .half = cosine > 0.5 ? plane.c : plane.a,
                     .arms = {}};
    for (std::size_t tip = 0; tip < all_.arms.size(); ++tip) {
      if (all_.arms[tip].crack == crack && seen(tip).on_a == on_a) {
        span.arms.at(side(seen(tip).sign)) = true;
      }
    }
    return span;
  }

  // Both ends of the axis in the body: as far as both reach. One of them: from the wall that the
  // centre lies on, which must be the same for both.
  [[nodiscard]] std::optional<EllipseSpan> span_of_both(bool on_a) const {
    const EllipseSpan one = span_of(one_, on_a);
    const EllipseSpan other = span_of(other_, on_a);
    if (one.paired() && other.paired()) {
      const double low = std::min(one.place - one.half, other.place - other.half);
      const double high = std::max(one.place + one.half, other.place + other.half);
      return EllipseSpan{0.5 * (low + high), 0.5 * (high - low), one.arms};
    }
    const EllipseSpan& wall = one.paired() ? other : one;
    const EllipseSpan& far = one.paired() ? one : other;
    const bool two_walls = !far.paired();
    if (two_walls && (wall.arms != far.arms ||
                      std::abs(wall.place - far.place) > same * std::max(wall.half, far.half))) {
      return std::nullopt;
    }
    const double sign = wall.arms[0] ? -1.0 : 1.0;
    const double reach = sign * (far.place - wall.place) + far.half;
    return EllipseSpan{wall.place, std::max(wall.half, reach), wall.arms};
  }

  // How far a tip lies out along its arm, from the first one's centre.
  [[nodiscard]] double reach(std::size_t tip) const {
    const PlanarCrack& own = plane_of(all_.arms[tip]);
    const PartMovedByTip arm = seen(tip);
    return arm.sign * (own.place - first_.place).dot(axis(arm.on_a)) +
           (all_.arms[tip].on_a ? own.a : own.c);
  }

  [[nodiscard]] std::vector<JointArm> joint_arms() const {
    std::vector<JointArm> joint;
    for (const bool on_a : {true, false}) {
      const std::optional<EllipseSpan> span = span_of_both(on_a);
      for (const double sign : {1.0, -1.0}) {
        if (span && span->arms.at(side(sign))) {
          joint.push_back({PartMovedByTip{.crack = one_,
                                          .on_a = on_a,
                                          .sign = sign,
                                          .paired = span->paired(),
                                          .shared = false},
                           farthest(on_a, sign)});
        }
      }
    }
    return joint;
  }

  [[nodiscard]] std::size_t farthest(bool on_a, double sign) const {
    std::optional<std::size_t> found;
    for (std::size_t tip = 0; tip < all_.arms.size(); ++tip) {
      if (is_ours(all_.arms[tip]) && seen(tip).on_a == on_a && seen(tip).sign == sign &&
          (!found || reach(tip) > reach(*found))) {
        found = tip;
      }
    }
    return found.value_or(0); // spans have no other arms than those of tips
  }

  // The same end, or the other end of the axis, or another axis: an end that was between the two is
  // none any more.
  static const JointArm& nearest(const std::vector<JointArm>& joint, const PartMovedByTip& arm) {
    const auto agreement = [&](const JointArm& with) {
      return (with.arm.on_a == arm.on_a ? 2 : 0) + (with.arm.sign == arm.sign ? 1 : 0);
    };
    return *std::ranges::max_element(joint, {}, agreement);
  }

  const EllipticalFront::Ellipses& all_;
  std::size_t one_;
  std::size_t other_;
  PlanarCrack first_;
};

} // namespace

std::size_t EllipticalFront::mover_of(const std::vector<PartMovedByTip>& arms, std::size_t tip) {
  const auto found = std::ranges::find_if(arms, [&](const PartMovedByTip& arm) {
    return !arm.shared && arm.crack == arms[tip].crack && arm.on_a == arms[tip].on_a &&
           arm.sign == arms[tip].sign;
  });
  return static_cast<std::size_t>(found - arms.begin());
}

std::optional<EllipticalFront::Ellipses> EllipticalFront::joined(Ellipses from, std::size_t one,
                                                                 std::size_t other) const {
  const bool both_grow =
      std::ranges::any_of(from.arms, [&](const PartMovedByTip& arm) { return arm.crack == other; });
  if (!both_grow || !may_join(from.cracks[one], from.cracks[other]) ||
      !are_parallel(from.cracks[one].plane, from.cracks[other].plane)) {
    return std::nullopt;
  }
  const EllipseCoalescence meeting(from, one, other);
  const std::optional<PlanarCrack> plane = meeting.plane();
  if (!plane) {
    return std::nullopt;
  }
  std::vector<PartMovedByTip> arms = meeting.arms();
  from.arms = std::move(arms);
  from.cracks[one].plane = *plane;
  mark_merged(from.cracks[other]);
  return from;
}

bool EllipticalFront::coalesces_with(std::size_t tip, const NeighbourCrack& other) const {
  return joined(now_, now_.arms[tip].crack, other.crack).has_value();
}

void EllipticalFront::accept_trial(GrowthState& state) {
  now_ = trial_;
  accept_cracks(now_.cracks, state);
  state.tips = now_.arms;
}

void EllipticalFront::resume_from(const GrowthState& state) {
  restore_cracks(state, now_.cracks);
  now_.arms = state.tips;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const PartMovedByTip& arm = now_.arms[tip];
    const PlanarCrack& plane = now_.cracks[arm.crack].plane;
    if (!(plane.a > 0.0 && plane.c > 0.0)) {
      throw base::CorruptStoredField("crack.a", "an ellipse without axes");
    }
    if (std::abs(arm.sign) != 1.0 || mover_of(now_.arms, tip) == tips_.size()) {
      throw base::CorruptStoredField("tip.sign", "an end of no axis");
    }
  }
}

} // namespace spricka::growth
