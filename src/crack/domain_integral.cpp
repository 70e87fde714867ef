// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/domain_integral.hpp"

#include "crack/load_fields.hpp"
#include "fe/thermal_kernel.hpp"

#include <algorithm>
#include <array>

namespace spricka::crack {

namespace {

/// The solution at a point of an element.
struct Here {
  Tensor<2> nodal;                  ///< gradient of the nodes' displacement
  Tensor<2> H;                      ///< of the displacement: what expands freely is in
  Tensor<2> sigma;                  ///< stress, thermal part in
  Tensor<2> strained;               ///< gradient that has this stress, where some expands freely
  double beta_T = 0.0;              ///< stress that the temperature takes out
  base::Vec2 beta_grad_T{0.0, 0.0}; ///< and its gradient
  double free_strain = 0.0;         ///< alpha T as the state has it
};

/// One element. Where a part of its temperature expands it freely (fe::FreeExpansion) the nodes'
/// displacement less that of the expansion at the nodes strains it; both ways of writing the energy
/// leave out the same that does not depend on u.
template <shape::ElementShape S> class ElementTerms {
public:
  ElementTerms(const TipSetting& set, const std::vector<BodyField>& fields, base::ElementId e,
               const base::Vector& u)
      : set_(set), fields_(fields), e_(e), X_(fe::coordinates<S>(set.mesh, e)),
        U_(fe::gather<S>(set.mesh, e, u)), D_(set.elasticity(e)),
        law_(fe::law_of(set.model, set.mesh, e)),
        T_(set.loads.temperature.size() > 0
               ? fe::corner_temperature<S>(set.mesh, e, set.loads.temperature)
               : fe::CornerValues<S>(fe::CornerValues<S>::Zero())) {
    if constexpr (fe::plane_quadratic<S>) {
      if ((T_.array() != 0.0).any() && fe::FreeExpansion<S>::wanted(X_, law_)) {
        free_ = fe::FreeExpansion<S>(X_, law_, T_);
        carried_ = true;
      }
    }
  }

  void add(NodalForces& out, bool strained, bool filled) const {
    Forces force;
    for (std::size_t n = 0; n < S::nodes; ++n) {
      force[n] = &out[set_.mesh.nodes_of(e_)[n]];
    }
    for (const auto& point : shape::quadrature<S>(domain_degree)) {
      const fe::Jacobian<S> at = fe::jacobian<S>(X_, point.r);
      const Eigen::Matrix<double, S::nodes, 1> N = S::N(point.r);
      const double w = point.weight * at.det;
      const base::Vec2 x = X_ * N;
      const Polar place = polar(set_.tip, x);
      const Here own = solution(at, point.r, x, filled);
      // Partners of K and T meet the affine temperature alone; what differs from it is heat_term's
      // (crack.34).
      const Here met = filled && set_.affine ? under_affine(own, x) : own;
      for (std::size_t k = 0; k < partners; ++k) {
        const Here& here = k == 0 ? own : met;
        const Tensor<2> Hv = k == 0 ? here.nodal : partner_gradient(set_, place, k);
        Tensor<2> T = Tensor<2>::Zero();
        if (strained) {
          T = k == 0 ? own_momentum(here)
                     : energy_momentum<2>({here.H, here.sigma}, {Hv, stress_of<2>(D_, Hv)});
        }
        // What the temperature's gradient does on the volume change of u (crack.22) or of v
        // (crack.23).
        base::Vec2 c = base::Vec2::Zero();
        if (filled) {
          const double work = k == 0 && carried_ ? 2.0 * here.free_strain : Hv.trace();
          c = work * here.beta_grad_T;
        }
        for (int n = 0; n < S::nodes; ++n) {
          auto P = (*force[static_cast<std::size_t>(n)])[k].template head<2>();
          const base::Vec2 gradient = at.dNdx.row(n);
          P += w * (T * gradient + N[n] * c);
          if (k == 0 && carried_) { // nodes carried through the free expansion
            P += w * (free_.gradient(X_.col(n)).transpose() * (own.sigma * gradient));
          }
        }
      }
    }
    if (filled) {
      add_body_forces(force);
    }
  }

private:
  using Forces = std::array<std::array<base::Vec3, partners>*, S::nodes>;

  // At points of their own: they may bend and jump where the fields do not.
  void add_body_forces(const Forces& force) const {
    for_body_forces<S>(
        fields_, e_, X_, [&](const shape::Point<2>& r, double weight, const base::Vec2& b) {
          const fe::Jacobian<S> at = fe::jacobian<S>(X_, r);
          const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
          const Polar place = polar(set_.tip, X_ * N);
          for (std::size_t k = 0; k < partners; ++k) {
            const Tensor<2> Hv =
                k == 0 ? Tensor<2>(U_ * at.dNdx) : partner_gradient(set_, place, k);
            // - q b . u,k (crack.19), or with v in the place of u (crack.23).
            const base::Vec2 c = weight * at.det * (Hv.transpose() * b);
            for (int n = 0; n < S::nodes; ++n) {
              (*force[static_cast<std::size_t>(n)])[k].template head<2>() -= N[n] * c;
            }
          }
        });
  }

  [[nodiscard]] Here solution(const fe::Jacobian<S>& at, const shape::Point<2>& r,
                              const base::Vec2& x, bool filled) const {
    Here here;
    here.nodal = here.H = here.strained = U_ * at.dNdx;
    if (filled) {
      heat(at, r, x, here);
    }
    // (crack.21).
    here.sigma = stress_of<2>(D_, here.H);
    here.sigma.diagonal().array() -= here.beta_T;
    return here;
  }

  // What the partners of K and T meet: the same displacements under the affine temperature.
  [[nodiscard]] Here under_affine(const Here& own, const base::Vec2& x) const {
    Here here = own;
    const double beta = fe::heat_modulus(law_);
    here.sigma.diagonal().array() += own.beta_T - beta * (*set_.affine)(set_.tip, x);
    here.beta_grad_T = beta * set_.affine->slope;
    return here;
  }

  void heat(const fe::Jacobian<S>& at, const shape::Point<2>& r, const base::Vec2& x,
            Here& here) const {
    const double beta = fe::heat_modulus(law_);
    if (carried_) {
      const Tensor<2> expansion = free_.gradient(x);
      here.beta_T = beta * free_.temperature(x);
      here.beta_grad_T = beta * free_.slope();
      here.free_strain = expansion(0, 0);
      here.strained -= free_.at_nodes(X_) * at.dNdx;
      here.H = here.strained + expansion;
      return;
    }
    using Linear = fe::Linear<S>;
    here.beta_T = beta * T_.dot(Linear::N(r));
    here.beta_grad_T = beta * at.J.transpose().inverse() * Linear::dN(r).transpose() * T_;
  }

  // Of u with itself, halved: W is half of (sigma - beta T) : eps.
  [[nodiscard]] Tensor<2> own_momentum(const Here& u) const {
    const Tensor<2>& H = carried_ ? u.strained : u.H;
    const double thermal = carried_ ? 2.0 * u.free_strain : H.trace();
    return energy_momentum<2>({H, u.sigma}, u.beta_T * thermal);
  }

  const TipSetting& set_;
  const std::vector<BodyField>& fields_;
  base::ElementId e_;
  fe::NodeVectors<S> X_;
  fe::NodeVectors<S> U_;
  fe::Elasticity<2> D_;
  fe::Law law_;
  fe::CornerValues<S> T_;
  bool carried_ = false; ///< the nodes, through the free expansion
  fe::FreeExpansion<S> free_;
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
                      const base::Vector& u, NodalForces& out) {
  const bool filled = set.loads.fill_elements();
  const std::vector<BodyField> loads = body_fields(set);
  const Elements strained = united(fields, &ExtensionField::elements);
  Elements rigid;
  if (filled) {
    std::ranges::set_difference(united(fields, &ExtensionField::inside), strained,
                                std::back_inserter(rigid));
  }
  for (const Elements* elements : {&strained, static_cast<const Elements*>(&rigid)}) {
    fe::for_plane_blocks(
        set.mesh, *elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
          for (const base::ElementId e : block) {
            ElementTerms<S>(set, loads, e, u).add(out, elements == &strained, filled);
          }
        });
  }
}

} // namespace spricka::crack
