// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/ahead.hpp"
#include "growth/crack_kinematics.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::growth {

/// Cracks in the plane: along the paths that the deck draws, or as K turns them.
class PlanarTips final : public CrackKinematics {
public:
  /// `lines`: the cracks as they are first.
  PlanarTips(const model::Model& model, std::vector<mesh::CrackLine> lines);

  [[nodiscard]] bool can_kink() const override;
  /// Takes the lines of all cracks out of the state.
  void resume_from(const GrowthState& state) override;
  [[nodiscard]] CrackGeometry current_cracks() override;
  /// Length of a tip's crack along its line, of an embedded crack half of it [length].
  [[nodiscard]] double initial_tip_extent(std::size_t tip) const override;
  /// Of one tip alone.
  [[nodiscard]] std::vector<double> tip_extents_at_size(double a) const override {
    return tips_.size() == 1 ? std::vector<double>{a} : std::vector<double>();
  }
  /// What is left to the largest length that $GROW allows and, on a path, to its end [length].
  [[nodiscard]] double remaining_growth_length(const GrowthState& state,
                                               std::size_t tip) const override;
  /// Limits the advance by the end of the path, by the curvature of the last advance where K turns
  /// the crack, and by what lies ahead.
  [[nodiscard]] AdvanceLimit advance_limit(const GrowthState& state, std::size_t tip, double share,
                                           double ds) const override;
  /// The lines extended along their headings, or cut anew from the paths of the deck. Empty, with
  /// errors, where a path gives no such line.
  std::optional<CrackGeometry> advance_cracks(const GrowthState& state,
                                              const AdvanceToNextStation& advance,
                                              base::Diagnostics& diagnostics) override;
  /// Sets the place of each tip and its heading: that of its last segment and the turn that K asks
  /// for.
  void evaluate_trial_tips(std::vector<TipStation>& found) const override;
  /// Keeps the lines on trial, their points in `state` as well.
  void accept_trial(GrowthState& state) override;
  /// The end of the growth: there is no other way in the plane than the advance that failed.
  [[nodiscard]] std::optional<GrowthEvent>
  handle_unmeshable_advance(bool passage, const std::string& why) override;
  /// The lines with a straight end along each heading, by `advance` or less, so that none leaves
  /// the body.
  [[nodiscard]] CrackGeometry extend_cracks_straight(const GrowthState& state,
                                                     double advance) const override;

private:
  [[nodiscard]] TipGrowthDirection heading_of(const GrowthState& state, std::size_t tip) const;
  void limit_by_obstacles(const GrowthState& state, std::size_t tip, double share,
                          AdvanceLimit& limit) const;
  void extend(const GrowthState& state, std::size_t tip, double by, mesh::CrackLine& line) const;

  const model::Model& model_;
  std::vector<mesh::CrackLine> lines_; ///< at the last station that counts
  std::vector<mesh::CrackLine> trial_; ///< to be solved
  PlaneBoundaryAhead around_;
};

} // namespace spricka::growth
