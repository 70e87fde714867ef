// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_arc.hpp"
#include "growth/solid_surroundings.hpp"
#include "growth/ways.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::growth {

/// Cracks in space whose fronts take the shape that K gives them: tips are points spread evenly
/// along the part of a front that lies in the body, each goes on across the front in the crack's
/// plane, and the next front is a smooth curve through them, trimmed or continued to the surface.
/// Where it comes near to a surface ahead, the points there go through it.
class FreeWays final : public Ways {
public:
  /// Points of an open front and of one that is closed at first.
  static constexpr std::size_t open_points = 9;
  static constexpr std::size_t closed_points = 16;

  explicit FreeWays(const model::Model& model);

  [[nodiscard]] const std::vector<GrowingTip>& tips() const override { return tips_; }
  [[nodiscard]] bool turns() const override { return false; }
  void go_on(const State& state) override;
  [[nodiscard]] CrackState here() override;
  [[nodiscard]] double first_arm(std::size_t tip) const override { return first_arm_[tip]; }
  [[nodiscard]] double length_left(const State& state, std::size_t tip) const override;
  [[nodiscard]] WayLimit limit(const State& state, std::size_t tip, double share,
                               double ds) const override;
  void damp(std::vector<double>& by) const override;
  std::optional<CrackState> advanced(const State& state, const Advance& advance,
                                     base::Diagnostics& diagnostics) override;
  void place(std::vector<TipStation>& found) const override;
  void settle(State& state) override;
  [[nodiscard]] std::optional<WayEnd> refused(const State& state, bool leapt,
                                              const std::string& why) override;
  [[nodiscard]] CrackState straight_on(const State& state, double advance) const override;

private:
  /// The tips of a crack.
  struct Growing {
    std::size_t crack = 0;
    std::size_t first = 0, count = 0; ///< tips
  };
  /// What is left before a tip.
  struct Ligament {
    double left = 0.0;
    double part = 1.0; ///< of the way from the crack's place to the surface
  };
  void find_ligaments();
  [[nodiscard]] mesh::FrontFrame frame(const Growing& of, std::size_t number) const;
  [[nodiscard]] CrackState state_of(const std::vector<model::Crack>& cracks,
                                    const std::vector<std::optional<FrontArc>>& arcs) const;
  /// Points of the next front, those in front of which next to nothing is left out.
  struct NextPoints {
    std::vector<base::Vec3> points;
    bool closed = false;
  };
  [[nodiscard]] NextPoints next_points(const Growing& of, const Advance& advance) const;
  [[nodiscard]] std::optional<WayLimit> limit_by_fronts(const Growing& of, std::size_t tip,
                                                        double share, double ds) const;
  [[nodiscard]] bool goes_on_behind(const Growing& of, double gap) const;
  [[nodiscard]] const Growing& crack_of(std::size_t tip) const;

  const model::Model& model_;
  SolidSurroundings around_;
  std::vector<GrowingTip> tips_;
  std::vector<double> first_arm_; ///< [tip]
  std::vector<Growing> growing_;
  std::vector<model::Crack> cracks_, trial_; ///< at the last station that counts; to be solved
  std::vector<std::optional<FrontArc>> arcs_, trial_arcs_; ///< [growing]
  std::vector<Ligament> ligaments_;                        ///< [tip]
  bool leap_early_ = false; ///< nearer to the surface nothing can be meshed
};

} // namespace spricka::growth
