// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/parameter_derivatives.hpp"

#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene_heat.hpp"
#include "analysis/steps/row_opening.hpp"
#include "base/index.hpp"
#include "fe/thermal.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace spricka::analysis {

namespace {

using base::index;

ParameterPartialDerivatives derivative_by(const SolvedStepKFunction& K,
                                          results::SensitivityParameter cause, std::string name,
                                          double value) {
  ParameterPartialDerivatives out;
  out.is.cause = cause;
  out.is.name = std::move(name);
  out.is.value = value;
  out.direct = base::Vector::Zero(K.of_loads.rows());
  return out;
}

void add_load_derivatives(const SolvedStepKFunction& K,
                          std::vector<ParameterPartialDerivatives>& causes) {
  const Discretisation& scene = K.scene;
  for (std::size_t c = 0; c < K.model.cases.size(); ++c) {
    ParameterPartialDerivatives one =
        derivative_by(K, results::SensitivityParameter::load, K.model.cases[c].name,
                      K.solver.factors().case_factor[index(c)]);
    one.load = K.case_load.col(index(c));
    one.direct = K.of_loads.col(index(c));
    const base::Vector given = scene.case_displacement.col(index(c));
    // Prescribed displacements pull at the body, open rows and move nodes that K takes
    // (sensitivity.7).
    if ((given.array() != 0.0).any()) {
      one.gap.resize(index(scene.table.size()));
      for (std::size_t r = 0; r < scene.table.size(); ++r) {
        one.gap[index(r)] = row_opening(scene.contact_row(r), scene.cracked.mesh.dim, given);
      }
      one.direct += K.of_displacements(given);
    }
    causes.push_back(std::move(one));
  }
}

void add_fit_derivatives(const SolvedStepKFunction& K,
                         std::vector<ParameterPartialDerivatives>& causes) {
  const Discretisation& scene = K.scene;
  for (std::size_t c = 0; c < K.model.contacts.size(); ++c) {
    const model::Contact& contact = K.model.contacts[c];
    if (!contact.gap || !K.solver.factors().mounted[c]) {
      continue;
    }
    // An interference is a negative gap (sensitivity.7).
    const double interference = -*contact.gap * K.solver.factors().fit[c];
    ParameterPartialDerivatives one =
        derivative_by(K, results::SensitivityParameter::fit, contact.name,
                      interference == 0.0 ? 0.0 : interference);
    one.gap = base::Vector::Zero(index(scene.table.size()));
    for (std::size_t i = 0; i < scene.pairs[c].normal.size(); ++i) {
      one.gap[index(scene.table.first[c] + i)] = -scene.pairs[c].normal[i].area;
    }
    causes.push_back(std::move(one));
  }
}

// Thermal loads by material [dim * node, material] of a temperature field [connectivity index].
// With K u they make what a stiffer material amounts to as loads, E d/dE (f - K u) (sensitivity.8).
base::Matrix thermal_loads(const model::Model& model, const model::Mesh& mesh,
                           const base::Vector& temperature) {
  std::vector<base::Vector> own(model.materials.size(), base::Vector::Zero(temperature.size()));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::size_t m = model.element_property(mesh, base::ElementId(e)).material.index();
    const auto first = static_cast<Eigen::Index>(mesh.first[e]);
    const auto count = static_cast<Eigen::Index>(mesh.element_nodes(base::ElementId(e)).size());
    own[m].segment(first, count) = temperature.segment(first, count);
  }
  base::Matrix out(static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim,
                   static_cast<Eigen::Index>(own.size()));
  for (std::size_t m = 0; m < own.size(); ++m) {
    out.col(static_cast<Eigen::Index>(m)) = fe::thermal_load(model, mesh, own[m]);
  }
  return out;
}

// Thermal loads less internal forces, f^T - K_m u (sensitivity.8). [dim * node, material]
base::Matrix loads_by_materials(const SolvedStepKFunction& K) {
  base::Matrix loads = -K.state.internal;
  if (K.state.temperature.size() > 0) {
    const model::Mesh& mesh = K.scene.cracked.mesh;
    loads += thermal_loads(K.model, mesh, K.state.temperature);
    for (const fe::ScaledTemperature& acting :
         scaled_case_temperatures(K.scene, K.state.case_factor)) {
      for (std::size_t m = 0; m < K.model.materials.size(); ++m) {
        base::Vector f = base::Vector::Zero(loads.rows());
        fe::add_residual_temperature_load(K.model, mesh, acting, base::MaterialId(m), f);
        loads.col(index(m)) += f;
      }
    }
  }
  return loads;
}

// [point] whose modulus K goes with: that of a first element of its front's domains; that behind
// the last where it has none.
std::vector<std::size_t> point_materials(const model::Model& model, const Discretisation& scene) {
  const auto material = [&](const crack::FrontIntegralDomains& domains) {
    for (const std::vector<crack::VirtualExtensionField>& point : domains.points) {
      if (!point.empty() && !point.front().elements.empty()) {
        return model.element_property(scene.cracked.mesh, point.front().elements.front())
            .material.index();
      }
    }
    return model.materials.size();
  };
  std::vector<std::size_t> materials;
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    materials.insert(materials.end(), scene.cracked.fronts[f].points.size(),
                     material(scene.domains[f]));
  }
  return materials;
}

