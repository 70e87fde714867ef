// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/front_forces.hpp"

#include "crack/space/auxiliary_table.hpp"
#include "crack/space/front_heat.hpp"
#include "fe/heat.hpp"
#include "fe/load_rule.hpp"
#include "fe/thermal_kernel.hpp"

#include <algorithm>
#include <optional>

namespace spricka::crack {

using base::Vec3;

FrontConfigurationalForces::OfNode& FrontConfigurationalForces::operator[](base::NodeId n) {
  std::int32_t& slot = slot_[n.index()];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(at_.size());
    at_.emplace_back().fill(Vec3::Zero());
  }
  return at_[static_cast<std::size_t>(slot)];
}

std::array<double, front_auxiliary_field_count>
FrontConfigurationalForces::released_energies(const ExtensionField& field) const {
  std::array<double, front_auxiliary_field_count> sum{};
  for (const NodeMotion& moved : field.motion) {
    const std::int32_t slot = slot_[moved.node.index()];
    if (slot >= 0) { // nodes that no term has touched release nothing
      for (std::size_t k = 0; k < front_auxiliary_field_count; ++k) {
        sum[k] += moved.q * moved.along.dot(at_[static_cast<std::size_t>(slot)][k]);
      }
    }
  }
  return sum;
}

namespace {

/// A force per volume of the deck near the front.
struct FrontBodyLoad {
  const ActingLoad* acting = nullptr;
  fe::FieldScale scale;
};

std::vector<FrontBodyLoad> body_loads(const model::Mesh& mesh, const TipLoads& loads) {
  std::vector<FrontBodyLoad> result;
  for (const ActingLoad& acting : loads.loads) {
    if (!acting.elements.empty() && acting.load->type != model::LoadType::temperature) {
      result.push_back({&acting, fe::load_scale(mesh, *acting.load, acting.elements)});
    }
  }
  return result;
}

/// What the kernels of all elements read.
struct FrontElements {
  const FrontSetting& set;
  const AuxiliaryFieldTable& auxiliary_table;
  const std::vector<FrontBodyLoad>& body;
  const TipLoads& loads;
  std::optional<LinearTemperature> linear; ///< the temperature, if it is that in all of them
  const base::Vector& u;
  const FrontTermSwitches& terms;
};

class FrontElement {
public:
  FrontElement(const FrontElements& all, base::ElementId e)
      : all_(all), set_(all.set), e_(e),
        element_(shape::reference_element<3>(set_.mesh.type[e.index()])),
        X_(fe::coordinates(element_, set_.mesh, e)), U_(fe::gather(element_, set_.mesh, e, all.u)) {
    if (all.loads.temperature.size() > 0) {
      T_ = fe::corner_temperature(element_, set_.mesh, e, all.loads.temperature);
      beta_ = fe::thermal_modulus(fe::constitutive_law(set_.model, set_.mesh, e));
      if (!all.linear) {
        known_ = known_inside();
        heat_.emplace(element_, X_);
      }
    }
  }

  void add(FrontConfigurationalForces& out) const {
    OfNodes P;
    const auto nodes = static_cast<std::size_t>(element_.nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
      P[n].fill(Vec3::Zero());
    }
    std::size_t number = 0;
    for (const auto& point : all_.auxiliary_table.quadrature_rule(element_, e_)) {
      add_point(point, number++, P);
    }
    add_body_loads(P);
    for (std::size_t n = 0; n < nodes; ++n) {
      FrontConfigurationalForces::OfNode& sum = out[set_.mesh.element_nodes(e_)[n]];
      for (std::size_t k = 0; k < front_auxiliary_field_count; ++k) {
        sum[k] += P[n][k];
      }
    }
  }

private:
  /// Of the first nodes, as many as the element has.
  using OfNodes = std::array<FrontConfigurationalForces::OfNode, shape::most_nodes<3>>;

  void add_point(const shape::QuadraturePoint<3>& point, std::size_t number, OfNodes& P) const {
    const fe::Jacobian<fe::AnyElement<3>> at = fe::jacobian(element_, X_, point.r);
    const fe::AnyElement<3>::Values N = element_.N(point.r);
    const double weight = point.weight * at.det;
    const Vec3 x = X_ * N;
    const Tensor<3> H = U_.lazyProduct(at.dNdx);
    const Tensor<3> cold = isotropic_stress(set_.body, H);
    const Warmth heat = warmth(at.J, point.r, x);
    for (std::size_t k = 0; k < front_auxiliary_field_count; ++k) {
      Tensor<3> sigma = cold;
      sigma.diagonal().array() -= heat.beta_T;
      Tensor<3> T;
      Vec3 c = Vec3::Zero(); // what N_n itself is multiplied with
      if (k == 0) {
        T = energy_momentum<3>({H, sigma}, heat.beta_T * H.trace());
        c = H.trace() * heat.beta_grad_T;
      } else {
        const FrontAuxiliaryField w = all_.auxiliary_table.at(e_, number, k);
        T = energy_momentum<3>({H, sigma}, {w.H, w.sigma});
        c = w.H.trace() * heat.beta_grad_T;
        if (all_.terms.divergence) {
          c += H.transpose() * w.divergence;
        }
      }
      for (int n = 0; n < element_.nodes; ++n) {
        P[static_cast<std::size_t>(n)][k] += weight * (T * at.dNdx.row(n).transpose() + N[n] * c);
      }
    }
  }

