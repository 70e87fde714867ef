// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/solid_surroundings.hpp"
#include "mesh/front_curve.hpp"
#include "model/cracks.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// The fronts of cracks in space that take their own shape: the part of a front in the body, and
/// the front that follows when its points go on.
namespace spricka::growth {

/// A front has so many points at least.
inline constexpr std::size_t fewest_front_points = 4;

/// What of a crack's front lies in the body.
struct BodyFrontArc {
  mesh::FrontCurve curve; ///< m points out of the crack

  [[nodiscard]] bool is_closed() const { return curve.closed(); }
  /// The place of a point of `count` spread evenly along it, or between two of them [length].
  [[nodiscard]] double arc_position(double number, std::size_t count) const;
  /// Its place that is nearest to x.
  [[nodiscard]] base::Vec3 nearest(const base::Vec3& x) const;
};

/// The parts of a front that are in the body, in the order along it.
std::vector<BodyFrontArc> front_arcs_in_body(const model::CrackDefinition& crack,
                                             const SolidBodyQuery& around);

/// The only part; empty: there is none, or more than one.
std::optional<BodyFrontArc> single_front_arc_in_body(const model::CrackDefinition& crack,
                                                     const SolidBodyQuery& around);

/// A crack whose front goes through these points, in the order of an arc's, and straight on out of
/// the body at the ends of an open one. Empty: it does not come out.
std::optional<model::CrackDefinition>
make_crack_through_points(const model::CrackDefinition& before,
                          const std::vector<base::Vec3>& points, bool closed,
                          const SolidBodyQuery& around);

/// Where places of a front (`from`) go to, without those that would pass one another, where a notch
/// closes: the ends of an open front stay.
std::vector<base::Vec3> drop_crossing_points(const std::vector<mesh::FrontFrame>& from,
                                             const std::vector<base::Vec3>& to, bool closed);

} // namespace spricka::growth
