// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/stress_intensity.hpp"

#include "fe/element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spricka::crack {

namespace {

// In the elements where q varies the auxiliary field behaves like r^-1/2 but is smooth; degree 9
// leaves 1e-7 of it.
constexpr int domain_degree = 9;

using Tensor = Eigen::Matrix2d;

/// Configurational nodal forces per unit thickness: of u with itself and with the two near-tip
/// fields.
struct NodalForces {
  std::map<base::NodeId, std::array<base::Vec2, 3>> at;
};

struct Setting {
  const model::Mesh& mesh;
  const model::Material& material;
  model::State state;
  TipFrame tip;
  const BodyForce& body_force;
};

// Bilinear energy-momentum: s(u) : grad v + s(v) : grad u - s(u) : eps(v) I, as a tensor that
// multiplies grad q (component k of q along e_k, derivative j): T_kj = s_ij v_i,k + ...
Tensor momentum(const Tensor& Hu, const Tensor& su, const Tensor& Hv, const Tensor& sv) {
  Tensor T = Hv.transpose() * su + Hu.transpose() * sv;
  T.diagonal().array() -= (su.cwiseProduct(Hv)).sum();
  return T;
}

template <shape::ElementShape S>
void add_element(const Setting& set, base::ElementId e, const base::Vector& u, NodalForces& out) {
  const fe::NodeVectors<S> X = fe::coordinates<S>(set.mesh, e);
  const fe::NodeVectors<S> U = fe::gather<S>(set.mesh, e, u);
  const fe::Elasticity<2> D = fe::elasticity<2>(set.material, set.state);
  const std::span<const base::NodeId> nodes = set.mesh.nodes_of(e);
  const auto stress = [&](const Tensor& H) -> Tensor {
    const fe::Strain<2> sigma = D * fe::strain<2>(H);
    return fe::stress_tensor<2>(sigma);
  };
  for (const auto& point : shape::quadrature<S>(domain_degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const double w = point.weight * at.det;
    const base::Vec2 x = X * S::N(point.r);
    const Tensor Hu = U * at.dNdx;
    const Tensor su = stress(Hu);
    base::Vec2 b = base::Vec2::Zero();
    base::Vec2 value = base::Vec2::Zero();
    if (set.body_force) {
      b = set.body_force(e, x);
      value = U * S::N(point.r);
    }
    std::array<Tensor, 3> T;
    T[0] = 0.5 * momentum(Hu, su, Hu, su);
    T[0].diagonal().array() += b.dot(value);
    for (int mode = 1; mode <= 2; ++mode) {
      const Tensor Hv = auxiliary_gradient(set.tip, x, mode, set.material, set.state);
      Tensor& M = T[static_cast<std::size_t>(mode)];
      M = momentum(Hu, su, Hv, stress(Hv));
      if (set.body_force) {
        M.diagonal().array() +=
            b.dot(auxiliary_displacement(set.tip, x, mode, set.material, set.state));
      }
    }
    for (int n = 0; n < S::nodes; ++n) {
      std::array<base::Vec2, 3>& P = out.at[nodes[static_cast<std::size_t>(n)]];
      for (std::size_t k = 0; k < 3; ++k) {
        P[k] += w * (T[k] * at.dNdx.row(n).transpose());
      }
    }
  }
}

// Work of the body force on the displacements U of an element at nodes X.
template <shape::PlaneShape S>
double body_work(const Setting& set, base::ElementId e, const fe::NodeVectors<S>& X,
                 const fe::NodeVectors<S>& U) {
  double work = 0.0;
  for (const auto& point : shape::quadrature<S>(domain_degree)) {
    const Eigen::Matrix<double, S::nodes, 1> N = S::N(point.r);
    const base::Vec2 x = X * N;
    const base::Vec2 value = U * N;
    work += point.weight * fe::jacobian<S>(X, point.r).det * set.body_force(e, x).dot(value);
  }
  return work;
}

// Potential energy of the elements of a field with all nodes moved by s q e1, displacements kept:
// strain energy less the work of body forces.
double shifted_energy(const Setting& set, const ExtensionField& field, double s,
                      const base::Vector& u) {
  std::map<base::NodeId, double> q(field.q.begin(), field.q.end());
  model::Property property;
  property.state = set.state;
  double energy = 0.0;
  fe::for_plane_blocks(set.mesh, field.elements,
                       [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                         const fe::Law law = fe::law_of(set.material, property, S::type);
                         for (const base::ElementId e : block) {
                           fe::NodeVectors<S> X = fe::coordinates<S>(set.mesh, e);
                           const std::span<const base::NodeId> nodes = set.mesh.nodes_of(e);
                           for (int n = 0; n < S::nodes; ++n) {
                             const auto moved = q.find(nodes[static_cast<std::size_t>(n)]);
                             if (moved != q.end()) {
                               X.col(n) += s * moved->second * set.tip.e1;
                             }
                           }
                           const fe::NodeVectors<S> U = fe::gather<S>(set.mesh, e, u);
                           energy += 0.5 * U.cwiseProduct(fe::element_force<S>(X, law, U)).sum();
                           energy -= set.body_force ? body_work<S>(set, e, X, U) : 0.0;
                         }
                       });
  return energy;
}

NodalForces configurational_forces(const Setting& set, const std::vector<ExtensionField>& fields,
                                   const base::Vector& u) {
  std::vector<base::ElementId> elements;
  for (const ExtensionField& f : fields) {
    elements.insert(elements.end(), f.elements.begin(), f.elements.end());
  }
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  // Elements of different domains must not mix: q is constant outside its own elements, and there
  // the sums of dN over an element vanish, so one vector per node serves all domains.
  NodalForces forces;
  for (const base::ElementId e : elements) {
    for (const base::NodeId n : set.mesh.nodes_of(e)) {
      forces.at.try_emplace(
          n, std::array<base::Vec2, 3>{base::Vec2::Zero(), base::Vec2::Zero(), base::Vec2::Zero()});
    }
  }
  fe::for_plane_blocks(set.mesh, elements,
                       [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                         for (const base::ElementId e : block) {
                           add_element<S>(set, e, u, forces);
                         }
                       });
  return forces;
}

TipFrame frame_of(const mesh::Tip& tip) {
  TipFrame frame;
  frame.x = tip.x.head<2>();
  frame.e1 = tip.direction.head<2>();
  frame.e2 = {-frame.e1.y(), frame.e1.x()};
  return frame;
}

double crack_modulus(const model::Material& material, model::State own, model::CrackState wish) {
  switch (wish) {
  case model::CrackState::stress:
    return fe::effective_modulus(material, model::State::plane_stress);
  case model::CrackState::strain:
    return fe::effective_modulus(material, model::State::plane_strain);
  case model::CrackState::automatic:
    break;
  }
  return fe::effective_modulus(material, own);
}

void summarise(StressIntensity& result) {
  double low = result.domains.front().K1;
  double high = low;
  const auto count = static_cast<double>(result.domains.size());
  for (const DomainValue& d : result.domains) {
    result.K1 += d.K1 / count;
    result.K2 += d.K2 / count;
    result.G += d.G / count;
    low = std::min(low, d.K1);
    high = std::max(high, d.K1);
  }
  const double K = std::hypot(result.K1, result.K2);
  result.spread = K > 0.0 ? (high - low) / K : 0.0;
  result.G_from_K = K * K / result.E_effective;
}

// s(u) : A + (H e1) . (s(v) grad q) with A = (H_v e1) (x) grad q - (e1 . grad q) H_v is e1 . T grad
// q of the interaction; D is symmetric, so s(u) : A = H_u : s(A).
template <shape::ElementShape S>
void add_element_rows(const Setting& set, base::ElementId e,
                      const std::map<base::NodeId, double>& q, double factor, base::Matrix& rows) {
  const fe::NodeVectors<S> X = fe::coordinates<S>(set.mesh, e);
  const fe::Elasticity<2> D = fe::elasticity<2>(set.material, set.state);
  const std::span<const base::NodeId> nodes = set.mesh.nodes_of(e);
  Eigen::Matrix<double, S::nodes, 1> moved = Eigen::Matrix<double, S::nodes, 1>::Zero();
  for (int n = 0; n < S::nodes; ++n) {
    const auto at = q.find(nodes[static_cast<std::size_t>(n)]);
    moved[n] = at == q.end() ? 0.0 : at->second;
  }
  const auto stress = [&](const Tensor& H) -> Tensor {
    const fe::Strain<2> sigma = D * fe::strain<2>(H);
    return fe::stress_tensor<2>(sigma);
  };
  for (const auto& point : shape::quadrature<S>(domain_degree)) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
    const double w = factor * point.weight * at.det;
    const base::Vec2 x = X * S::N(point.r);
    const base::Vec2 grad = at.dNdx.transpose() * moved;
    for (int mode = 1; mode <= 2; ++mode) {
      const Tensor Hv = auxiliary_gradient(set.tip, x, mode, set.material, set.state);
      const Tensor A = Hv * set.tip.e1 * grad.transpose() - set.tip.e1.dot(grad) * Hv;
      const Tensor M = stress(A) + stress(Hv) * grad * set.tip.e1.transpose();
      for (int n = 0; n < S::nodes; ++n) {
        const auto freedom =
            2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index());
        rows.col(mode - 1).segment<2>(freedom) += w * (M * at.dNdx.row(n).transpose());
      }
    }
  }
}

} // namespace

