// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_kinks.hpp"
#include "growth/growing_front.hpp"
#include "growth/solid_surroundings.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::growth {

/// Points of a front one after another by their numbers, or places between them.
using FrontPointRun = std::vector<double>;

/// The ways to surfaces before free fronts at one state of the cracks.
class FrontLigaments {
public:
  /// Both must outlive it.
  FrontLigaments(const SolidBodyQuery& around, const FrontKinks& kinks)
      : around_(around), kinks_(kinks) {}

  /// Looks ahead from each of so many tips; of a front that comes to a surface from places between
  /// them, too.
  void measure_ligaments(const MovingFronts& fronts, std::size_t tips);
  /// Before a tip; empty: no surface is ahead.
  [[nodiscard]] const std::optional<LigamentDepths>& ligament_before_tip(std::size_t tip) const {
    return at_tip_[tip];
  }
  /// The runs of points of the front of this number, four at least, before which more than the part
  /// `gap` of their way to a surface is left, and more than they advance `by` [tip] (empty: not
  /// asked). Where few points stay, as of a wide crack, places between them, by what is left
  /// against the crack's depth.
  [[nodiscard]] std::vector<FrontPointRun>
  remaining_point_runs(const GrowingFront& of, std::size_t number, double gap,
                       const std::vector<double>& by) const;

private:
  using Ligaments = std::vector<std::optional<LigamentDepths>>;
  [[nodiscard]] Ligaments look_ahead(const model::CrackDefinition& crack, const GrowingFront& of);
  /// Before a point of a front or a place between two; `own`: pieces of surface that it ends on.
  [[nodiscard]] std::optional<LigamentDepths>
  ligament_at(const model::CrackDefinition& crack, const GrowingFront& of, double number,
              const std::vector<std::size_t>& own) const;
  /// How far the crack reaches back from a place of a front against its way on [length].
  [[nodiscard]] double reach_back(const model::CrackDefinition& crack, const GrowingFront& of,
                                  const base::Vec3& x, const base::Vec3& way) const;

  const SolidBodyQuery& around_;
  const FrontKinks& kinks_;
  Ligaments at_tip_; ///< [tip]
  /// [front][place_count * point] near a surface, else empty
  std::vector<Ligaments> between_;
};

} // namespace spricka::growth