// [K] E d/dE of what the loads of the step add to K, at points in that material: a constant and a
// part that goes with E, which twice the modulus shows.
base::Vector load_terms_by_modulus(const SolvedStepKFunction& K, std::size_t material) {
  const base::Vector& case_factor = K.state.case_factor;
  if (!loads_act_on_domains(K.model, K.scene, case_factor)) {
    return base::Vector::Zero(K.scene.k_layout().count());
  }
  model::Model stiffer = K.model;
  stiffer.materials[material].E *= 2.0;
  return K_added_by_loads(stiffer, K.scene, case_factor) -
         K_added_by_loads(K.model, K.scene, case_factor);
}

} // namespace

std::vector<ParameterPartialDerivatives>
load_and_fit_partial_derivatives(const SolvedStepKFunction& K) {
  std::vector<ParameterPartialDerivatives> causes;
  add_load_derivatives(K, causes);
  add_fit_derivatives(K, causes);
  return causes;
}

void add_modulus_partial_derivatives(const SolvedStepKFunction& K,
                                     std::vector<ParameterPartialDerivatives>& causes) {
  const base::Matrix loads = loads_by_materials(K);
  // What displacements make of K goes with the modulus at the point.
  const base::Vector own = K.of_displacements(K.state.u);
  const crack::KLayout layout = K.scene.k_layout();
  const std::vector<std::size_t> material = point_materials(K.model, K.scene);
  for (std::size_t m = 0; m < K.model.materials.size(); ++m) {
    const double E = K.model.materials[m].E;
    ParameterPartialDerivatives one =
        derivative_by(K, results::SensitivityParameter::modulus, K.model.materials[m].name, E);
    one.load = loads.col(index(m)) / E;
    if (std::ranges::find(material, m) != material.end()) {
      const base::Vector constant = load_terms_by_modulus(K, m);
      for (std::size_t p = 0; p < material.size(); ++p) {
        if (material[p] == m) {
          layout.segment_of_point(one.direct, p) =
              (layout.segment_of_point(own, p) + layout.segment_of_point(constant, p)) / E;
        }
      }
    }
    causes.push_back(std::move(one));
  }
}

base::Matrix gather_load_or_gap_columns(std::span<const ParameterPartialDerivatives> causes,
                                        base::Vector ParameterPartialDerivatives::*part,
                                        Eigen::Index size) {
  base::Matrix columns = base::Matrix::Zero(size, index(causes.size()));
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if ((causes[i].*part).size() > 0) {
      columns.col(index(i)) = causes[i].*part;
    }
  }
  return columns;
}

void add_sensitivity_note(const std::string& text, results::LoadStepResult& result) {
  for (results::FrontResult& front : result.fronts) {
    std::vector<std::string>& notes = front.sensitivities.notes;
    if (std::ranges::find(notes, text) == notes.end()) {
      notes.push_back(text);
    }
  }
}

LinearRanges unbounded_ranges(std::size_t causes) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return LinearRanges(causes, std::array{-never, never});
}

void add_sensitivity_parameters(const std::vector<ParameterPartialDerivatives>& causes,
                                results::LoadStepResult& result) {
  for (results::FrontResult& front : result.fronts) {
    for (const ParameterPartialDerivatives& one : causes) {
      front.sensitivities.by_parameter.push_back(one.is);
    }
  }
}

void store_one_sided_derivative(const crack::KLayout& layout, const base::Vector& dK,
                                std::size_t cause,
                                std::vector<std::array<double, 3>> results::Sensitivity::*side,
                                results::LoadStepResult& result) {
  std::size_t point = 0;
  for (results::FrontResult& front : result.fronts) {
    std::vector<std::array<double, 3>>& values = front.sensitivities.by_parameter[cause].*side;
    for (std::size_t p = 0; p < front.points.size(); ++p) {
      const Eigen::Index first = layout.first_mode_index(point++);
      std::array<double, 3>& own = values.emplace_back();
      for (Eigen::Index k = 0; k < layout.mode_count(); ++k) {
        own[base::at(k)] = dK[first + k];
      }
    }
  }
}

void store_derivatives(const crack::KLayout& layout, const base::Matrix& dK,
                       const LinearRanges& reach, results::LoadStepResult& result) {
  for (std::size_t i = 0; i < reach.size(); ++i) {
    store_one_sided_derivative(layout, dK.col(index(i)), i, &results::Sensitivity::below, result);
    for (results::FrontResult& front : result.fronts) {
      results::Sensitivity& one = front.sensitivities.by_parameter[i];
      one.above = one.below;
      if (reach[i]) {
        one.range = {one.value + (*reach[i])[0], one.value + (*reach[i])[1]};
      }
    }
  }
}

} // namespace spricka::analysis
