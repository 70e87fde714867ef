// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/solid_surroundings.hpp"
#include "growth/ways.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::growth {

/// Cracks in space that stay ellipses, as life programs take them: a tip at each end of an axis
/// that lies in the body. Where both ends of an axis do, their arms grow apart and the centre moves
/// by half of the difference. An end that has gone through the surface stands for the place where
/// the front is nearest to it.
class EllipseWays final : public Ways {
public:
  explicit EllipseWays(const model::Model& model);

  [[nodiscard]] const std::vector<GrowingTip>& tips() const override { return tips_; }
  [[nodiscard]] bool turns() const override { return false; }
  void go_on(const State& state) override;
  [[nodiscard]] CrackState here() override;
  [[nodiscard]] double first_arm(std::size_t tip) const override;
  [[nodiscard]] double length_left(const State& state, std::size_t tip) const override;
  [[nodiscard]] WayLimit limit(const State& state, std::size_t tip, double share,
                               double ds) const override;
  std::optional<CrackState> advanced(const State& state, const Advance& advance,
                                     base::Diagnostics& diagnostics) override;
  void place(std::vector<TipStation>& found) const override;
  void settle(State& state) override;
  [[nodiscard]] std::optional<WayEnd> refused(const State& state, bool leapt,
                                              const std::string& why) override;
  [[nodiscard]] CrackState straight_on(const State& state, double advance) const override;

private:
  /// An end of an axis.
  struct Arm {
    std::size_t crack = 0;
    bool on_a = false;   ///< of the axis A, else of C
    double sign = 1.0;   ///< towards `across` or `along`, or away from it
    bool paired = false; ///< the other end of the axis is an arm as well
  };
  /// What is left before an arm.
  struct Ligament {
    double axis = 0.0; ///< half of it [length]
    double left = 0.0; ///< to the surface [length]
    [[nodiscard]] double part() const { return left / (axis + left); }
  };
  void find_tips();
  [[nodiscard]] CrackState state_of(const std::vector<model::Crack>& cracks) const;
  /// Empty: the arm has left the body.
  [[nodiscard]] std::optional<Ligament> ligament(std::size_t tip) const;
  [[nodiscard]] bool goes_on_behind(std::size_t tip, const Ligament& before) const;
  [[nodiscard]] std::optional<WayLimit> limit_by_cracks(std::size_t tip, double share,
                                                        double ds) const;
  [[nodiscard]] double moved_by(const Arm& arm, const model::Crack& crack,
                                const base::Vec3& x) const;

  const model::Model& model_;
  SolidSurroundings around_;
  std::vector<Arm> arms_; ///< [tip]
  std::vector<GrowingTip> tips_;
  std::vector<model::Crack> cracks_; ///< at the last station that counts
  std::vector<model::Crack> trial_;  ///< to be solved
  bool leap_early_ = false;          ///< nearer to the surface nothing can be meshed
};

} // namespace spricka::growth
