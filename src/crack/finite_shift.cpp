// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/finite_shift.hpp"

#include "crack/load_fields.hpp"
#include "fe/face.hpp"
#include "fe/thermal_kernel.hpp"

namespace spricka::crack {

namespace {

/// Nodes of one field moved along e1.
struct Shift {
  const TipSetting& set;
  std::map<base::NodeId, double> q;
  double s = 0.0;
  const base::Vector& u;
  const std::vector<BodyField>& fields;

  template <shape::PlaneShape S> [[nodiscard]] fe::NodeVectors<S> moved(base::ElementId e) const {
    fe::NodeVectors<S> X = fe::coordinates<S>(set.mesh, e);
    X += s * set.tip.e1 * extension_at<S>(set.mesh, e, q).transpose();
    return X;
  }
  [[nodiscard]] base::Vec2 step_of(base::NodeId n) const {
    const auto at = q.find(n);
    return at == q.end() ? base::Vec2(base::Vec2::Zero()) : base::Vec2(s * at->second * set.tip.e1);
  }
};

// Work of the forces per volume on the displacements U of an element at nodes X.
template <shape::PlaneShape S>
double body_work(const Shift& shift, base::ElementId e, const fe::NodeVectors<S>& X,
                 const fe::NodeVectors<S>& U) {
  const TipSetting& set = shift.set;
  double work = 0.0;
  for_body_forces<S>(
      shift.fields, e, X, [&](const shape::Point<2>& r, double weight, const base::Vec2& b) {
        const base::Vec2 value = U * S::N(r);
        work += weight * fe::jacobian<S>(X, r).det * set.depth(X * S::N(r)) * b.dot(value);
      });
  return work;
}

// Per unit of the front.
template <shape::PlaneShape S>
double strain_energy(const TipSetting& set, const fe::NodeVectors<S>& X, const fe::Law& law,
                     const fe::NodeVectors<S>& U) {
  const double front = set.axial() ? law.depth(set.tip.x.x()) : 1.0;
  return 0.5 * U.cwiseProduct(fe::element_force<S>(X, law, U)).sum() / front;
}

// Strain energy of an element and what its temperature, a field that stays where it is, makes of
// it, but for what does not depend on u.
template <shape::PlaneShape S>
double heated_energy(const Shift& shift, base::ElementId e, const fe::NodeVectors<S>& X,
                     const fe::Law& law) {
  const TipSetting& set = shift.set;
  const fe::NodeVectors<S> before = fe::coordinates<S>(set.mesh, e);
  fe::NodeVectors<S> U = fe::gather<S>(set.mesh, e, shift.u);
  const auto T = fe::corner_temperature<S>(set.mesh, e, set.loads.temperature);
  const double beta = law.expansion * (law.heated_directions() * law.lambda + 2.0 * law.mu);
  double thermal = 0.0;
  if (fe::FreeExpansion<S>::wanted(before, law)) {
    // The expansion of the element where it was, at the places that its nodes have now.
    const fe::FreeExpansion<S> free(before, law, T);
    U -= free.at_nodes(X);
    for (const auto& point : shape::quadrature<S>(domain_degree)) {
      const base::Vec2 x = X * S::N(point.r);
      thermal += point.weight * fe::jacobian<S>(X, point.r).det * beta * free.temperature(x) *
                 free.gradient(x)(0, 0);
    }
  } else {
    const Eigen::Matrix<double, S::nodes, 1> q = extension_at<S>(set.mesh, e, shift.q);
    for (const auto& point : shape::quadrature<S>(domain_degree)) {
      using Linear = fe::Linear<S>;
      const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
      const base::Vec2 slope = fe::jacobian<S>(before, point.r).J.transpose().inverse() *
                               Linear::dN(point.r).transpose() * T;
      // A point that q has carried on by s meets the field ahead of it, which stays in space.
      const double here =
          T.dot(Linear::N(point.r)) + shift.s * q.dot(S::N(point.r)) * slope.dot(set.tip.e1);
      const double hoop = U.row(0) * fe::Hoop<S>(X, law, point.r).h;
      thermal += point.weight * at.det * set.depth(X * S::N(point.r)) * beta * here *
                 ((U * at.dNdx).trace() + hoop);
    }
  }
  return strain_energy<S>(set, X, law, U) - thermal;
}

// Strain energy less the work of what fills the elements.
template <shape::PlaneShape S> double element_energy(const Shift& shift, base::ElementId e) {
  const TipSetting& set = shift.set;
  const fe::NodeVectors<S> X = shift.moved<S>(e);
  const fe::NodeVectors<S> U = fe::gather<S>(set.mesh, e, shift.u);
  fe::Law law = fe::law_of(set.model, set.mesh, e);
  law.thickness = 1.0; // G counts per unit of it
  const double strain = set.loads.temperature.size() > 0 ? heated_energy<S>(shift, e, X, law)
                                                         : strain_energy<S>(set, X, law, U);
  return set.loads.fill_elements() ? strain - body_work<S>(shift, e, X, U) : strain;
}

template <shape::Shape Side>
double face_work(const Shift& shift, const ActingLoad& acting, const model::Face& face,
                 const base::Vec2& u_tip, const fe::FieldScale& scale) {
  const auto nodes = fe::nodes_of_face<Side>(shift.set.mesh, face);
  fe::SideNodes<Side> X = fe::side_coordinates<Side>(shift.set.mesh, face);
  Eigen::Matrix<double, 2, Side::nodes> U;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    X.col(k).template head<2>() += shift.step_of(nodes[i]);
    U.col(k) = shift.u.segment<2>(2 * static_cast<Eigen::Index>(nodes[i].index())) - u_tip;
  }
  double work = 0.0;
  for (const auto& point : fe::load_rule<Side>(X, *acting.load, scale).points) {
    const auto N = Side::N(point.r);
    const base::Vec2 area = fe::area_vector<Side>(X, point.r).template head<2>();
    const base::Vec2 x = (X * N).template head<2>();
    work += point.weight * area.norm() * shift.set.depth(x) *
            traction(acting, x, area.normalized()).dot(base::Vec2(U * N));
  }
  return work;
}

double potential_energy(const Shift& shift, const ExtensionField& field) {
  const TipSetting& set = shift.set;
  std::vector<base::ElementId> elements = field.elements;
  // Elements that move as one keep their strain energy; the work of a field in space changes.
  // About an axis they come to other radii.
  if (set.loads.fill_elements() || set.axial()) {
    elements.insert(elements.end(), field.inside.begin(), field.inside.end());
  }
  double energy = 0.0;
  fe::for_plane_blocks(set.mesh, elements,
                       [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                         for (const base::ElementId e : block) {
                           energy += element_energy<S>(shift, e);
                         }
                       });
  // The tip is the node that stands at its place (and has no twin).
  base::Vec2 u_tip = base::Vec2::Zero();
  for (const auto& [node, q] : shift.q) {
    if (set.mesh.x[node.index()].head<2>() == set.tip.x) {
      u_tip = shift.u.segment<2>(2 * static_cast<Eigen::Index>(node.index()));
    }
  }
  for (const ActingLoad& acting : set.loads.loads) {
    const fe::FieldScale scale = face_scale(set, acting);
    fe::for_edges(set.mesh, acting.faces, [&]<shape::Shape Side>(Side, const model::Face& face) {
      energy -= face_work<Side>(shift, acting, face, u_tip, scale);
    });
  }
  return energy;
}

} // namespace

double shifted_release_rate(const TipSetting& set, const ExtensionField& field, double s,
                            const base::Vector& u) {
  const std::map<base::NodeId, double> q = field.q();
  const std::vector<BodyField> fields = body_fields(set);
  // (crack.15).
  const double back =
      potential_energy({.set = set, .q = q, .s = -s, .u = u, .fields = fields}, field);
  const double ahead =
      potential_energy({.set = set, .q = q, .s = s, .u = u, .fields = fields}, field);
  return (back - ahead) / (2.0 * s);
}

} // namespace spricka::crack
