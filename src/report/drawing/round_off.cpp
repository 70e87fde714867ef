// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/round_off.hpp"

#include "geometry/box.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::report {
namespace {

constexpr double round_off_part = 1e-9;
/// Where forces balance, they are measured by so much of the stiffness.
constexpr double least_part_of_stiffness = 1e-3;

/// Diagonal of the box round the nodes that elements have.
double size_of(const model::Mesh& mesh) {
  geometry::Box<3> box;
  for (const base::NodeId n : mesh.nodes) {
    box.extend({mesh.x[n.index()], mesh.x[n.index()]});
  }
  return mesh.nodes.empty() ? 0.0 : box.diagonal();
}

/// E times displacement [stress * length].
double stiffness_times_way(const model::Model& model, const results::CrackLengthResult& increment) {
  double softest = std::numeric_limits<double>::infinity(); // so that nothing real is hidden
  for (const model::ElementProperty& property : model.properties) {
    softest = std::min(softest, model.materials[property.material.index()].E);
  }
  double way = 0.0;
  for (const results::LoadStepResult& step : increment.steps) {
    way = step.u.size() > 0 ? std::max(way, step.u.lpNorm<Eigen::Infinity>()) : way;
  }
  return std::isfinite(softest) ? softest * way : 0.0;
}

} // namespace

double reference_elastic_stress(const model::Model& model,
                                const results::CrackLengthResult& increment) {
  const double size = size_of(increment.mesh);
  return size > 0.0 ? stiffness_times_way(model, increment) / size : 0.0;
}

double reference_elastic_force(const model::Model& model,
                               const results::CrackLengthResult& increment) {
  double depth = 0.0;
  for (const model::ElementProperty& property : model.properties) {
    const bool plane = property.state == model::StressState::plane_stress ||
                       property.state == model::StressState::plane_strain;
    depth = std::max(depth, plane ? property.thickness : size_of(increment.mesh));
  }
  return stiffness_times_way(model, increment) * depth;
}

double least_contact_pressure(const model::Model& model,
                              const results::CrackLengthResult& increment) {
  double largest = least_part_of_stiffness * reference_elastic_stress(model, increment);
  for (const results::LoadStepResult& step : increment.steps) {
    for (const results::ContactResult& contact : step.contacts) {
      largest = std::max({largest, std::abs(contact.max_pressure), std::abs(contact.min_pressure)});
    }
  }
  return round_off_part * largest;
}

double least_contact_pressure(const model::Model& model, const results::RunResult& run) {
  double least = 0.0;
  for (const results::CrackLengthResult& increment : run.increments) {
    least = std::max(least, least_contact_pressure(model, increment));
  }
  return least;
}

double largest_von_mises_stress(const results::LoadStepResult& step) {
  double largest = 0.0;
  for (const results::Stress& stress : step.stress) {
    largest = std::max(largest, results::von_mises(stress));
  }
  return largest;
}

bool has_significant_stress(const model::Model& model, const results::CrackLengthResult& increment,
                            const results::LoadStepResult& step) {
  double scale = reference_elastic_stress(model, increment);
  for (const results::LoadStepResult& other : increment.steps) {
    scale = std::max(scale, largest_von_mises_stress(other));
  }
  return largest_von_mises_stress(step) > round_off_part * scale;
}

} // namespace spricka::report
