// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/stress_intensity.hpp"

#include "crack/auxiliary_field.hpp"
#include "crack/auxiliary_pressure.hpp"
#include "crack/contraction.hpp"
#include "crack/domain_integral.hpp"
#include "crack/face_term.hpp"
#include "crack/finite_shift.hpp"
#include "crack/heat_term.hpp"
#include "crack/load_jumps.hpp"
#include "crack/opening.hpp"
#include "crack/thermal_term.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spricka::crack {

namespace {

double crack_modulus(const model::ElasticMaterial& material, model::StressState own,
                     model::TipConstraint request) {
  switch (request) {
  case model::TipConstraint::stress:
    return fe::effective_modulus(material, model::StressState::plane_stress);
  case model::TipConstraint::strain:
    return fe::effective_modulus(material, model::StressState::plane_strain);
  case model::TipConstraint::automatic:
    break;
  }
  return fe::effective_modulus(material, own);
}

/// Factors that turn sums over nodes into G, K and T.
struct IntensityConversion {
  double E_own = 0.0;  ///< E' of the property
  double E_used = 0.0; ///< E' that K belongs to
  double halves = 1.0; ///< 2: one half of the body is in the model

  // By (crack.13); K by (crack.11) and (crack.12); T by (crack.26).
  [[nodiscard]] double restate() const { return std::sqrt(E_used / E_own); }
  [[nodiscard]] double K() const { return 0.5 * E_own * halves * restate(); }
  [[nodiscard]] double T() const { return E_own * halves; }
};

IntensityConversion factors_of(const TipSetting& set, const mesh::CrackFront& front,
                               model::TipConstraint request) {
  IntensityConversion f;
  f.E_own = fe::effective_modulus(set.material, set.state());
  f.E_used = crack_modulus(set.material, set.state(), request);
  f.halves = front.symmetric_half ? 2.0 : 1.0;
  return f;
}

void summarise(StressIntensity& result) {
  double low = result.domains.front().K1;
  double high = low;
  const auto count = static_cast<double>(result.domains.size());
  double with_G = 0.0;
  for (const DomainIntensity& d : result.domains) {
    result.K1 += d.K1 / count;
    result.K2 += d.K2 / count;
    // Domains that tell no G are left out of its mean; where none tells one it is that of K.
    with_G += std::isnan(d.G) ? 0.0 : 1.0;
    result.G += std::isnan(d.G) ? 0.0 : d.G;
    result.T += d.T / count;
    low = std::min(low, d.K1);
    high = std::max(high, d.K1);
  }
  const double K = std::hypot(result.K1, result.K2);
  result.spread = K > 0.0 ? (high - low) / K : 0.0;
  result.G /= std::max(with_G, 1.0);
  result.G_from_K = result.two_materials ? result.G : K * K / result.E_effective;
  result.G = with_G == 0.0 ? result.G_from_K : result.G;
}

// All terms of G, K and T: each adds to the forces of the nodes it touches.
ConfigurationalForces configurational_forces(const TipSetting& set,
                                             const std::vector<ExtensionField>& fields,
                                             const base::Vector& u) {
  ConfigurationalForces forces;
  add_domain_terms(set, fields, u, forces);
  add_face_terms(set, u, forces);
  add_auxiliary_pressure(set, fields, u, forces);
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

// Of the strain round the axis, u_x / x.
void add_hoop(const TipSetting& set, base::ElementId e, const shape::Point<2>& r, double weight,
              base::Vector& row) {
  const PlaneElement& element = plane_element(set.mesh, e);
  const PlaneValues N = element.N(r);
  const double x = fe::coordinates(element, set.mesh, e).row(0) * N;
  for (int n = 0; n < element.nodes; ++n) {
    const base::NodeId node = set.mesh.element_nodes(e)[static_cast<std::size_t>(n)];
    row[2 * static_cast<Eigen::Index>(node.index())] += weight / x * N[n];
  }
}

base::Vector auxiliary_row(const TipSetting& set, const std::vector<ExtensionField>& fields,
                           std::size_t auxiliary) {
  base::Vector row = base::Vector::Zero(2 * static_cast<Eigen::Index>(set.mesh.node_count()));
  const auto add = [&](base::ElementId e, const shape::Point<2>& r,
                       const fe::Jacobian<PlaneElement>& at, const ContractionTensor& c) {
    const std::span<const base::NodeId> nodes = set.mesh.element_nodes(e);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto freedom = 2 * static_cast<Eigen::Index>(nodes[n].index());
      row.segment<2>(freedom) += c.M * at.dNdx.row(static_cast<Eigen::Index>(n)).transpose();
    }
    if (set.is_axisymmetric()) {
      add_hoop(set, e, r, c.hoop, row);
    }
  };
  for_contractions(set, fields, auxiliary, add);
  for (const ExtensionField& field : fields) {
    add_auxiliary_pressure_row(set, field, auxiliary, 1.0 / static_cast<double>(fields.size()),
                               row);
  }
  return row;
}

// What the strain round the axis, u_x / x at the tip, adds to T (crack.41): of a unit of u_x.
double stress_of_hoop(const TipSetting& set) {
  return fe::effective_modulus(set.material, set.state()) * set.material.nu / set.tip.x.x();
}
double stress_of_hoop(const TipSetting& set, const base::Vector& u) {
  return set.is_axisymmetric()
             ? stress_of_hoop(set) * u[2 * static_cast<Eigen::Index>(set.tip_node.index())]
             : 0.0;
}

TipBody tip_place(const TipSetting& set, const mesh::CrackFront& front) {
  return {set.tip, front.tip_point().node, set.material, set.state(), set.property.thickness};
}

// What temperatures and forces between the crack faces add to the sums of one domain.
std::array<double, auxiliary_field_count>
added_terms(const TipSetting& set, const mesh::CrackFront& front, const ExtensionField& field,
            const CrackFaceForces* crack_faces, const base::Vector& u) {
  std::array<double, auxiliary_field_count> sum{};
  if (set.affine) {
    sum = heat_term(set, front, field, u);
  }
  if (crack_faces != nullptr) {
    const std::array<double, 3> more =
        crack_face_term(set.mesh, tip_place(set, front), field, *crack_faces, u);
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

StressIntensity stress_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                                 const mesh::CrackFront& front,
                                 const std::vector<ExtensionField>& fields,
                                 const TipIntensityRequest& request, const base::Vector& u,
                                 const TipLoads& loads) {
  StressIntensity result;
  if (fields.empty()) {
    return result;
  }
  TipSetting set = tip_setting(model, cracked, front, fields, loads);
  set.affine = fit_affine_temperature(set, front, fields);
  const IntensityConversion factors = factors_of(set, front, request.state);
  result.E_effective = factors.E_used;
  result.two_materials = std::ranges::any_of(
      fields, [&](const ExtensionField& f) { return between_materials(set, f); });
  const ConfigurationalForces forces = configurational_forces(set, fields, u);
  // What stands beside the bracket of (crack.26).
  const double T_of_tip =
      stress_on_crack_faces_at_tip(set, front) - thermal_stress_at_tip(set, front) +
      (request.crack_faces != nullptr ? request.crack_faces->at_tip : 0.0) + stress_of_hoop(set, u);
  double shifted = 0.0;
  double analytic = 0.0;
  double invalid_reason = 0.0; // what is rough in one domain is so for the displacements in all
  for (const ExtensionField& field : fields) {
    invalid_reason = std::max(invalid_reason, factors.halves * G_uncertainty(set, field));
  }
  for (const ExtensionField& field : fields) {
    std::array<double, auxiliary_field_count> sum = forces.released_energies(field);
    const std::array<double, auxiliary_field_count> more =
        added_terms(set, front, field, request.crack_faces, u);
    for (std::size_t k = 0; k < auxiliary_field_count; ++k) {
      sum[k] += more[k];
    }
    DomainIntensity value{.rings = field.rings,
                          .K1 = factors.K() * sum[1],
                          .K2 = front.symmetric_half ? 0.0 : factors.K() * sum[2],
                          .K3 = 0.0,
                          .G = factors.halves * sum[0],
                          .T = factors.T() * sum[3] + T_of_tip};
    const bool jumps = set.affine && has_temperature_jump(set, field);
    if (request.shift && !jumps) {
      const double G =
          factors.halves * shifted_release_rate(set, field, *request.shift * front.size, u) +
          factors.halves * more[0];
      shifted += G;
      analytic += value.G;
      take_shift(value, G);
    }
    const double known = (value.K1 * value.K1 + value.K2 * value.K2) / factors.E_used;
    if (jumps || invalid_reason > worst_invalid_reason * known) {
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
    result.opening = opening_intensity(set, cracked, front, u);
    if (result.opening) {
      (*result.opening)[0] *= factors.restate();
      (*result.opening)[1] *= factors.restate();
    }
  }
  summarise(result);
  return result;
}

base::Matrix intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front,
                            const std::vector<ExtensionField>& fields, model::TipConstraint state) {
  base::Matrix rows = base::Matrix::Zero(freedoms(cracked), 2);
  if (fields.empty()) {
    return rows;
  }
  const TipLoads none;
  const TipSetting set = tip_setting(model, cracked, front, fields, none);
  if (between_materials(set, fields.front())) {
    return rows;
  }
  const double factor = factors_of(set, front, state).K();
  rows.col(0) = factor * auxiliary_row(set, fields, 1);
  if (!front.symmetric_half) {
    rows.col(1) = factor * auxiliary_row(set, fields, 2);
  }
  return rows;
}

std::vector<IntensityFunctionalPoint> intensity_points(const model::Model& model,
                                                       const mesh::CrackedMesh& cracked,
                                                       const mesh::CrackFront& front,
                                                       const std::vector<ExtensionField>& fields,
                                                       model::TipConstraint state) {
  std::vector<IntensityFunctionalPoint> points;
  const TipLoads none;
  if (fields.empty()) {
    return points;
  }
  const TipSetting set = tip_setting(model, cracked, front, fields, none);
  if (between_materials(set, fields.front())) {
    return points;
  }
  const double factor = factors_of(set, front, state).K();
  const auto visit = [&](std::size_t auxiliary, auto&& take) {
    for_contractions(set, fields, auxiliary,
                     [&](base::ElementId e, const shape::Point<2>& r,
                         const fe::Jacobian<PlaneElement>& /*at*/, const ContractionTensor& c) {
                       take(e, r, ContractionTensor{factor * c.M, factor * c.hoop});
                     });
  };
  visit(1, [&](base::ElementId e, const shape::Point<2>& r, const ContractionTensor& c) {
    points.push_back({e, r, {c.M, Eigen::Matrix2d::Zero()}, {c.hoop, 0.0}});
  });
  if (!front.symmetric_half) { // the points come in the same order
    std::size_t i = 0;
    visit(2, [&](base::ElementId, const shape::Point<2>&, const ContractionTensor& c) {
      points[i].M[1] = c.M;
      points[i++].hoop[1] = c.hoop;
    });
  }
  return points;
}

base::Matrix crack_face_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                       const mesh::CrackFront& front,
                                       const std::vector<ExtensionField>& fields,
                                       model::TipConstraint state,
                                       const std::vector<model::Face>& faces) {
  base::Matrix rows = base::Matrix::Zero(freedoms(cracked), 2);
  if (fields.empty()) {
    return rows;
  }
  const TipLoads none;
  const TipSetting set = tip_setting(model, cracked, front, fields, none);
  // The mean over the domains, as K itself is.
  const double factor = factors_of(set, front, state).K() / static_cast<double>(fields.size());
  for (const ExtensionField& field : fields) {
    for (const auto& [node, weight] :
         crack_face_weights(cracked.mesh, tip_place(set, front), field, faces)) {
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

base::Vector t_stress_row(const model::Model& model, const mesh::CrackedMesh& cracked,
                          const mesh::CrackFront& front,
                          const std::vector<ExtensionField>& fields) {
  if (fields.empty()) {
    return base::Vector::Zero(freedoms(cracked));
  }
  const TipLoads none;
  const TipSetting set = tip_setting(model, cracked, front, fields, none);
  base::Vector row =
      factors_of(set, front, model::TipConstraint::automatic).T() * auxiliary_row(set, fields, 3);
  if (set.is_axisymmetric()) {
    row[2 * static_cast<Eigen::Index>(set.tip_node.index())] += stress_of_hoop(set);
  }
  return row;
}

IntensityConstant intensity_constant(const model::Model& model, const mesh::CrackedMesh& cracked,
                                     const mesh::CrackFront& front,
                                     const std::vector<ExtensionField>& fields,
                                     model::TipConstraint state, const TipLoads& loads) {
  if (loads.loads.empty() && loads.temperature.size() == 0) {
    return {};
  }
  // K at u = 0 is what the loads add by themselves (crack.23).
  TipIntensityRequest request;
  request.state = state;
  const StressIntensity K = stress_intensity(model, cracked, front, fields, request,
                                             base::Vector::Zero(freedoms(cracked)), loads);
  return {K.K1, K.K2, K.T};
}

} // namespace spricka::crack
