// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_kinematics.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::growth {

/// Cracks in space that stay ellipses, as life programs take them: a tip at each end of an axis
/// that lies in the body. Where both ends of an axis do, their arms grow apart and the centre moves
/// by half of the difference. Two in one plane with parallel axes that meet go on as one that
/// reaches as far as both. An end that has gone through the surface stands for the place where
/// the front is nearest to it.
class EllipticalFront final : public FrontKinematics {
public:
  explicit EllipticalFront(const model::Model& model);

  /// Takes the ellipses and what the tips move of them out of the state.
  void resume_from(const GrowthState& state) override;
  [[nodiscard]] CrackGeometry current_cracks() override;
  /// A of all ellipses is `a`, and the axes keep their ratio.
  [[nodiscard]] std::vector<double> tip_extents_at_size(double a) const override;
  /// The ellipses with longer axes: an arm whose opposite end lies in the body too shifts the
  /// centre by half. Empty, with an error, where no ellipse is about two that meet.
  std::optional<CrackGeometry> advance_cracks(const GrowthState& state,
                                              const AdvanceToNextStation& advance,
                                              base::Diagnostics& diagnostics) override;
  /// Turns the rates at the places of K into rates of the axes' ends, by how each end moves each
  /// place.
  void evaluate_trial_tips(std::vector<TipStation>& found) const override;
  /// Keeps the ellipses on trial, and what the tips move of them in `state`.
  void accept_trial(GrowthState& state) override;

  struct Ellipses {
    std::vector<model::CrackDefinition> cracks;
    std::vector<PartMovedByTip> arms; ///< [tip]
  };

private:
  [[nodiscard]] std::optional<LigamentDepths> ligament(std::size_t tip) const override;
  [[nodiscard]] std::optional<LigamentDepths> ligament_in_corner(std::size_t tip) const override;
  [[nodiscard]] bool goes_beyond_surface(std::size_t tip,
                                         const LigamentDepths& before) const override;
  [[nodiscard]] std::optional<NeighbourCrack> neighbour(std::size_t tip) const override;
  [[nodiscard]] bool coalesces_with(std::size_t tip, const NeighbourCrack& other) const override;
  [[nodiscard]] double crack_depth_behind_tip(std::size_t tip) const override;
  [[nodiscard]] double longest_advance(std::size_t tip) const override;

  void find_tips();
  /// The tip that moves the arm of another one: its own, or behind a meeting that of the crack
  /// which the two have become.
  static std::size_t mover_of(const std::vector<PartMovedByTip>& arms, std::size_t tip);
  /// One ellipse in the place of two, under the name of the first; empty: there is none.
  [[nodiscard]] std::optional<Ellipses> joined(Ellipses from, std::size_t one,
                                               std::size_t other) const;

  Ellipses now_, trial_; ///< at the last station that counts; to be solved
};

} // namespace spricka::growth