base::Matrix intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                            model::CrackState state) {
  base::Matrix rows = base::Matrix::Zero(
      static_cast<Eigen::Index>(cracked.mesh.node_count()) * cracked.mesh.dim, 2);
  if (fields.empty()) {
    return rows;
  }
  const base::ElementId near = fields.front().elements.front();
  const model::Property& property = model.property_of(cracked.mesh, near);
  const model::Material& material = model.material_of(cracked.mesh, near);
  const Setting set{cracked.mesh, material, property.state, frame_of(tip), {}};
  const double E_own = fe::effective_modulus(material, property.state);
  const double restate = std::sqrt(crack_modulus(material, property.state, state) / E_own);
  const double halves = tip.symmetric_half ? 2.0 : 1.0;
  const double factor = 0.5 * E_own * restate * halves / static_cast<double>(fields.size());
  for (const ExtensionField& field : fields) {
    const std::map<base::NodeId, double> q(field.q.begin(), field.q.end());
    fe::for_plane_blocks(cracked.mesh, field.elements,
                         [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                           for (const base::ElementId e : block) {
                             add_element_rows<S>(set, e, q, factor, rows);
                           }
                         });
  }
  if (tip.symmetric_half) {
    rows.col(1).setZero();
  }
  return rows;
}

base::Matrix lip_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                                model::CrackState state, const std::vector<model::Face>& faces) {
  base::Matrix rows = base::Matrix::Zero(
      static_cast<Eigen::Index>(cracked.mesh.node_count()) * cracked.mesh.dim, 2);
  if (fields.empty()) {
    return rows;
  }
  const base::ElementId near = fields.front().elements.front();
  const model::Property& property = model.property_of(cracked.mesh, near);
  const model::Material& material = model.material_of(cracked.mesh, near);
  const double E_own = fe::effective_modulus(material, property.state);
  const double restate = std::sqrt(crack_modulus(material, property.state, state) / E_own);
  const double halves = tip.symmetric_half ? 2.0 : 1.0;
  const double factor = 0.5 * E_own * restate * halves / static_cast<double>(fields.size());
  const TipPlace place{frame_of(tip), tip.node, material, property.state, property.thickness};
  for (const ExtensionField& field : fields) {
    for (const auto& [node, weight] : lip_weights(cracked.mesh, place, field, faces)) {
      const auto at = 2 * static_cast<Eigen::Index>(node.index());
      rows.col(0).segment<2>(at) += factor * weight[0];
      rows.col(1).segment<2>(at) += factor * weight[1];
    }
  }
  if (tip.symmetric_half) {
    rows.col(1).setZero();
  }
  return rows;
}

