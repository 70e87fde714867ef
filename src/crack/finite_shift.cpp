// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/finite_shift.hpp"

#include "crack/interaction_terms.hpp"
#include "crack/load_fields.hpp"
#include "fe/thermal_kernel.hpp"

namespace spricka::crack {

namespace {

/// Nodes of one field moved along e1.
struct Shift {
  const TipContext& set;
  std::map<base::NodeId, double> q;
  double s = 0.0;
  const base::Vector& u;
  const std::vector<BodyForceField>& fields;

  [[nodiscard]] base::Vec2 step_of(base::NodeId n) const {
    return s * extension_of_node(q, n) * set.tip.e1;
  }
};

/// An element at the places to which its nodes have moved.
struct ShiftedElement {
  base::ElementId e;
  const PlaneElement& element;
  PlaneVectors X;
  PlaneVectors U;
  fe::ConstitutiveLaw law;

  ShiftedElement(const Shift& shift, base::ElementId e_)
      : e(e_), element(plane_reference_element(shift.set.mesh, e)),
        X(fe::element_coordinates(element, shift.set.mesh, e)),
        U(fe::gather_element_values(element, shift.set.mesh, e, shift.u)),
        law(fe::constitutive_law(shift.set.model, shift.set.mesh, e)) {
    const PlaneValues moved = extension_at_element_nodes(shift.set.mesh, e, shift.q);
    X += (shift.s * shift.set.tip.e1) * moved.transpose();
    law.thickness = 1.0; // G counts per unit of it
  }
};

// Work of the forces per volume on the displacements of an element.
double body_work(const Shift& shift, const ShiftedElement& at) {
  const TipContext& set = shift.set;
  double work = 0.0;
  const auto add = [&](const shape::Point<2>& r, double weight, const base::Vec2& b) {
    const PlaneValues N = at.element.N(r);
    const base::Vec2 value = at.U * N;
    work += weight * fe::jacobian(at.element, at.X, r).det * set.relative_depth(at.X * N) *
            b.dot(value);
  };
  visit_body_force_points<2>(set.mesh, shift.fields, at.e, at.X, add);
  return work;
}

// Of displacements U, per unit of the front.
double strain_energy(const TipContext& set, const ShiftedElement& at, const PlaneVectors& U) {
  const double front = set.is_axisymmetric() ? at.law.depth(set.tip.x.x()) : 1.0;
  return 0.5 * U.cwiseProduct(fe::element_force(at.element, at.X, at.law, U)).sum() / front;
}

// Strain energy of an element and what its temperature, a field that stays where it is, makes of
// it, but for what does not depend on u.
double heated_energy(const Shift& shift, const ShiftedElement& moved) {
  const auto& [e, element, X, U, law] = moved;
  const TipContext& set = shift.set;
  const PlaneVectors before = fe::element_coordinates(element, set.mesh, e);
  const fe::CornerValues<2> T =
      fe::gather_corner_temperatures(element, set.mesh, e, set.loads.temperature);
  const double beta = law.expansion * (law.heated_direction_count() * law.lambda + 2.0 * law.mu);
  double thermal = 0.0;
  if (fe::FreeExpansion::must_remove_beforehand(element, before, law)) {
    // The expansion of the element where it was, at the places that its nodes have now.
    const fe::FreeExpansion free(element, before, law, T);
    for (const auto& point : shape::quadrature<2>(element.domain, domain_degree)) {
      const base::Vec2 x = X * element.N(point.r);
      thermal += point.weight * fe::jacobian(element, X, point.r).det * beta * free.temperature(x) *
                 free.gradient(x)(0, 0);
    }
    return strain_energy(set, moved, U - free.at_nodes(X)) - thermal;
  }
  const PlaneValues q = extension_at_element_nodes(set.mesh, e, shift.q);
  for (const auto& point : shape::quadrature<2>(element.domain, domain_degree)) {
    const fe::Jacobian<PlaneElement> at = fe::jacobian(element, X, point.r);
    const PlaneValues N = element.N(point.r);
    const base::Vec2 by_r = element.linear_element().dN(point.r).transpose() * T;
    const base::Vec2 slope = fe::jacobian(element, before, point.r).J.transpose().inverse() * by_r;
    // A point that q has carried on by s meets the field ahead of it, which stays in space.
    const double here =
        T.dot(element.linear_element().N(point.r)) + shift.s * q.dot(N) * slope.dot(set.tip.e1);
    const double hoop = U.row(0) * fe::HoopStrain<PlaneElement>(element, X, law, point.r).h;
    const Eigen::Matrix2d H = U.lazyProduct(at.dNdx);
    thermal += point.weight * at.det * set.relative_depth(X * N) * beta * here * (H.trace() + hoop);
  }
  return strain_energy(set, moved, U) - thermal;
}

// Strain energy less the work of what fills the elements.
double element_energy(const Shift& shift, base::ElementId e) {
  const FrontLoads& loads = shift.set.loads;
  const ShiftedElement moved(shift, e);
  const double strain = loads.temperature.size() > 0 ? heated_energy(shift, moved)
                                                     : strain_energy(shift.set, moved, moved.U);
  return loads.has_element_loads() ? strain - body_work(shift, moved) : strain;
}

double face_work(const Shift& shift, const ActingLoad& acting, const model::Face& face,
                 const base::Vec2& u_tip, const fe::FieldMagnitude& scale) {
  geometry::ElementSide side = model::element_side(shift.set.mesh, face);
  for (std::size_t i = 0; i < side.nodes.size(); ++i) {
    side.X.col(static_cast<Eigen::Index>(i)).head<2>() += shift.step_of(side.nodes[i]);
  }
  const SideVectors<2> U = side_displacements<2>(side, shift.u).colwise() - u_tip;
  double work = 0.0;
  for (const auto& point : fe::load_rule(side, *acting.load, scale).points) {
    const geometry::SideValues N = side.N(point.r);
    const base::Vec3 x = side.X * N;
    const base::Vec2 u = U * N;
    work += point.weight * shift.set.relative_depth(x.head<2>()) *
            load_force_on_face(acting, x, side.area_vector(point.r)).head<2>().dot(u);
  }
  return work;
}

double potential_energy(const Shift& shift, const VirtualExtensionField& field) {
  const TipContext& set = shift.set;
  std::vector<base::ElementId> elements = field.elements;
  // Elements that move as one keep their strain energy; the work of a field in space changes.
  // About an axis they come to other radii.
  if (set.loads.has_element_loads() || set.is_axisymmetric()) {
    elements.insert(elements.end(), field.inside.begin(), field.inside.end());
  }
  double energy = 0.0;
  for (const base::ElementId e : elements) {
    energy += element_energy(shift, e);
  }
  // The tip is the node that stands at its place (and has no twin).
  base::Vec2 u_tip = base::Vec2::Zero();
  for (const auto& [node, q] : shift.q) {
    if (set.mesh.x[node.index()].head<2>() == set.tip.x) {
      u_tip = shift.u.segment<2>(2 * static_cast<Eigen::Index>(node.index()));
    }
  }
  for (const ActingLoad& acting : set.loads.loads) {
    const fe::FieldMagnitude scale = face_load_scale(set.mesh, acting);
    for (const model::Face& face : acting.faces) {
      energy -= face_work(shift, acting, face, u_tip, scale);
    }
  }
  return energy;
}

} // namespace

double finite_shift_release_rate(const TipContext& set, const VirtualExtensionField& field,
                                 double s, const base::Vector& u) {
  const std::map<base::NodeId, double> q = field.extension_by_node();
  const std::vector<BodyForceField> fields =
      body_force_fields(set.model, set.mesh, set.loads, LoadScaleScope::whole_set);
  // (crack.15).
  const double back =
      potential_energy({.set = set, .q = q, .s = -s, .u = u, .fields = fields}, field);
  const double ahead =
      potential_energy({.set = set, .q = q, .s = s, .u = u, .fields = fields}, field);
  return (back - ahead) / (2.0 * s);
}

} // namespace spricka::crack
