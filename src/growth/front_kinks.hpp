// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/growing_front.hpp"
#include "growth/state.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <vector>

namespace spricka::growth {

/// How the tips of free fronts leave the plane of their crack by K1 and K2. Where $GROW leaves them
/// in it all of them go straight on.
class FrontKinks {
public:
  explicit FrontKinks(const model::Model& model) : model_(model) {}

  /// Whether fronts may leave their planes.
  [[nodiscard]] bool may_leave_plane() const;
  /// For so many tips, none of which has turned.
  void start_without_turns(std::size_t tips);
  /// Takes turns and curvatures out of the last stations.
  void take_turns_of_last_stations(const GrowthState& state);
  /// The cracks on trial are those of the last station, or have advanced from there by so much
  /// [tip] [length].
  void reset_trial();
  void set_trial_advances(const std::vector<double>& by);
  /// The way on of a tip, unit, of a part of an advance that ends so far ahead [length].
  [[nodiscard]] base::Vec3 tip_growth_direction(const mesh::FrontFrame& at, std::size_t tip,
                                                double by) const;
  /// Smooths the turns found along a front on trial and adds them up to headings.
  void add_smoothed_turns(const GrowingFront& of, std::vector<TipStation>& found) const;

private:
  /// What the last station says of a tip that turns.
  struct TipKink {
    double heading = 0.0;   ///< the way on, all turns taken together [rad]
    double turn = 0.0;      ///< of it against the crack's last part [rad]
    double curvature = 0.0; ///< of its way so far [rad/length]
  };
  [[nodiscard]] double turn_on(std::size_t tip, double by) const;

  const model::Model& model_;
  std::vector<TipKink> turning_; ///< [tip]
  std::vector<double> part_;     ///< [tip] direction of the crack's last part on trial [rad]
};

} // namespace spricka::growth