StressIntensity stress_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                                 const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                                 const VceRequest& request, const base::Vector& u,
                                 const BodyForce& body_force) {
  StressIntensity result;
  if (fields.empty()) {
    return result;
  }
  const base::ElementId near = fields.front().elements.front();
  const model::Property& property = model.property_of(cracked.mesh, near);
  const model::Material& material = model.material_of(cracked.mesh, near);
  const Setting set{cracked.mesh, material, property.state, frame_of(tip), body_force};
  const double E_own = fe::effective_modulus(material, property.state);
  result.E_effective = crack_modulus(material, property.state, request.state);
  const double restate = std::sqrt(result.E_effective / E_own);
  const double halves = tip.symmetric_half ? 2.0 : 1.0;

  const NodalForces forces = configurational_forces(set, fields, u);
  double shifted = 0.0;
  double analytic = 0.0;
  for (const ExtensionField& field : fields) {
    std::array<double, 3> sum{};
    for (const auto& [node, q] : field.q) {
      const auto P = forces.at.find(node);
      if (P != forces.at.end()) {
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] += halves * q * set.tip.e1.dot(P->second[k]);
        }
      }
    }
    double of_lips = 0.0; // of G
    if (request.lips != nullptr) {
      const std::array<double, 3> more =
          lip_term(cracked.mesh, {set.tip, tip.node, material, property.state, property.thickness},
                   field, *request.lips, u);
      for (std::size_t k = 0; k < more.size(); ++k) {
        sum[k] += halves * more[k];
      }
      of_lips = halves * more[0];
    }
    DomainValue value{field.rings, 0.5 * E_own * sum[1], 0.5 * E_own * sum[2], sum[0]};
    if (tip.symmetric_half) {
      value.K2 = 0.0;
    }
    if (request.shift) {
      const double s = *request.shift * tip.size;
      const double G =
          halves * (shifted_energy(set, field, 0.0, u) - shifted_energy(set, field, s, u)) / s +
          of_lips;
      shifted += G;
      analytic += value.G;
      const double scale = G > 0.0 && value.G > 0.0 ? std::sqrt(G / value.G) : 1.0;
      value = {field.rings, scale * value.K1, scale * value.K2, G};
    }
    value.K1 *= restate;
    value.K2 *= restate;
    result.domains.push_back(value);
  }
  if (request.shift && analytic != 0.0) {
    result.shift_error = shifted / analytic - 1.0;
  }
  summarise(result);
  return result;
}

} // namespace spricka::crack
