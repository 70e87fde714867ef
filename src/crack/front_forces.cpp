// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_forces.hpp"

#include "crack/element_forces.hpp"
#include "crack/front_heat.hpp"
#include "fe/heat.hpp"
#include "fe/thermal_kernel.hpp"

#include <algorithm>
#include <optional>

namespace spricka::crack {

using base::Vec3;

namespace {

/// The temperature of an element of the domains.
class SolidHeat {
public:
  /// `linear`: the temperature, if it is linear in all elements.
  SolidHeat(const FrontContext& set, const FrontLoads& loads,
            const std::optional<LinearTemperature>& linear, base::ElementId e)
      : loads_(loads), linear_(linear), e_(e) {
    if (loads.temperature.size() > 0) {
      const auto& element = shape::reference_element<3>(set.mesh.type[e.index()]);
      X_ = fe::element_coordinates(element, set.mesh, e);
      T_ = fe::gather_corner_temperatures(element, set.mesh, e, loads.temperature);
      beta_ = fe::thermal_modulus(fe::constitutive_law(set.model, set.mesh, e));
      if (!linear) {
        known_ = known_inside();
        functions_.emplace(element, X_);
      }
    }
  }

  // A linear temperature is that in all elements (fe.40); another one that does not jump in the
  // element is the field itself, which is steadier across its sides than what elements take
  // (crack.21, crack.22).
  void heat(const fe::Jacobian<fe::AnyElement<3>>& at, const shape::Point<3>& r, const Vec3& x,
            ThermoelasticState<3>& here) const {
    if (beta_ == 0.0) {
      return;
    }
    if (linear_) {
      here.beta_T = beta_ * (*linear_)(x);
      here.beta_grad_T = beta_ * linear_->slope;
      return;
    }
    if (!known_) {
      here.beta_T = beta_ * T_.dot(functions_->at(r));
      here.beta_grad_T = beta_ * (functions_->gradients(at.J, r).transpose() * T_);
      return;
    }
    constexpr double part = 1e-5; // of the element, for central differences
    const double h = part * (X_.rowwise().maxCoeff() - X_.rowwise().minCoeff()).maxCoeff();
    Vec3 slope;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vec3 step = h * Vec3::Unit(i);
      slope[i] = (temperature(x + step) - temperature(x - step)) / (2.0 * h);
    }
    here.beta_T = beta_ * temperature(x);
    here.beta_grad_T = beta_ * slope;
  }

  static void cool(ThermoelasticState<3>& here, double beta_T) {
    here.sigma.diagonal().array() -= beta_T;
  }
  // Auxiliary fields meet the solution as it is, and no free expansion carries nodes.
  static const ThermoelasticState<3>& met(const ThermoelasticState<3>& own, const Vec3& /*x*/) {
    return own;
  }
  static bool is_carried() { return false; }
  static Tensor<3> expansion_gradient(const Vec3& /*x*/) { return Tensor<3>::Zero(); }

private:
  [[nodiscard]] double temperature(const Vec3& x) const {
    double T = 0.0;
    for (const fe::ScaledTemperature& acting : loads_.heat) {
      T += acting.factor * acting.heat->field(e_, x);
    }
    return T;
  }
  // Whether a field acts that varies in the element, and none that jumps.
  [[nodiscard]] bool known_inside() const {
    const auto varies = [&](const fe::ScaledTemperature& acting) {
      return acting.heat->field.may_vary_inside(e_);
    };
    const auto jumps = [&](const fe::ScaledTemperature& acting) {
      return varies(acting) && !acting.heat->is_known_inside(e_);
    };
    return std::ranges::any_of(loads_.heat, varies) && std::ranges::none_of(loads_.heat, jumps);
  }

  const FrontLoads& loads_;
  const std::optional<LinearTemperature>& linear_;
  base::ElementId e_;
  fe::AnyNodeVectors<3> X_;
  /// Where a temperature acts that is not linear.
  std::optional<fe::TemperatureFunctions<3>> functions_;
  fe::CornerValues<3> T_;
  bool known_ = false; ///< the temperature, by its field
  double beta_ = 0.0;
};

} // namespace

void add_front_element_terms(const FrontAuxiliaryFields& fields, const FrontLoads& loads,
                             const base::Vector& u, InteractionConfigurationalForces<3>& out) {
  const FrontContext& set = fields.context();
  const std::vector<BodyForceField> body =
      body_force_fields(set.model, set.mesh, loads, LoadScaleScope::near_front);
  const std::optional<LinearTemperature> linear =
      exact_linear_temperature(set.mesh, fields.strained_elements(), loads.temperature);
  for (const base::ElementId e : fields.strained_elements()) {
    const SolidHeat heat(set, loads, linear, e);
    ElementConfigurationalForces<FrontAuxiliaryFields, SolidHeat>(fields, heat, body, e, u)
        .add_element_terms(true, out);
  }
}

} // namespace spricka::crack
