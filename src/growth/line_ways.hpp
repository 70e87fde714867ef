// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/ahead.hpp"
#include "growth/ways.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::growth {

/// Tips of the cracks that grow, in the order of the cracks.
std::vector<GrowingTip> growing_tips(const model::Model& model,
                                     const std::vector<mesh::CrackLine>& lines);

/// Cracks in the plane: along the paths that the deck draws, or as K turns them.
class LineWays final : public Ways {
public:
  /// `lines`: the cracks as they are first.
  LineWays(const model::Model& model, std::vector<mesh::CrackLine> lines);

  [[nodiscard]] const std::vector<GrowingTip>& tips() const override { return tips_; }
  [[nodiscard]] bool turns() const override;
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
  [[nodiscard]] const model::CrackGrowthSettings& rules() const;
  [[nodiscard]] Heading heading_of(const State& state, std::size_t tip) const;
  void limit_by_obstacles(const State& state, std::size_t tip, double share, WayLimit& limit) const;
  void extend(const State& state, std::size_t tip, double by, mesh::CrackLine& line) const;

  const model::Model& model_;
  std::vector<mesh::CrackLine> lines_; ///< at the last station that counts
  std::vector<mesh::CrackLine> trial_; ///< to be solved
  std::vector<GrowingTip> tips_;
  Surroundings around_;
};

} // namespace spricka::growth
