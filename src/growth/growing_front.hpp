// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/front_arc.hpp"
#include "growth/front_waves.hpp"
#include "model/cracks.hpp"

#include <cstddef>
#include <vector>

namespace spricka::growth {

/// A free front that moves: tips are points spread evenly along it.
struct GrowingFront {
  std::size_t crack = 0;
  std::vector<std::size_t> tips; ///< in the order along it
  BodyFrontArc arc;
  std::vector<base::Vec3> line{}; ///< on trial: as it is drawn, out of the body at its ends

  /// Place and axes of the front at the tip of a number along it, 0 the first.
  [[nodiscard]] mesh::FrontFrame frame_at(std::size_t number) const {
    return frame_between(static_cast<double>(number));
  }
  /// The same between two tips, by a number that need not be whole.
  [[nodiscard]] mesh::FrontFrame frame_between(double number) const {
    return arc.curve.at(arc.arc_position(number, tips.size()));
  }
  /// The tip that such a number is nearest to.
  [[nodiscard]] std::size_t nearest_tip(double number) const;
  /// What the front advances there, `by` what its tips do [tip] [length].
  [[nodiscard]] double advance_between(double number, const std::vector<double>& by) const;
  [[nodiscard]] FrontKind kind() const;
};

/// Where a tip is.
struct TipOnFront {
  const GrowingFront& of;
  std::size_t growing = 0; ///< which that is
  std::size_t number = 0;  ///< of its points
  [[nodiscard]] mesh::FrontFrame tip_frame() const { return of.frame_at(number); }
};

/// The cracks of a body and their fronts that move, in the order of the cracks.
struct MovingFronts {
  std::vector<model::CrackDefinition> cracks;
  std::vector<GrowingFront> growing;

  [[nodiscard]] TipOnFront find_tip_on_front(std::size_t tip) const;
};

} // namespace spricka::growth