  struct Warmth {
    double beta_T = 0.0;
    Vec3 beta_grad_T = Vec3::Zero();
  };

  // A linear temperature is that in all elements (fe.40); another one that does not jump in the
  // element is the field itself, which is steadier across its sides than what elements take
  // (crack.21, crack.22). J of the map at r.
  [[nodiscard]] Warmth warmth(const Tensor<3>& J, const shape::Point<3>& r, const Vec3& x) const {
    if (beta_ == 0.0) {
      return {};
    }
    if (all_.linear) {
      return {beta_ * (*all_.linear)(x), beta_ * all_.linear->slope};
    }
    if (!known_) {
      return {beta_ * T_.dot(heat_->at(r)), beta_ * (heat_->gradients(J, r).transpose() * T_)};
    }
    constexpr double part = 1e-5; // of the element, for central differences
    const double h = part * (X_.rowwise().maxCoeff() - X_.rowwise().minCoeff()).maxCoeff();
    Vec3 slope;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vec3 step = h * Vec3::Unit(i);
      slope[i] = (temperature(x + step) - temperature(x - step)) / (2.0 * h);
    }
    return {beta_ * temperature(x), beta_ * slope};
  }
  [[nodiscard]] double temperature(const Vec3& x) const {
    double T = 0.0;
    for (const fe::ScaledTemperature& acting : all_.loads.heat) {
      T += acting.factor * acting.heat->field(e_, x);
    }
    return T;
  }
  // Whether a field acts that varies in the element, and none that jumps.
  [[nodiscard]] bool known_inside() const {
    const auto varies = [&](const fe::ScaledTemperature& acting) {
      return acting.heat->field.varies(e_);
    };
    const auto jumps = [&](const fe::ScaledTemperature& acting) {
      return varies(acting) && !acting.heat->is_known_inside(e_);
    };
    return std::ranges::any_of(all_.loads.heat, varies) &&
           std::ranges::none_of(all_.loads.heat, jumps);
  }

  // - q b . u,k (crack.19) and the same of the auxiliary fields, at points of the load's own.
  void add_body_loads(OfNodes& P) const {
    for (const FrontBodyLoad& load : all_.body) {
      const ActingLoad& acting = *load.acting;
      if (!std::ranges::binary_search(acting.elements, e_)) {
        continue;
      }
      const auto rule = fe::body_load_rule<3>(element_, X_, *acting.load, load.scale);
      for (const auto& point : rule.points) {
        const fe::Jacobian<fe::AnyElement<3>> at = fe::jacobian(element_, X_, point.r);
        const fe::AnyElement<3>::Values N = element_.N(point.r);
        const Vec3 x = X_ * N;
        const Vec3 b = acting.factor * point.weight * at.det * fe::load_value(*acting.load, x);
        const TurningAxes axes(set_.axes.locate_point(x));
        for (std::size_t k = 0; k < front_auxiliary_field_count; ++k) {
          const Tensor<3> H = k == 0 ? Tensor<3>(U_.lazyProduct(at.dNdx))
                                     : front_auxiliary_field(k, axes, set_.body).H;
          const Vec3 c = H.transpose() * b;
          for (int n = 0; n < element_.nodes; ++n) {
            P[static_cast<std::size_t>(n)][k] -= N[n] * c;
          }
        }
      }
    }
  }

  const FrontElements& all_;
  const FrontSetting& set_;
  base::ElementId e_;
  const fe::AnyElement<3>& element_;
  fe::AnyNodeVectors<3> X_;
  fe::AnyNodeVectors<3> U_;
  std::optional<fe::TemperatureFunctions<3>> heat_; ///< where a temperature acts that is not linear
  fe::CornerValues<3> T_;
  bool known_ = false; ///< the temperature, by its field
  double beta_ = 0.0;
};

} // namespace

void add_element_forces(const FrontSetting& set, const FrontExtensions& fields,
                        const TipLoads& loads, const base::Vector& u,
                        FrontConfigurationalForces& out, const FrontTermSwitches& terms) {
  const std::vector<FrontBodyLoad> body = body_loads(set.mesh, loads);
  const std::vector<base::ElementId> elements = fields.elements();
  const std::shared_ptr<const AuxiliaryFieldTable> auxiliary_table =
      cached_auxiliary_table(set, fields);
  const FrontElements all{set,
                          *auxiliary_table,
                          body,
                          loads,
                          exact_linear_temperature(set.mesh, elements, loads.temperature),
                          u,
                          terms};
  for (const base::ElementId e : elements) {
    FrontElement(all, e).add(out);
  }
}

} // namespace spricka::crack
