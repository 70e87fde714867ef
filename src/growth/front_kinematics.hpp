// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/crack_kinematics.hpp"
#include "growth/solid_surroundings.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace spricka::growth {

/// Whether a crack has become a part of another one: it is drawn, by no points.
inline bool is_merged(const model::CrackDefinition& crack) {
  return crack.kind == model::CrackDefinitionKind::drawn && crack.points.empty();
}

/// Makes a crack one that has become a part of another: drawn, without points.
inline void mark_merged(model::CrackDefinition& crack) {
  crack.kind = model::CrackDefinitionKind::drawn;
  crack.points.clear();
}

/// Cracks in space, whatever shape their fronts take: how far it is to surfaces and other fronts,
/// when a front goes through in one go, and when it ends there.
class FrontKinematics : public CrackKinematics {
public:
  [[nodiscard]] bool can_kink() const override { return false; }
  /// Of the deck's crack, whatever it has become: the half axis that ends at a tip of an ellipse,
  /// else from the place of its crack to a tip [length].
  [[nodiscard]] double initial_tip_extent(std::size_t tip) const override {
    return first_arm_[tip];
  }
  /// What is left to the largest length that $GROW allows, unbounded without one [length].
  [[nodiscard]] double remaining_growth_length(const GrowthState& state,
                                               std::size_t tip) const override;
  /// Limits the advance by surfaces ahead, by other fronts and by the front's own size.
  [[nodiscard]] AdvanceLimit advance_limit(const GrowthState& state, std::size_t tip, double share,
                                           double ds) const override;
  /// Ends the growth at a surface that is next to reached, else because no mesh could be made.
  /// Empty the first time where a breakthrough, earlier than usual, is another way.
  [[nodiscard]] std::optional<GrowthEvent>
  handle_unmeshable_advance(bool passage, const std::string& why) override;

protected:
  explicit FrontKinematics(const model::Model& model);

  /// The nearest place of another crack.
  struct NeighbourCrack {
    double gap = 0.0; ///< [length]
    std::size_t crack = 0;
  };
  /// Empty: no surface is ahead.
  [[nodiscard]] virtual std::optional<LigamentDepths> ligament(std::size_t tip) const = 0;
  /// The longest way to any surface from places of a tip's front that has gone round a corner of
  /// the body, so that none of its tips has one ahead. Empty: it has not.
  [[nodiscard]] virtual std::optional<LigamentDepths> ligament_in_corner(std::size_t tip) const = 0;
  /// Whether something of the front is left in the body once a tip has gone through the surface.
  [[nodiscard]] virtual bool goes_beyond_surface(std::size_t tip,
                                                 const LigamentDepths& before) const = 0;
  /// Empty: there is no other crack.
  [[nodiscard]] virtual std::optional<NeighbourCrack> neighbour(std::size_t tip) const = 0;
  /// Whether the two go on as one crack where a tip meets another one.
  [[nodiscard]] virtual bool coalesces_with(std::size_t tip, const NeighbourCrack& other) const = 0;
  /// From the crack's place to a tip [length].
  [[nodiscard]] virtual double crack_depth_behind_tip(std::size_t tip) const = 0;
  /// The longest advance of a tip [length].
  [[nodiscard]] virtual double longest_advance(std::size_t tip) const = 0;

  /// Whether two cracks lie in one plane and differ in nothing that counts behind their meeting.
  [[nodiscard]] bool may_join(const model::CrackDefinition& one,
                              const model::CrackDefinition& other) const;

  /// A state of these cracks counts: they are kept, and what could not be meshed at the last one
  /// says nothing any more.
  void accept_cracks(const std::vector<model::CrackDefinition>& cracks, GrowthState& state);
  /// The deck's cracks as they have grown. Throws base::CorruptStoredField for cracks or tips that
  /// the deck does not have, and a tip of a crack that has become a part of another one.
  void restore_cracks(const GrowthState& state, std::vector<model::CrackDefinition>& cracks) const;

  const model::Model& model_;
  SolidBodyQuery around_;
  std::vector<double> first_arm_; ///< [tip]

private:
  bool must_break_through_early_ =
      false; ///< nearer to the surface, or to another front, nothing can be meshed
};

} // namespace spricka::growth
