// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/domain_integral.hpp"

#include "crack/auxiliary_field.hpp"
#include "crack/load_fields.hpp"
#include "fe/thermal_kernel.hpp"

#include <algorithm>
#include <array>

namespace spricka::crack {

namespace {

/// The solution at a point of an element.
struct Here : SectionState {
  Tensor<2> nodal;                  ///< gradient of the nodes' displacement
  Tensor<2> strained;               ///< gradient that has this stress, where some expands freely
  double beta_T = 0.0;              ///< stress that the temperature takes out
  base::Vec2 beta_grad_T{0.0, 0.0}; ///< and its gradient
  double free_strain = 0.0;         ///< alpha T as the state has it
};

/// Energy-momentum at a point, in the section and round the axis.
struct Momentum {
  Tensor<2> T = Tensor<2>::Zero();
  double hoop = 0.0;
};

/// One element. Where a part of its temperature expands it freely (fe::FreeExpansion) the nodes'
/// displacement less that of the expansion at the nodes strains it; both ways of writing the energy
/// leave out the same that does not depend on u.
class ElementTerms {
public:
  ElementTerms(const TipSetting& set, const std::vector<BodyForceField>& fields, base::ElementId e,
               const base::Vector& u)
      : set_(set), fields_(fields), e_(e), element_(plane_element(set.mesh, e)),
        X_(fe::coordinates(element_, set.mesh, e)), U_(fe::gather(element_, set.mesh, e, u)),
        k_(set, e), T_(fe::CornerValues<2>::Zero(element_.corners)) {
    if (set.loads.temperature.size() > 0) {
      T_ = fe::corner_temperature(element_, set.mesh, e, set.loads.temperature);
    }
    if ((T_.array() != 0.0).any() && fe::FreeExpansion::is_required(element_, X_, k_.law)) {
      free_ = fe::FreeExpansion(element_, X_, k_.law, T_);
      carried_ = true;
    }
  }

  void add(ConfigurationalForces& out, bool strained, bool filled) const {
    ModeForces force;
    for (const base::NodeId n : set_.mesh.element_nodes(e_)) {
      force.push_back(&out[n]);
    }
    for_domain_points(set_, e_, [&](const shape::Point<2>& r, double weight) {
      add_point(force, r, weight, strained, filled);
    });
    if (filled) {
      add_body_forces(force);
    }
  }

private:
  /// Of the nodes.
  using ModeForces = std::vector<std::array<base::Vec3, auxiliary_field_count>*>;

  void add_point(const ModeForces& force, const shape::Point<2>& r, double weight, bool strained,
                 bool filled) const {
    const fe::Jacobian<PlaneElement> at = fe::jacobian(element_, X_, r);
    const PlaneValues N = element_.N(r);
    const base::Vec2 x = X_ * N;
    const double w = weight * at.det * set_.relative_depth(x);
    const Here own = solution(at, r, x, filled);
    // Partners of K and T meet the affine temperature alone; what differs from it is heat_term's
    // (crack.34).
    const Here met = filled && set_.affine ? under_affine(own, x) : own;
    for (std::size_t k = 0; k < auxiliary_field_count; ++k) {
      const Here& here = k == 0 ? own : met;
      const AuxiliaryField v = k == 0 ? itself(here) : auxiliary_field_at(set_, k_, x, k);
      const Momentum M = strained || set_.is_axisymmetric()
                             ? (k == 0 ? own_momentum(here) : of_both(here, v))
                             : Momentum();
      // What does not hang on the gradient of q: the temperature's gradient on the volume change
      // of u (crack.22) or of v (crack.23), about an axis the way outwards (crack.37) and auxiliary
      // fields that are not at rest.
      base::Vec2 c = base::Vec2::Zero();
      if (filled) {
        const double work = k == 0 && carried_ ? 2.0 * here.free_strain : v.dilatation();
        c = work * here.beta_grad_T;
      }
      if (set_.is_axisymmetric()) {
        c += base::Vec2(M.hoop / x.x(), 0.0) + here.nodal.transpose() * v.divergence;
      }
      for (int n = 0; n < element_.nodes; ++n) {
        auto P = (*force[static_cast<std::size_t>(n)])[k].head<2>();
        const base::Vec2 gradient = at.dNdx.row(n);
        P += w * N[n] * c;
        if (strained) {
          P += w * (M.T * gradient);
        }
        if (k == 0 && carried_) { // nodes carried through the free expansion
          P += w * (free_.gradient(X_.col(n)).transpose() * (own.sigma * gradient));
        }
      }
    }
  }

  // At points of their own: they may bend and jump where the fields do not.
  void add_body_forces(const ModeForces& force) const {
    const auto add = [&](const shape::Point<2>& r, double weight, const base::Vec2& b) {
      const fe::Jacobian<PlaneElement> at = fe::jacobian(element_, X_, r);
      const PlaneValues N = element_.N(r);
      const base::Vec2 x = X_ * N;
      const Polar place = polar(set_.tip, x);
      for (std::size_t k = 0; k < auxiliary_field_count; ++k) {
        const Tensor<2> Hv =
            k == 0 ? Tensor<2>(U_.lazyProduct(at.dNdx)) : auxiliary_field_gradient(set_, place, k);
        // - q b . u,k (crack.19), or with v in the place of u (crack.23).
        const base::Vec2 c = weight * at.det * set_.relative_depth(x) * (Hv.transpose() * b);
        for (int n = 0; n < element_.nodes; ++n) {
          (*force[static_cast<std::size_t>(n)])[k].head<2>() -= N[n] * c;
        }
      }
    };
    for_body_forces(set_, fields_, e_, X_, add);
  }

