// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/quantity.hpp"
#include "base/vec.hpp"

#include <array>
#include <string_view>

/// What is found at a node of a contact surface: the record, and a row for each of its quantities,
/// from which pressure.csv, results.h5 and tables on request are made (manual, new_result.md).
namespace spricka::results {

/// What a contact surface does at a node; stick and slip only where there is friction.
enum class ContactState : char { open, closed, stick, slip };
/// "open", "closed", "stick", "slip".
const char* display_word(ContactState state);

/// One node of a contact surface at the end of a step.
struct ContactPoint {
  base::NodeId node;
  base::Vec3 x = base::Vec3::Zero();
  double theta = 0.0; ///< from +x about the arc's centre [rad]; straight surfaces: 0
  double arc = 0.0;   ///< along the deck's slave [length]
  double p_lumped = 0.0;
  double p_consistent = 0.0;
  double q_lumped = 0.0; ///< shear on the slave along its surface, its body on the left; in space
                         ///< its size
  double q_consistent = 0.0;
  base::Vec3 shear = base::Vec3::Zero(); ///< on the slave, in space
  double slip = 0.0;                     ///< of the slave along the same, while in contact [length]
  double slip_path = 0.0;                ///< all its ways added up [length]
  ContactState state = ContactState::open;
  double gap = 0.0; ///< normal gap in the end, pressed: 0 [length]
  bool closed = false;
  int crack_face = 0; ///< +1, -1 on the two faces of a crack mouth, else 0
};

/// Where a quantity of a contact point is found, to be added up.
enum ContactPointOutputPlace : unsigned {
  in_pressure_csv = 1,
  in_pressure_h5 = 2,     ///< the table pressure of results.h5
  in_pressure_output = 4, ///< what $OUTPUT FORMAT=CSV writes for CPRESS
  in_all_pressures = 7
};

/// One quantity of a contact point: a number, or the word of a state.
struct ContactPointQuantity {
  /// How a quantity follows from the record of a point.
  using Function = double(const ContactPoint&);

  const char* name; ///< as columns have it: "p_lumped"; $OUTPUT P_LUMPED
  base::QuantityKind kind;
  std::string_view doc;
  double ContactPoint::*member = nullptr;      ///< where the record has it, or
  Function* computed = nullptr;                ///< how it follows from the record, or
  ContactState ContactPoint::*state = nullptr; ///< it is a word
  unsigned places = in_all_pressures;
  bool friction = false; ///< shown where there is some; results.h5 has it always
  int least_dim = 2;     ///< of the models that have it in pressure.csv: z and shear in space

  /// Whether the quantity is shown in an output.
  [[nodiscard]] bool appears_in(ContactPointOutputPlace place) const {
    return (places & place) != 0;
  }
  [[nodiscard]] bool is_word() const { return state != nullptr; }
  /// The number of this quantity at a point; not for one that is a word.
  [[nodiscard]] double extract_value(const ContactPoint& point) const {
    return member != nullptr ? point.*member : computed(point);
  }
};

/// A coordinate x, y or z (c = 0, 1, 2) of the node.
template <int c> double node_coordinate(const ContactPoint& point) {
  return point.x[c];
}
/// A component (c = 0, 1, 2) of the shear traction on the slave.
template <int c> double shear_component(const ContactPoint& point) {
  return point.shear[c];
}

/// A quantity that is a coordinate of the node; of the third only between solids.
constexpr ContactPointQuantity node_coordinate_quantity(const char* name,
                                                        ContactPointQuantity::Function* computed,
                                                        int least_dim) {
  return {.name = name,
          .kind = base::QuantityKind::length,
          .doc = "the node, undeformed",
          .computed = computed,
          .places = in_pressure_csv | in_pressure_h5,
          .least_dim = least_dim};
}

/// A quantity that is a component of the shear traction.
constexpr ContactPointQuantity shear_component_quantity(const char* name,
                                                        ContactPointQuantity::Function* computed) {
  return {.name = name,
          .kind = base::QuantityKind::stress,
          .doc = "shear traction on the slave, between solids",
          .computed = computed,
          .places = in_pressure_csv,
          .friction = true,
          .least_dim = 3};
}

/// In the order of pressure.csv: name of the contact and increment stand in front of them.
inline constexpr std::array point_quantities{
    node_coordinate_quantity("x", node_coordinate<0>, 2),
    node_coordinate_quantity("y", node_coordinate<1>, 2),
    node_coordinate_quantity("z", node_coordinate<2>, 3),
    ContactPointQuantity{
        .name = "theta",
        .kind = base::QuantityKind::angle,
        .doc = "angle about the centre of the slave's circle, or the axis it has in space",
        .member = &ContactPoint::theta,
        .places = in_pressure_csv | in_pressure_h5},
    ContactPointQuantity{.name = "arc",
                         .kind = base::QuantityKind::length,
                         .doc = "length along the slave, in space along its axis",
                         .member = &ContactPoint::arc,
                         .places = in_pressure_csv | in_pressure_h5,
                         .least_dim = 3},
    ContactPointQuantity{.name = "p_lumped",
                         .kind = base::QuantityKind::stress,
                         .doc = "pressure, force over the node's share of the surface",
                         .member = &ContactPoint::p_lumped},
    ContactPointQuantity{.name = "p_consistent",
                         .kind = base::QuantityKind::stress,
                         .doc = "pressure from the consistent surface mass",
                         .member = &ContactPoint::p_consistent},
    ContactPointQuantity{.name = "q_lumped",
                         .kind = base::QuantityKind::stress,
                         .doc = "shear traction on the slave, recovered as p_lumped",
                         .member = &ContactPoint::q_lumped,
                         .friction = true},
    ContactPointQuantity{.name = "q_consistent",
                         .kind = base::QuantityKind::stress,
                         .doc = "shear traction on the slave, recovered as p_consistent",
                         .member = &ContactPoint::q_consistent,
                         .friction = true},
    shear_component_quantity("q_x", shear_component<0>),
    shear_component_quantity("q_y", shear_component<1>),
    shear_component_quantity("q_z", shear_component<2>),
    ContactPointQuantity{.name = "slip",
                         .kind = base::QuantityKind::length,
                         .doc = "what the slave has slipped while in contact",
                         .member = &ContactPoint::slip,
                         .friction = true},
    ContactPointQuantity{.name = "slip_path",
                         .kind = base::QuantityKind::length,
                         .doc = "all ways of it added up",
                         .member = &ContactPoint::slip_path,
                         .places = in_pressure_csv | in_pressure_output,
                         .friction = true},
    ContactPointQuantity{.name = "state",
                         .kind = base::QuantityKind::number,
                         .doc = "open, closed, stick or slip",
                         .state = &ContactPoint::state,
                         .places = in_pressure_csv | in_pressure_h5,
                         .friction = true},
    ContactPointQuantity{.name = "gap",
                         .kind = base::QuantityKind::length,
                         .doc = "normal gap, 0 where pressed",
                         .member = &ContactPoint::gap,
                         .places = in_pressure_h5 | in_pressure_output},
};

} // namespace spricka::results
