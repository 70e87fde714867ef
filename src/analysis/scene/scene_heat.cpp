// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_heat.hpp"

#include "fe/thermal.hpp"
#include "model/loads.hpp"
#include "model/model.hpp"

namespace spricka::analysis {

std::shared_ptr<const fe::CaseTemperature>
scene_case_temperature(const model::Model& model, const Discretisation& scene,
                       const model::LoadCase& load_case) {
  fe::PatchedMesh patched{scene.cracked.mesh, model.mesh, nullptr, scene.cracked.front_nodes()};
  if (scene.cracked.host.size() == scene.cracked.mesh.element_count()) {
    patched.host = &scene.cracked.host;
  }
  return std::make_shared<const fe::CaseTemperature>(
      fe::make_case_temperature(model, patched, load_case));
}

model::LoadCase without_temperature_loads(const model::LoadCase& load_case) {
  model::LoadCase rest = load_case;
  std::erase_if(rest.loads,
                [](const model::Load& l) { return l.type == model::LoadType::temperature; });
  return rest;
}

base::Vector thermal_nodal_forces(const model::Model& model, const model::Mesh& mesh,
                                  const fe::CaseTemperature& heat) {
  base::Vector f = base::Vector::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()));
  if (heat.temperature.size() > 0) {
    f = fe::thermal_load(model, mesh, heat.temperature);
    fe::add_residual_temperature_load(model, mesh, {&heat, 1.0}, {}, f);
  }
  return f;
}

std::vector<fe::ScaledTemperature> scaled_case_temperatures(const Discretisation& scene,
                                                            const base::Vector& case_factor) {
  std::vector<fe::ScaledTemperature> acting;
  for (std::size_t c = 0; c < scene.case_heat.size(); ++c) {
    const double factor = case_factor[static_cast<Eigen::Index>(c)];
    if (factor != 0.0 && scene.case_heat[c]->temperature.size() > 0) {
      acting.push_back({scene.case_heat[c].get(), factor});
    }
  }
  return acting;
}

} // namespace spricka::analysis