  [[nodiscard]] Here solution(const fe::Jacobian<PlaneElement>& at, const shape::Point<2>& r,
                              const base::Vec2& x, bool filled) const {
    Here here;
    here.nodal = here.H = here.strained = U_.lazyProduct(at.dNdx);
    here.hoop = U_.row(0) * fe::Hoop<PlaneElement>(element_, X_, k_.law, r).h;
    if (filled) {
      heat(at, r, x, here);
    }
    // (crack.21).
    static_cast<SectionState&>(here) = state_from_gradient(k_, here.H, here.hoop);
    warm(here, here.beta_T);
    return here;
  }

  // The normal stresses that a temperature takes out.
  void warm(Here& here, double beta_T) const {
    here.sigma.diagonal().array() -= beta_T;
    here.sigma_hoop -= set_.is_axisymmetric() ? beta_T : 0.0;
  }

  // What the auxiliary fields of K and T meet: the same displacements under the affine temperature.
  [[nodiscard]] Here under_affine(const Here& own, const base::Vec2& x) const {
    Here here = own;
    const double beta = fe::thermal_modulus(k_.law);
    warm(here, beta * (*set_.affine)(set_.tip, x) - own.beta_T);
    here.beta_grad_T = beta * set_.affine->slope;
    return here;
  }

  void heat(const fe::Jacobian<PlaneElement>& at, const shape::Point<2>& r, const base::Vec2& x,
            Here& here) const {
    const double beta = fe::thermal_modulus(k_.law);
    if (carried_) {
      const Tensor<2> expansion = free_.gradient(x);
      here.beta_T = beta * free_.temperature(x);
      here.beta_grad_T = beta * free_.temperature_gradient();
      here.free_strain = expansion(0, 0);
      here.strained -= free_.at_nodes(X_).lazyProduct(at.dNdx);
      here.H = here.strained + expansion;
      return;
    }
    const base::Vec2 slope = element_.linear_element().dN(r).transpose() * T_; // by r
    here.beta_T = beta * T_.dot(element_.linear_element().N(r));
    here.beta_grad_T = beta * at.J.transpose().inverse() * slope;
  }

  // The solution in the place of a auxiliary field: it is at rest but for loads, which have terms.
  static AuxiliaryField itself(const Here& here) {
    AuxiliaryField v;
    v.H = here.nodal;
    v.hoop = here.hoop;
    return v;
  }

  // Of u with itself, halved: W is half of (sigma - beta T) : eps.
  [[nodiscard]] Momentum own_momentum(const Here& u) const {
    const Tensor<2>& H = carried_ ? u.strained : u.H;
    const double thermal = u.beta_T * (carried_ ? 2.0 * u.free_strain : u.dilatation());
    const double round = u.sigma_hoop * u.hoop;
    const Tensor<2> T = energy_momentum<2>({H, u.sigma}, thermal - round);
    return {T, round - 0.5 * (u.sigma.cwiseProduct(H).sum() + round - thermal)};
  }

  // (crack.10), with the components round the axis.
  static Momentum of_both(const Here& u, const AuxiliaryField& v) {
    Tensor<2> T = energy_momentum<2>({u.H, u.sigma}, {v.H, v.sigma});
    T.diagonal().array() -= u.sigma_hoop * v.hoop;
    return {T, u.sigma_hoop * v.hoop + v.sigma_hoop * u.hoop - u.work_on(v)};
  }

  const TipSetting& set_;
  const std::vector<BodyForceField>& fields_;
  base::ElementId e_;
  const PlaneElement& element_;
  PlaneVectors X_;
  PlaneVectors U_;
  SectionElasticity k_;
  fe::CornerValues<2> T_;
  bool carried_ = false; ///< the nodes, through the free expansion
  fe::FreeExpansion free_;
};

using Elements = std::vector<base::ElementId>;

Elements united(const std::vector<ExtensionField>& fields, Elements ExtensionField::*member) {
  Elements all;
  for (const ExtensionField& f : fields) {
    all.insert(all.end(), (f.*member).begin(), (f.*member).end());
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace

// One vector per node serves all domains (crack.5): outside its own elements the q of a domain is
// constant, and there the gradients of the shape functions of an element sum to zero.
void add_domain_terms(const TipSetting& set, const std::vector<ExtensionField>& fields,
                      const base::Vector& u, ConfigurationalForces& out) {
  const bool filled = set.loads.has_element_loads();
  const std::vector<BodyForceField> loads = body_force_fields(set);
  const Elements strained = united(fields, &ExtensionField::elements);
  Elements rigid;
  // About an axis also elements that q moves as one come to other radii.
  if (filled || set.is_axisymmetric()) {
    std::ranges::set_difference(united(fields, &ExtensionField::inside), strained,
                                std::back_inserter(rigid));
  }
  for (const Elements* elements : {&strained, static_cast<const Elements*>(&rigid)}) {
    for (const base::ElementId e : *elements) {
      ElementTerms(set, loads, e, u).add(out, elements == &strained, filled);
    }
  }
}

} // namespace spricka::crack
