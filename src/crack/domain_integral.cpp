// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/domain_integral.hpp"

#include "crack/element_forces.hpp"
#include "fe/thermal_kernel.hpp"

namespace spricka::crack {

namespace {

/// The temperature of an element of a section. Where a part of it expands the element freely
/// (fe::FreeExpansion) the nodes' displacement less that of the expansion at the nodes strains it;
/// both ways of writing the energy leave out the same that does not depend on u.
class SectionHeat {
public:
  SectionHeat(const TipContext& set, base::ElementId e)
      : set_(set), element_(plane_reference_element(set.mesh, e)),
        X_(fe::element_coordinates(element_, set.mesh, e)),
        law_(fe::constitutive_law(set.model, set.mesh, e)),
        T_(fe::CornerValues<2>::Zero(element_.corners)) {
    if (set.loads.temperature.size() > 0) {
      T_ = fe::gather_corner_temperatures(element_, set.mesh, e, set.loads.temperature);
    }
    if ((T_.array() != 0.0).any() &&
        fe::FreeExpansion::must_remove_beforehand(element_, X_, law_)) {
      free_ = fe::FreeExpansion(element_, X_, law_, T_);
      carried_ = true;
    }
  }

  void heat(const fe::Jacobian<PlaneElement>& at, const shape::Point<2>& r, const base::Vec2& x,
            ThermoelasticState<2>& here) const {
    if (!set_.loads.has_element_loads()) {
      return;
    }
    const double beta = fe::thermal_modulus(law_);
    if (carried_) {
      const Tensor<2> expansion = free_.gradient(x);
      here.beta_T = beta * free_.temperature(x);
      here.beta_grad_T = beta * free_.temperature_gradient();
      here.heated_dilatation = 2.0 * expansion(0, 0); // alpha T as the state has it, twice
      here.strained -= free_.at_nodes(X_).lazyProduct(at.dNdx);
      here.H = here.strained + expansion;
      return;
    }
    const base::Vec2 slope = element_.linear_element().dN(r).transpose() * T_; // by r
    here.beta_T = beta * T_.dot(element_.linear_element().N(r));
    here.beta_grad_T = beta * at.J.transpose().inverse() * slope;
  }

  // (crack.21).
  void cool(ThermoelasticState<2>& here, double beta_T) const {
    here.sigma.diagonal().array() -= beta_T;
    here.sigma_hoop -= set_.is_axisymmetric() ? beta_T : 0.0;
  }

  // The auxiliary fields of K and T meet the same displacements under the affine temperature alone;
  // what differs from it is nonlinear_temperature_term's (crack.34).
  [[nodiscard]] ThermoelasticState<2> met(const ThermoelasticState<2>& own,
                                          const base::Vec2& x) const {
    ThermoelasticState<2> here = own;
    if (set_.affine && set_.loads.has_element_loads()) {
      const double beta = fe::thermal_modulus(law_);
      cool(here, beta * (*set_.affine)(set_.tip, x) - own.beta_T);
      here.beta_grad_T = beta * set_.affine->slope;
    }
    return here;
  }

  [[nodiscard]] bool is_carried() const { return carried_; }
  [[nodiscard]] Tensor<2> expansion_gradient(const base::Vec2& x) const {
    return free_.gradient(x);
  }

private:
  const TipContext& set_;
  const PlaneElement& element_;
  PlaneVectors X_;
  fe::ConstitutiveLaw law_;
  fe::CornerValues<2> T_;
  bool carried_ = false; ///< the nodes, through the free expansion
  fe::FreeExpansion free_;
};

} // namespace

// One vector per node serves all domains (crack.5): outside its own elements the q of a domain is
// constant, and there the gradients of the shape functions of an element sum to zero.
void add_tip_element_terms(const TipAuxiliaryFields& fields, const base::Vector& u,
                           InteractionConfigurationalForces<2>& out) {
  const TipContext& set = fields.context();
  const std::vector<BodyForceField> body =
      body_force_fields(set.model, set.mesh, set.loads, LoadScaleScope::whole_set);
  const auto add = [&](base::ElementId e, bool strained) {
    const SectionHeat heat(set, e);
    ElementConfigurationalForces<TipAuxiliaryFields, SectionHeat>(fields, heat, body, e, u)
        .add_element_terms(strained, out);
  };
  for (const base::ElementId e : fields.strained_elements()) {
    add(e, true);
  }
  // About an axis also elements that q moves as one come to other radii.
  if (set.loads.has_element_loads() || set.is_axisymmetric()) {
    for (const base::ElementId e : fields.rigid_elements()) {
      add(e, false);
    }
  }
}

} // namespace spricka::crack
