// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/nodal_forces.hpp"

#include "analysis/scene/scene_heat.hpp"
#include "analysis/steps/resting_forces.hpp"
#include "base/by_dimension.hpp"
#include "fe/assemble.hpp"
#include "fe/thermal.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace spricka::analysis {

namespace {

// Forces of strains of 1e-13 all over the softest body: what coordinates in sixteen digits give
// bodies that touch and are not loaded. There is no telling whether such forces balance.
double round_off_force(const model::Model& model, const model::Mesh& mesh) {
  base::Vec3 low = base::Vec3::Zero();
  base::Vec3 high = base::Vec3::Zero();
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    low = n == 0 ? mesh.x[n] : base::Vec3(low.cwiseMin(mesh.x[n]));
    high = n == 0 ? mesh.x[n] : base::Vec3(high.cwiseMax(mesh.x[n]));
  }
  const double extent = (high - low).norm();
  double softest = std::numeric_limits<double>::infinity();
  for (const model::ElementProperty& property : model.properties) {
    const base::ByDimension<double> depth{property.thickness, extent};
    softest = std::min(softest,
                       model.materials[property.material.index()].E * depth.at(mesh.dim) * extent);
  }
  return std::isfinite(softest) ? 1e-13 * softest : 0.0;
}

// What loads, contacts and supports leave over is the ties' where there is one; elsewhere it is an
// error of the solution and stays to be seen as such.
base::Vector tie_forces(const Discretisation& scene, const base::Vector& left_over) {
  base::Vector tie = base::Vector::Zero(left_over.size());
  for (const fe::ConstraintTransformation::DependentRow& row : scene.ties->rows()) {
    tie[row.freedom] = left_over[row.freedom];
    for (const fe::FreedomTerm& term : row.terms) {
      tie[term.freedom] = left_over[term.freedom];
    }
  }
  return tie;
}

void add_contact_forces(const Discretisation& scene, StepState& state) {
  const int dim = scene.cracked.mesh.dim;
  state.contact = base::Vector::Zero(state.u.size());
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    for (std::size_t r = scene.table.first[c]; r < scene.table.first[c + 1]; ++r) {
      const double value =
          state.pair_lambda[c][static_cast<Eigen::Index>(r - scene.table.first[c])];
      for (const contact::RowEntry& entry : scene.contact_row(r).entries) {
        state.contact.segment(static_cast<Eigen::Index>(entry.node.index()) * dim, dim) +=
            value * entry.weight.head(dim);
      }
    }
  }
}

void add_internal_forces(const model::Model& model, const Discretisation& scene, StepState& state) {
  const model::Mesh& mesh = scene.cracked.mesh;
  // With tips internal forces are kept by material: derivatives by moduli take them
  // (sensitivity.8).
  const bool cracked = !scene.cracked.fronts.empty();
  std::vector<std::vector<base::ElementId>> elements(cracked ? model.materials.size() : 1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::MaterialId material = model.element_property(mesh, base::ElementId(e)).material;
    elements[cracked ? material.index() : 0].emplace_back(e);
  }
  state.energy.assign(mesh.element_count(), 0.0);
  state.internal.resize(state.u.size(), static_cast<Eigen::Index>(elements.size()));
  for (std::size_t m = 0; m < elements.size(); ++m) {
    base::Vector force = base::Vector::Zero(state.u.size());
    fe::add_internal_force(model, mesh, elements[m], state.u, force, &state.energy);
    state.internal.col(static_cast<Eigen::Index>(m)) = force;
  }
}

} // namespace

void add_nodal_forces(const model::Model& model, const Discretisation& scene,
                      const base::Vector& case_factor, StepState& state) {
  const model::Mesh& mesh = scene.cracked.mesh;
  state.force = scene.case_load * case_factor;
  add_contact_forces(scene, state);
  add_internal_forces(model, scene, state);
  const base::Vector internal = state.internal.rowwise().sum();
  if (state.temperature.size() > 0) {
    fe::add_thermal_energy(model, mesh, state.temperature, state.u, state.energy);
    fe::add_residual_temperature_energy(model, mesh, scaled_case_temperatures(scene, case_factor),
                                        state.u, state.energy);
  }
  // Forces on dependent freedoms are their masters' to bear.
  base::Vector open = internal - state.force - state.contact;
  if (state.resting.size() > 0) {
    open += state.resting;
  }
  base::Matrix out_of_balance = open;
  scene.ties->transfer_forces_to_masters(out_of_balance);
  // Held freedoms leave their reaction over; what is left at free ones is the error.
  state.reaction = out_of_balance;
  double left_over = 0.0;
  for (Eigen::Index i = 0; i < state.reaction.size(); ++i) {
    const model::FreedomRole k = scene.cls[static_cast<std::size_t>(i)];
    if (k != model::FreedomRole::suppressed && k != model::FreedomRole::prescribed) {
      left_over = std::max(left_over, std::abs(state.reaction[i]));
      state.reaction[i] = 0.0;
    }
  }
  if (!scene.ties->rows().empty()) {
    state.tie = tie_forces(scene, open - state.reaction);
  }
  if (const std::optional<results::Note> note = residual_force_note(state.resting, state.contact)) {
    state.notes.push_back(*note);
  }
  const double scale =
      std::max({state.force.lpNorm<1>(), state.contact.lpNorm<1>(), state.reaction.lpNorm<1>(),
                internal.lpNorm<1>()}); // ties with constants strain without load
  state.imbalance = scale > round_off_force(model, mesh) ? left_over / scale : 0.0;
}

} // namespace spricka::analysis
