// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_loads.hpp"

#include "analysis/scene/scene_heat.hpp"
#include "analysis/scene/scene_nodes.hpp"
#include "analysis/scene/scene_ties.hpp"
#include "fe/assemble.hpp"
#include "fe/bearing.hpp"
#include "model/model.hpp"
#include "sense/load_totals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// A resultant that does not arrive (a bearing load whose pin misses the bore) must not pass for a
// load of nothing.
bool arrives(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
             const base::Vector& f) {
  if (load.type != model::LoadType::bearing && load.type != model::LoadType::resultant) {
    return true;
  }
  const std::array<bool, 3> balanced = load.type == model::LoadType::bearing
                                           ? fe::mirror_cut_axes(model, mesh, load)
                                           : std::array<bool, 3>{};
  for (int c = 0; c < mesh.dim && c < static_cast<int>(load.value.size()); ++c) {
    double sum = 0.0;
    for (Eigen::Index i = c; i < f.size(); i += mesh.dim) {
      sum += f[i];
    }
    const double wanted = load.value[static_cast<std::size_t>(c)](base::Vec3::Zero());
    if (!balanced.at(static_cast<std::size_t>(c)) &&
        std::abs(sum - wanted) > 1e-9 * (std::abs(wanted) + f.lpNorm<1>())) {
      return false;
    }
  }
  return f.lpNorm<1>() > 0.0 || load.value.empty() ||
         std::all_of(load.value.begin(), load.value.end(), [](const base::CompiledExpression& v) {
           return v(base::Vec3::Zero()) == 0.0;
         });
}

// Adds the nodal forces of all loads but temperatures to `f`, and checks each load; returns whether
// all are sound.
bool add_case_forces(const model::Model& model, const model::Mesh& mesh,
                     const model::LoadCase& load_case, base::Matrix::ColXpr f,
                     base::Diagnostics& diagnostics) {
  bool sound = true;
  for (const model::Load& load : load_case.loads) {
    const model::LoadCase alone{load_case.name, {load}};
    const bool displaces = load.type == model::LoadType::displacement;
    const base::Vector own = displaces ? fe::prescribed_displacement_vector(model, mesh, alone)
                                       : fe::consistent_load_vector(model, mesh, alone);
    if (!displaces && load.type != model::LoadType::temperature) {
      f += own;
    }
    if (arrives(model, mesh, load, own)) {
      sound = sense::check_load_on_cracked_mesh(model, mesh, load_case, load, own, diagnostics) &&
              sound;
    } else {
      diagnostics.error(
          load.span, "E413",
          fmt::format("load case {}: the resultant cannot be carried by this set", load_case.name),
          "a bearing load needs faces of a bore on the side it pushes to");
      sound = false;
    }
  }
  return sound;
}

} // namespace

bool make_case_loads(const model::Model& model, Discretisation& scene,
                     base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  bool good = check_force_nodes(model, scene, diagnostics);
  if (!good) {
    return false;
  }
  const auto n = static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim;
  const auto cases = static_cast<Eigen::Index>(model.cases.size());
  const Eigen::Index columns = cases + (scene.ties->has_constants() ? 1 : 0);
  scene.case_load = base::Matrix::Zero(n, columns);
  scene.case_displacement = base::Matrix::Zero(n, columns);
  for (Eigen::Index c = 0; c < cases; ++c) {
    const model::LoadCase& load_case = model.cases[static_cast<std::size_t>(c)];
    good = add_case_forces(model, mesh, load_case, scene.case_load.col(c), diagnostics) && good;
    scene.case_displacement.col(c) = fe::prescribed_displacement_vector(model, mesh, load_case);
    for (Eigen::Index i = 0; i < n; ++i) { // a crack may have freed one face of what a load moves
      if (scene.cls[static_cast<std::size_t>(i)] == model::FreedomRole::local ||
          scene.cls[static_cast<std::size_t>(i)] == model::FreedomRole::external) {
        scene.case_displacement(i, c) = 0.0;
      }
    }
    scene.case_heat.push_back(scene_case_temperature(model, scene, load_case));
    const fe::CaseTemperature& heat = *scene.case_heat.back();
    if (heat.temperature.size() > 0) {
      if (scene.case_temperature.size() == 0) {
        scene.case_temperature = base::Matrix::Zero(heat.temperature.size(), columns);
      }
      scene.case_temperature.col(c) = heat.temperature;
      scene.case_load.col(c) += thermal_nodal_forces(model, mesh, heat);
    }
  }
  return good && prescribe_dependent_freedoms(model, scene, diagnostics);
}

base::Matrix reduced_case_loads(const model::Model& model, const Discretisation& scene) {
  base::Matrix load = scene.case_load;
  std::vector<base::ElementId> all;
  for (std::size_t e = 0; e < scene.cracked.mesh.element_count(); ++e) {
    all.emplace_back(e);
  }
  for (Eigen::Index c = 0; c < load.cols(); ++c) {
    if ((scene.case_displacement.col(c).array() != 0.0).any()) {
      base::Vector pull = base::Vector::Zero(load.rows());
      // With the displacements at supports given, K_0 u_0 is a load on the rest.
      fe::add_internal_force(model, scene.cracked.mesh, all, scene.case_displacement.col(c), pull);
      load.col(c) -= pull;
    }
  }
  scene.ties->transfer_forces_to_masters(load);
  return load;
}

} // namespace spricka::analysis
