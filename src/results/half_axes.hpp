// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// Where fronts in space cross the axes of their cracks: what tables and tests call a and c.
namespace spricka::results {

/// The end of an axis of a crack on its front, between two of its points; of an end on a surface
/// the place of values is 10 degrees (of the ellipse's parametric angle) inside.
struct FrontAxisEnd {
  std::string tip{}; ///< "C1.A", "C1.C2"
  bool on_a = true;  ///< of the axis A, else of C
  std::size_t from = 0, to = 0;
  double part = 0.0; ///< of the way from one to the other
  double size = 0.0; ///< from the crack's place [length]

  /// What has these values at `from` and `to`.
  [[nodiscard]] double interpolate(double at_from, double at_to) const {
    return (1.0 - part) * at_from + part * at_to;
  }
};

/// Ends of both axes of a crack, first A, as far as a front through `points` has them; where it has
/// both of an axis they are numbered. An end of the front counts up to 27 degrees beside the axis.
std::vector<FrontAxisEnd> find_front_axis_ends(const model::CrackDefinition& crack,
                                               const std::vector<base::Vec3>& points, bool closed);

/// Half axes a and c [length]: half of what the ends span where both are there; 0: no end.
std::array<double, 2> half_axes(const std::vector<FrontAxisEnd>& ends);

/// The crack of a front's name, "C1" or "C1.2"; null: none.
const model::CrackDefinition* find_crack_by_front(const model::Model& model,
                                                  std::string_view front);

} // namespace spricka::results
