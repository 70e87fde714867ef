// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_kinks.hpp"
#include "growth/front_ligaments.hpp"
#include "growth/growing_front.hpp"
#include "growth/growth_events.hpp"
#include "growth/solid_surroundings.hpp"

#include <cstddef>
#include <vector>

namespace spricka::growth {

/// Points of the next front, those in front of which next to nothing is left out.
struct NextFrontPoints {
  std::vector<base::Vec3> points;
  bool closed = false;
};

/// Draws the fronts that free ones go on as, through their advanced points.
class FrontDrawing {
public:
  /// All must outlive it. Fronts are drawn from `from` into `to`, which has the same cracks.
  FrontDrawing(const SolidBodyQuery& around, const FrontKinks& kinks,
               const FrontLigaments& ligaments, const MovingFronts& from, MovingFronts& to)
      : around_(around), kinks_(kinks), ligaments_(ligaments), from_(from), to_(to) {}

  /// The fronts that the front of this number goes on as; false: none, or one that cannot be drawn.
  bool draw_successors(std::size_t growing, const AdvanceToNextStation& advance);
  /// Draws the fronts of a crack that has several as one line, out of the body between them; false:
  /// that is not outside.
  bool draw_crack_fronts_as_one(std::size_t crack);
  /// One front; false: it would be none, or several.
  bool draw_front(const NextFrontPoints& next, GrowingFront& of);

private:
  /// A front that goes on, and the tips that it has.
  struct NextFront {
    NextFrontPoints next;
    std::vector<std::size_t> tips;
  };
  /// What a front goes on as: one, or where it goes through a surface between its ends, one on each
  /// side of that. Empty: nothing.
  [[nodiscard]] std::vector<NextFront> next_fronts(std::size_t growing,
                                                   const AdvanceToNextStation& advance) const;
  /// Moves a front to where its points have advanced by `by` [tip] on their way.
  void go_round(const GrowingFront& from, const std::vector<double>& by, GrowingFront& of);

  const SolidBodyQuery& around_;
  const FrontKinks& kinks_;
  const FrontLigaments& ligaments_;
  const MovingFronts& from_;
  MovingFronts& to_;
};

} // namespace spricka::growth
