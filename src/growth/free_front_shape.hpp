// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_drawing.hpp"
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
  [[nodiscard]] bool can_kink() const override { return kinks_.may_leave_plane(); }
  [[nodiscard]] double heading_mesh_scatter() const override;
  /// As of all fronts in space; it also ends a front that has turned too far out of its first
  /// plane.
  [[nodiscard]] AdvanceLimit advance_limit(const GrowthState& state, std::size_t tip, double share,
                                           double ds) const override;
  [[nodiscard]] CrackGeometry current_cracks() override;
  /// Replaces the advances of each front by those of its smooth shape, with their mean kept. Fronts
  /// that do not grow, or without a bound, are left as they are. Always true.
  bool smooth_advances(const GrowthState& state, std::vector<double>& by) const override;
  /// Lets waves of the deferred advances along each front die away with its mean advance.
  void damp_deferred_advance(std::vector<double>& deferred_advance,
                             const std::vector<double>& by) const override;
  /// The fronts drawn anew through their advanced points. Empty, with an error, where a front would
  /// fall into several parts or two that meet would have no common one.
  std::optional<CrackGeometry> advance_cracks(const GrowthState& state,
                                              const AdvanceToNextStation& advance,
                                              base::Diagnostics& diagnostics) override;
  /// Places the turning of each tip and smooths the rates along each front whose rates are finite.
  void evaluate_trial_tips(std::vector<TipStation>& found) const override;
  /// Keeps the fronts on trial, in `state` as well, with what follows from them: turning,
  /// ligaments, uncertain parts of the rates.
  void accept_trial(GrowthState& state) override;

private:
  [[nodiscard]] std::optional<LigamentDepths> ligament(std::size_t tip) const override {
    return ligaments_.ligament_before_tip(tip);
  }
  [[nodiscard]] std::optional<LigamentDepths> ligament_in_corner(std::size_t tip) const override;
  [[nodiscard]] bool goes_beyond_surface(std::size_t tip,
                                         const LigamentDepths& before) const override;
  [[nodiscard]] std::optional<NeighbourCrack> neighbour(std::size_t tip) const override;
  [[nodiscard]] bool coalesces_with(std::size_t tip, const NeighbourCrack& other) const override;
  [[nodiscard]] double crack_depth_behind_tip(std::size_t tip) const override;
  [[nodiscard]] double longest_advance(std::size_t tip) const override;

  /// The front of both where a tip meets another crack; empty: there is none.
  [[nodiscard]] std::optional<CoalescedFront> joined(std::size_t tip, const NeighbourCrack& other,
                                                     const AdvanceToNextStation& advance) const;
  bool join(const AdvanceToNextStation& advance, FrontDrawing& drawing);

  FrontKinks kinks_;
  FrontLigaments ligaments_;
  MovingFronts now_, trial_; ///< at the last station that counts; to be solved
};

} // namespace spricka::growth
