// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_intensity.hpp"

#include "crack/crack_face_term.hpp"
#include "crack/domain_integral.hpp"
#include "crack/finite_shift.hpp"
#include "crack/heat_term.hpp"
#include "crack/intensity_row_builder.hpp"
#include "crack/interaction_terms.hpp"
#include "crack/load_jumps.hpp"
#include "crack/opening.hpp"
#include "crack/tip_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spricka::crack {

namespace {

// The E' that K belongs to.
double used_modulus(const TipContext& set, model::CrackTipPlaneState request) {
  switch (request) {
  case model::CrackTipPlaneState::stress:
    return fe::effective_modulus(set.material, model::StressState::plane_stress);
  case model::CrackTipPlaneState::strain:
    return fe::effective_modulus(set.material, model::StressState::plane_strain);
  case model::CrackTipPlaneState::automatic:
    break;
  }
  return fe::effective_modulus(set.material, set.state());
}
// What makes K of it from K of the property's own E' (crack.13).
double restated(const TipContext& set, model::CrackTipPlaneState request) {
  return std::sqrt(used_modulus(set, request) / fe::effective_modulus(set.material, set.state()));
}

// All terms of G, K and T: each adds to the forces of the nodes it touches.
InteractionConfigurationalForces<2>
configurational_forces(const TipContext& set, const std::vector<VirtualExtensionField>& domains,
                       const base::Vector& u) {
  InteractionConfigurationalForces<2> forces(set.mesh.node_count());
  const TipAuxiliaryFields fields(set, domains);
  add_tip_element_terms(fields, u, forces);
  add_face_load_terms(fields, load_forces_on_faces(set.mesh, set.loads), u, forces);
  add_auxiliary_tractions(fields, u, forces);
  return forces;
}

// G of the finite shift instead of the analytic one, K to the same.
void take_shift(DomainIntensity& value, double G) {
  // G is quadratic in K (crack.9).
  const double scale = G > 0.0 && value.G > 0.0 ? std::sqrt(G / value.G) : 1.0;
  value.K1 *= scale;
  value.K2 *= scale;
  value.G = G;
}

// What the strain round the axis, u_x / x at the tip, adds to T (crack.41).
double stress_of_hoop(const TipContext& set, const base::Vector& u) {
  const double E = fe::effective_modulus(set.material, set.state());
  return set.is_axisymmetric() ? E * set.material.nu / set.tip.x.x() *
                                     u[2 * static_cast<Eigen::Index>(set.tip_node.index())]
                               : 0.0;
}

// What temperatures and forces between the crack faces add to the sums of one domain.
std::array<double, auxiliary_field_count<2>> added_terms(const TipContext& set,
                                                         const mesh::CrackFront& front,
                                                         const VirtualExtensionField& field,
                                                         const base::Vector& u) {
  std::array<double, auxiliary_field_count<2>> sum{};
  if (set.affine) {
    sum = nonlinear_temperature_term(set, front, field, u);
  }
  if (set.loads.crack_faces) {
    const std::array<double, 3> more = crack_face_term(set, field, *set.loads.crack_faces, u);
    for (std::size_t k = 0; k < more.size(); ++k) {
      sum[k] += more[k];
    }
  }
  return sum;
}

Eigen::Index freedoms(const mesh::CrackedMesh& cracked) {
  return static_cast<Eigen::Index>(cracked.mesh.node_count()) * cracked.mesh.dim;
}

} // namespace

