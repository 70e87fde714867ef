// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_kinematics.hpp"
#include "growth/front_kinks.hpp"
#include "growth/front_ligaments.hpp"
#include "growth/join_fronts.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::growth {

/// Cracks in space whose fronts take the shape that K gives them: tips are points spread evenly
/// along the part of a front that lies in the body, each goes on across the front, straight on or
/// turned by K2, and the next front is a smooth curve through them, trimmed or continued to the
/// surface.
/// Where it comes near to a surface ahead, the points there go through it; where two fronts in one
/// plane meet, they go on as one, which has the tips of both.
class FreeFrontShape final : public FrontKinematics {
public:
  explicit FreeFrontShape(const model::Model& model);

  /// Takes the fronts and their history out of the state and finds their arcs in the body anew.
  void resume_from(const GrowthState& state) override;
  [[nodiscard]] bool can_kink() const override { return kinks_.allowed(); }
  [[nodiscard]] double heading_scatter() const override;
  /// As of all fronts in space; it also ends a front that has turned too far out of its first
  /// plane.
  [[nodiscard]] AdvanceLimit advance_limit(const GrowthState& state, std::size_t tip, double share,
                                           double ds) const override;
  [[nodiscard]] CrackGeometry current_cracks() override;
  /// Replaces the advances of each front by those of its smooth shape, with their mean kept. Fronts
  /// that do not grow, or without a bound, are left as they are. Always true.
  bool smooth_front(const GrowthState& state, std::vector<double>& by) const override;
  /// Lets waves of the deferred advances along each front die away with its mean advance.
  void damp_deferred_advance(std::vector<double>& deferred_advance,
                             const std::vector<double>& by) const override;
  /// The fronts drawn anew through their advanced points. Empty, with an error, where a front would
  /// fall into several parts or two that meet would have no common one.
  std::optional<CrackGeometry> advance_cracks(const GrowthState& state, const TrialAdvance& advance,
                                              base::Diagnostics& diagnostics) override;
  /// Places the turning of each tip and smooths the rates along each front whose rates are finite.
  void evaluate_trial_tips(std::vector<TipStation>& found) const override;
  /// Keeps the fronts on trial, in `state` as well, with what follows from them: turning,
  /// ligaments, uncertain parts of the rates.
  void accept_trial(GrowthState& state) override;

private:
  /// Points of the next front, those in front of which next to nothing is left out.
  struct NextPoints {
    std::vector<base::Vec3> points;
    bool closed = false;
  };
  /// A front that goes on, and the tips that it has.
  struct NextFront {
    NextPoints next;
    std::vector<std::size_t> tips;
  };
  /// Where a tip is.
  struct TipOnFront {
    const GrowingFront& of;
    std::size_t growing = 0; ///< which that is
    std::size_t number = 0;  ///< of its points
    [[nodiscard]] mesh::FrontFrame tip_frame() const { return of.frame_at(number); }
  };
  [[nodiscard]] std::optional<SurfaceLigament> ligament(std::size_t tip) const override {
    return ligaments_.at_tip(tip);
  }
  [[nodiscard]] std::optional<SurfaceLigament> left_in_corner(std::size_t tip) const override;
  [[nodiscard]] bool goes_on_behind(std::size_t tip, const SurfaceLigament& before) const override;
  [[nodiscard]] std::optional<NeighbourCrack> neighbour(std::size_t tip) const override;
  [[nodiscard]] bool joins(std::size_t tip, const NeighbourCrack& other) const override;
  [[nodiscard]] double behind(std::size_t tip) const override;
  [[nodiscard]] double longest_advance(std::size_t tip) const override;

  void update_fronts(const GrowthState& state);
  [[nodiscard]] TipOnFront place_of(std::size_t tip) const;
  [[nodiscard]] CrackGeometry state_of(const MovingFronts& fronts) const;
  /// What a front goes on as: one, or where it goes through a surface between its ends, one on each
  /// side of that. Empty: nothing.
  [[nodiscard]] std::vector<NextFront> next_fronts(std::size_t growing,
                                                   const TrialAdvance& advance) const;
  /// All fronts on trial by an advance; false: a crack would have none that can be drawn.
  bool draw_all(std::size_t growing, const TrialAdvance& advance);
  /// Draws the fronts of a crack on trial that has several as one line, out of the body between
  /// them; false: that is not outside.
  bool draw_together(std::size_t crack);
  /// A front on trial; false: it would be none, or several.
  bool draw(const NextPoints& next, GrowingFront& of);
  void leave_front_history(std::size_t crack, const NextPoints& next,
                           model::CrackDefinition& drawn) const;
  [[nodiscard]] double exponent() const; ///< of the law
  /// How the waves of a front die, nothing else of it.
  [[nodiscard]] FrontGrowthRates waves_of(const GrowingFront& of) const;
  /// Of all that a front has made on its way to the last station.
  [[nodiscard]] FrontGrowthRates rates_of(const GrowingFront& of, const GrowthState& state) const;
  /// Moves a front on trial to where its points have advanced by `by` [tip] on their way.
  void go_round(const GrowingFront& from, const std::vector<double>& by, GrowingFront& of);
  /// Of one crack against the other: what is nearer to it than `reach` does not stay.
  [[nodiscard]] CoalescingFront meeting(const GrowingFront& of, const GrowingFront& other,
                                        double reach, const std::vector<double>& by) const;
  [[nodiscard]] std::optional<CoalescedFront> joined(std::size_t tip, const NeighbourCrack& other,
                                                     const TrialAdvance& advance) const;
  bool join(const TrialAdvance& advance);

  FrontKinks kinks_;
  FrontLigaments ligaments_;
  MovingFronts now_, trial_; ///< at the last station that counts; to be solved
};

} // namespace spricka::growth
