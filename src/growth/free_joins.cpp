// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/free_front_shape.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

/// Two free fronts that meet and go on as one.
namespace spricka::growth {

namespace {

// Of one crack against the other: what is nearer to it than `reach` does not stay.
CoalescingFront coalescing_front(const GrowingFront& of, const GrowingFront& other, double reach,
                                 const std::vector<double>& by) {
  CoalescingFront front{.points = {}, .tips = of.tips, .stays = {}, .closed = of.arc.is_closed()};
  for (std::size_t i = 0; i < of.tips.size(); ++i) {
    const mesh::FrontFrame at = of.frame_at(i);
    front.stays.push_back((other.arc.nearest(at.x) - at.x).norm() > reach);
    front.points.emplace_back(at.x + (by.empty() ? 0.0 : by[of.tips[i]]) * at.m);
  }
  return front;
}

} // namespace

std::optional<CoalescedFront> FreeFrontShape::joined(std::size_t tip, const NeighbourCrack& other,
                                                     const AdvanceToNextStation& advance) const {
  const GrowingFront& one = now_.find_tip_on_front(tip).of;
  const auto two = std::ranges::find(now_.growing, other.crack, &GrowingFront::crack);
  const model::CrackDefinition& crack = now_.cracks[one.crack];
  const auto fronts_of = [&](std::size_t number) {
    return std::ranges::count(now_.growing, number, &GrowingFront::crack);
  };
  if (fronts_of(one.crack) != 1 || fronts_of(other.crack) != 1 ||
      !may_join(crack, now_.cracks[other.crack])) {
    return std::nullopt;
  }
  const double reach =
      advance.lengthening * (other.gap + passage_policy.notch * crack_depth_behind_tip(tip));
  CoalescingFront here = coalescing_front(one, *two, reach, advance.by);
  CoalescingFront there = coalescing_front(*two, one, reach, advance.by);
  if (crack.plane.normal.dot(now_.cracks[other.crack].plane.normal) < 0.0) {
    there.reverse_order();
  }
  return coalesce_fronts(here, there);
}

bool FreeFrontShape::coalesces_with(std::size_t tip, const NeighbourCrack& other) const {
  return joined(tip, other, {.by = {}}).has_value();
}

// The crack of the tip goes on with the front of both, the other one is gone.
bool FreeFrontShape::join(const AdvanceToNextStation& advance, FrontDrawing& drawing) {
  const std::optional<NeighbourCrack> other = neighbour(advance.passage->tip);
  if (!other || other->crack != advance.passage->crack) {
    return false;
  }
  const std::optional<CoalescedFront> both = joined(advance.passage->tip, *other, advance);
  if (!both) {
    return false;
  }
  const TipOnFront at = now_.find_tip_on_front(advance.passage->tip);
  const auto one = std::ranges::find(trial_.growing, at.of.crack, &GrowingFront::crack);
  // Within both, where they met: what lies between counts as cracked.
  const mesh::FrontFrame tip = at.tip_frame();
  trial_.cracks[one->crack].plane.place = tip.x + 0.5 * other->gap * tip.m;
  one->tips = both->tips;
  if (!drawing.draw_front({both->points, both->closed}, *one)) {
    return false;
  }
  mark_merged(trial_.cracks[other->crack]);
  std::erase_if(trial_.growing, [&](const GrowingFront& of) { return of.crack == other->crack; });
  return true;
}

} // namespace spricka::growth