StressIntensity tip_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                              const mesh::CrackFront& front,
                              const std::vector<VirtualExtensionField>& fields,
                              const FrontIntensityOptions& request, const base::Vector& u,
                              const FrontLoads& loads) {
  StressIntensity result;
  TipContext set = make_tip_context(model, cracked, front, fields, loads);
  set.affine = fit_affine_temperature(set, front, fields);
  result.E_effective = used_modulus(set, request.state);
  const double restate = restated(set, request.state);
  result.two_materials = std::ranges::any_of(
      fields, [&](const VirtualExtensionField& f) { return is_between_materials(set, f); });
  const InteractionConfigurationalForces<2> forces = configurational_forces(set, fields, u);
  // What stands beside the bracket of (crack.26).
  const double T_of_tip =
      stress_on_crack_faces_at_tip(set, front) - thermal_stress_at_tip(set, front) +
      (loads.crack_faces ? loads.crack_faces->at_tip : 0.0) + stress_of_hoop(set, u);
  double shifted = 0.0;
  double analytic = 0.0;
  double invalid_reason = 0.0; // what is rough in one domain is so for the displacements in all
  for (const VirtualExtensionField& field : fields) {
    invalid_reason = std::max(invalid_reason, set.halves * load_jump_G_uncertainty(set, field));
  }
  for (const VirtualExtensionField& field : fields) {
    std::array<double, auxiliary_field_count<2>> sum = forces.released_energies(field);
    const std::array<double, auxiliary_field_count<2>> more = added_terms(set, front, field, u);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] = set.intensity_conversion_factor(k) * (sum[k] + more[k]);
    }
    DomainIntensity value{.rings = field.rings,
                          .K1 = restate * sum[1],
                          .K2 = front.symmetric_half ? 0.0 : restate * sum[2],
                          .K3 = 0.0,
                          .G = sum[0],
                          .T = sum[force_auxiliary<2>] + T_of_tip};
    const bool jumps = set.affine && has_temperature_jump_in_element(set, field);
    if (request.shift && !jumps) {
      const double G =
          set.halves *
          (finite_shift_release_rate(set, field, *request.shift * front.size, u) + more[0]);
      shifted += G;
      analytic += value.G;
      take_shift(value, G);
    }
    const double known = (value.K1 * value.K1 + value.K2 * value.K2) / result.E_effective;
    if (jumps || invalid_reason > largest_relative_G_uncertainty * known) {
      value.G = std::numeric_limits<double>::quiet_NaN();
    }
    if (result.two_materials) {
      value.K1 = value.K2 = value.T = 0.0;
    }
    result.domains.push_back(value);
  }
  if (request.shift && analytic != 0.0) {
    result.shift_error = shifted / analytic - 1.0;
  }
  if (request.opening) {
    result.opening = tip_K_from_face_opening(set, cracked, front, u);
    if (result.opening) {
      std::ranges::for_each(*result.opening, [&](double& K) { K *= restate; });
    }
  }
  summarise_domain_intensities(set.material.E / (2.0 * (1.0 + set.material.nu)), 1, result);
  return result;
}

SparseLinearFunctionals tip_intensity_functionals(const model::Model& model,
                                                  const mesh::CrackedMesh& cracked,
                                                  const mesh::CrackFront& front,
                                                  const std::vector<VirtualExtensionField>& fields,
                                                  model::CrackTipPlaneState state) {
  const FrontLoads none;
  const TipContext set = make_tip_context(model, cracked, front, fields, none);
  if (is_between_materials(set, fields.front())) {
    return {freedoms(cracked), 2};
  }
  const TipAuxiliaryFields source(set, fields);
  return restated(set, state) *
         IntensityFunctionalBuilder<TipAuxiliaryFields>({source, front, {fields}})
             .displacement_functionals()
             .of_nodes;
}

std::vector<KFunctionalQuadraturePoint> K_functional_at_quadrature_points(
    const model::Model& model, const mesh::CrackedMesh& cracked, const mesh::CrackFront& front,
    const std::vector<VirtualExtensionField>& fields, model::CrackTipPlaneState state) {
  std::vector<KFunctionalQuadraturePoint> points;
  const FrontLoads none;
  if (fields.empty()) {
    return points;
  }
  const TipContext set = make_tip_context(model, cracked, front, fields, none);
  if (is_between_materials(set, fields.front())) {
    return points;
  }
  const double factor = restated(set, state) * set.intensity_conversion_factor(1);
  const TipAuxiliaryFields source(set, fields);
  const KFunctionalIntegrand<TipAuxiliaryFields> contractions(source, front, {fields});
  for (const base::ElementId e : contractions.contracted_elements()) {
    contractions.visit_contraction_points(
        e, contractions.front_motions_of_element(e), [&](const auto& at) {
          KFunctionalQuadraturePoint point{e, at.r, {Tensor<2>::Zero(), Tensor<2>::Zero()}, {}};
          for (Eigen::Index mode = 0; mode < at.tensors.hoop.size(); ++mode) {
            point.M[static_cast<std::size_t>(mode)] =
                factor * at.tensors.M.template middleRows<2>(2 * mode);
            point.hoop[static_cast<std::size_t>(mode)] = factor * at.tensors.hoop[mode];
          }
          points.push_back(point);
        });
  }
  return points;
}

base::Matrix face_force_tip_functionals(const model::Model& model, const mesh::CrackedMesh& cracked,
                                        const mesh::CrackFront& front,
                                        const std::vector<VirtualExtensionField>& fields,
                                        model::CrackTipPlaneState state,
                                        const std::vector<model::Face>& faces) {
  base::Matrix rows = base::Matrix::Zero(freedoms(cracked), 2);
  if (fields.empty()) {
    return rows;
  }
  const FrontLoads none;
  const TipContext set = make_tip_context(model, cracked, front, fields, none);
  // The mean over the domains, as K itself is.
  const double factor = restated(set, state) * set.intensity_conversion_factor(1) /
                        static_cast<double>(fields.size());
  for (const VirtualExtensionField& field : fields) {
    for (const auto& [node, weight] : crack_face_weights(set, field, faces)) {
      const auto at = 2 * static_cast<Eigen::Index>(node.index());
      rows.col(0).segment<2>(at) += factor * weight[0];
      rows.col(1).segment<2>(at) += factor * weight[1];
    }
  }
  if (front.symmetric_half) {
    rows.col(1).setZero();
  }
  return rows;
}

} // namespace spricka::crack
