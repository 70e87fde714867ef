// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "base/vec.hpp"
#include "results/contact_point.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// What is found of a contact: the record, and a row for each quantity that is one number of it,
/// for $CHECK and sweeps (manual, new_result.md).
namespace spricka::results {

struct ContactResult {
  std::string name;
  bool mounted = true;
  std::vector<ContactPoint> points; ///< in order along the surface
  /// Between solids: three places in `points` for each triangle on which pressure is linear.
  std::vector<int> corners;
  base::Vec3 force_on_slave = base::Vec3::Zero();  ///< deck's slave
  base::Vec3 moment_on_slave = base::Vec3::Zero(); ///< about the origin, in space [force * length]
  double min_pressure = 0.0; ///< of the multipliers: the inequality that the solution obeys
  double max_pressure = 0.0;
  double mean_pressure = 0.0;   ///< force magnitude integral / area in contact surface
  double max_penetration = 0.0; ///< largest negative weighted gap [length]
  double area = 0.0;            ///< of the part in contact, in space [length^2]
  bool space = false;           ///< between solids: it has no arc
  /// Between solids: mean radius where the surface is one cylinder or cone, round which points have
  /// theta and along which they have arc; else 0.
  double radius = 0.0;
  bool round = false;    ///< the surface lies on a circle
  double arc_from = 0.0; ///< on a circle [rad], whole: -pi .. pi; else along the slave [length]
  double arc_to = 0.0;
  int closed = 0;
  int rows = 0;
  bool sheared = false; ///< it has tangential forces: bonded, or with friction
  bool rubs = false;    ///< it has friction, and what follows
  int sticking = 0;
  int slipping = 0;
  double shear_ratio = 0.0; ///< largest |q| / (mu p) of the multipliers, at most 1
  double max_slip = 0.0;    ///< longest slip path [length]
  double stick_area = 0.0;  ///< in space, of what sticks [length^2]
  double stick_from = 0.0;  ///< longest sticking part, like arc_from
  double stick_to = 0.0;
  double friction_work = 0.0; ///< taken by friction since the pair was mounted [force * length]
  /// Edges up to which the contact is pressed: there the pressure has no bound.
  std::vector<base::Vec3> unbounded;
};

/// When a contact has a quantity.
enum class ContactQuantityCondition {
  always,
  with_friction,
  where_it_sticks, ///< in the plane
  in_plane,
  between_solids,
  with_friction_between_solids
};

/// One number of a contact; a name that is empty: it is not there.
struct ContactQuantity {
  std::string_view sweep;  ///< column of sweep.csv: "PMAX"
  std::string_view check;  ///< word of $CHECK: "CPRESS.MEAN"
  base::QuantityKind kind; ///< angle: of a circle, else a length
  std::string_view doc;
  double ContactResult::*member;
  ContactQuantityCondition given = ContactQuantityCondition::always;
};

/// Sweeps have them in this order.
inline constexpr auto contact_quantities = std::to_array<ContactQuantity>({
    {"PMAX", "", base::QuantityKind::stress, "largest pressure of the multipliers",
     &ContactResult::max_pressure},
    {"PMEAN", "CPRESS.MEAN", base::QuantityKind::stress, "mean pressure over the part in contact",
     &ContactResult::mean_pressure},
    {"PMIN", "", base::QuantityKind::stress, "smallest pressure of the multipliers",
     &ContactResult::min_pressure},
    {"", "CONTACT.AREA", base::QuantityKind::area, "area of the part in contact, between solids",
     &ContactResult::area, ContactQuantityCondition::between_solids},
    {"", "ARC.FROM", base::QuantityKind::angle,
     "first angle of the longest part in contact; on a slave that is no circle the length along it",
     &ContactResult::arc_from, ContactQuantityCondition::in_plane},
    {"", "ARC.TO", base::QuantityKind::angle, "last angle of the longest part, or length",
     &ContactResult::arc_to, ContactQuantityCondition::in_plane},
    {"", "STICK.FROM", base::QuantityKind::angle, "first angle of the part that sticks, or length",
     &ContactResult::stick_from, ContactQuantityCondition::where_it_sticks},
    {"", "STICK.TO", base::QuantityKind::angle, "last angle of the part that sticks, or length",
     &ContactResult::stick_to, ContactQuantityCondition::where_it_sticks},
    {"", "STICK.AREA", base::QuantityKind::area, "area of the part that sticks, between solids",
     &ContactResult::stick_area, ContactQuantityCondition::with_friction_between_solids},
    {"", "SLIP.MAX", base::QuantityKind::length, "longest way a point has slipped, to and fro",
     &ContactResult::max_slip, ContactQuantityCondition::with_friction},
    {"", "FRICTION.WORK", base::QuantityKind::energy, "work that friction has taken",
     &ContactResult::friction_work, ContactQuantityCondition::with_friction},
});

} // namespace spricka::results
