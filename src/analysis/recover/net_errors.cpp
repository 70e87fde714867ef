// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/net_errors.hpp"

#include "base/by_dimension.hpp"
#include "fe/error_estimate.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr std::size_t most_named = 3;
constexpr double no_energy = 1e-12; // of the most that a net of the run holds

// Strain energy that round-off of the forces which go through a model leaves in it: of their square
// over a stiffness.
constexpr double round_off_energy = 1e-20;

double energy_of_round_off(const model::Model& model, const model::Mesh& mesh,
                           const results::LoadStepResult& step) {
  double size = 0.0;
  for (const base::Vec3& x : mesh.x) {
    size = std::max(size, (x - mesh.x.front()).norm());
  }
  // Force over displacement is E times a length: that of the body, in the plane the thickness.
  const base::ByDimension<double> length{model::is_axisymmetric(model) ? size : 1.0, size};
  double stiff = 0.0;
  for (const model::ElementProperty& property : model.properties) {
    const base::ByDimension<double> thickness{property.thickness, 1.0};
    stiff = std::max(stiff, model.materials[property.material.index()].E * thickness.at(mesh.dim));
  }
  stiff *= length.at(mesh.dim);
  const double force = step.reaction.size() > 0 ? step.reaction.norm() : 0.0;
  return stiff > 0.0 ? round_off_energy * force * force / stiff : 0.0;
}

// The strain energy of a net, where the records have it.
double energy_of(const results::LoadStepResult& step, const std::string& net) {
  const auto found = std::ranges::find(step.nets, net, &results::ForceBalance::body);
  return found == step.nets.end() ? std::numeric_limits<double>::infinity() : found->energy;
}

// Nodes that are held though no side of theirs is: their reaction is a force on a point.
void mark_point_supports(const Discretisation& scene, std::vector<bool>& marked) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto held = [&](base::NodeId n, int c) {
    const model::FreedomRole k =
        scene.cls[n.index() * static_cast<std::size_t>(mesh.dim) + static_cast<std::size_t>(c)];
    return k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed;
  };
  // [dim * node] no side with this node is held as a whole in this direction.
  std::vector<bool> alone(mesh.node_count() * static_cast<std::size_t>(mesh.dim), true);
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<base::NodeId> nodes = mesh::nodes_of_faces(mesh, {face});
    for (int c = 0; c < mesh.dim; ++c) {
      if (std::ranges::all_of(nodes, [&](base::NodeId n) { return held(n, c); })) {
        for (const base::NodeId n : nodes) {
          alone[n.index() * static_cast<std::size_t>(mesh.dim) + static_cast<std::size_t>(c)] =
              false;
        }
      }
    }
  }
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const auto dim = static_cast<std::size_t>(mesh.dim);
    if (alone[i] && held(base::NodeId(i / dim), static_cast<int>(i % dim))) {
      marked[i / dim] = true;
    }
  }
}

// Nodes with a force of their own, no other loaded node in their elements: beneath a single force
// displacements and energy have no bound, on any mesh. [node]
std::vector<bool> single_forces(const model::Model& model, const model::Mesh& mesh) {
  std::vector<bool> single(mesh.node_count(), false);
  for (const model::LoadCase& load_case : model.cases) {
    std::vector<bool> loaded(mesh.node_count(), false);
    for (const model::Load& load : load_case.loads) {
      if (load.type == model::LoadType::force && load.nodes.valid()) {
        for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
          loaded[n.index()] = true;
        }
      }
    }
    std::vector<bool> alone = loaded;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.element_nodes(base::ElementId(e));
      if (std::ranges::count_if(nodes, [&](base::NodeId n) { return loaded[n.index()]; }) > 1) {
        for (const base::NodeId n : nodes) {
          alone[n.index()] = false;
        }
      }
    }
    for (std::size_t n = 0; n < single.size(); ++n) {
      single[n] = single[n] || alone[n];
    }
  }
  return single;
}

// Elements with a marked node, and those next to them.
std::vector<bool> around(const model::Mesh& mesh, std::vector<bool> node) {
  std::vector<bool> near(mesh.element_count(), false);
  for (int ring = 0; ring < 2; ++ring) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.element_nodes(base::ElementId(e));
      near[e] =
          near[e] || std::ranges::any_of(nodes, [&](base::NodeId n) { return node[n.index()]; });
    }
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        node[n.index()] = node[n.index()] || near[e];
      }
    }
  }
  return near;
}

// Stresses have no bound at tips and where a single node is pushed or held: no mesh ends the
// estimated error there, and it says nothing of the rest of the net.
std::vector<bool> singular_elements(const model::Model& model, const Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<bool> tip(mesh.node_count(), false);
  for (const mesh::CrackFront& front : scene.cracked.fronts) {
    for (const mesh::FrontPoint& point : front.points) {
      tip[point.node.index()] = true;
    }
  }
  std::vector<bool> point = single_forces(model, mesh);
  mark_point_supports(scene, point);
  std::vector<bool> singular = around(mesh, std::move(point));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    singular[e] =
        singular[e] || !scene.cracked.host[e].valid() ||
        std::any_of(nodes.begin(), nodes.end(), [&](base::NodeId n) { return tip[n.index()]; });
  }
  return singular;
}

results::NetErrorEstimate error_of(const std::string& name, std::vector<base::ElementId> elements,
                                   const fe::ErrorEstimate& estimate,
                                   const std::vector<double>& energy, double floor) {
  results::NetErrorEstimate found;
  found.net = name;
  double error = 0.0;
  double strain = 0.0;
  double noise = floor;
  for (const base::ElementId e : elements) {
    error += estimate.energy[e.index()];
    strain += std::max(energy[e.index()], 0.0);
    noise += estimate.noise[e.index()];
  }
  if (!(error + strain > noise)) {
    return found; // nothing but round-off
  }
  // The exact energy is about that of the mesh and of the error together.
  found.part = std::sqrt(error / (error + strain));
  const auto named = static_cast<std::ptrdiff_t>(std::min(most_named, elements.size()));
  std::partial_sort(elements.begin(), elements.begin() + named, elements.end(),
                    [&](base::ElementId a, base::ElementId b) {
                      const double x = estimate.energy[a.index()];
                      const double y = estimate.energy[b.index()];
                      return x > y || (x == y && a < b);
                    });
  found.worst.assign(elements.begin(), elements.begin() + named);
  for (const base::ElementId e : found.worst) {
    found.worst_share += error > 0.0 ? estimate.energy[e.index()] / error : 0.0;
  }
  return found;
}

bool has_bars(const results::LoadStepResult& step) {
  return std::ranges::any_of(step.fronts, &results::FrontResult::has_error_bar);
}

} // namespace

void add_energy_errors(const model::Model& model, const Discretisation& scene,
                       const std::vector<double>& energy, results::LoadStepResult& step) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const fe::ErrorEstimate estimate = fe::estimate_error(model, mesh, {step.u, step.temperature});
  const std::vector<bool> singular = singular_elements(model, scene);
  const double floor = energy_of_round_off(model, mesh, step);
  std::vector<std::vector<base::ElementId>> by_net(model.nets.size());
  std::vector<base::ElementId> all;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (!singular[e]) {
      by_net[mesh.element_net[e].index()].emplace_back(e);
      all.emplace_back(e);
    }
  }
  for (std::size_t n = 0; n < by_net.size(); ++n) {
    if (!by_net[n].empty()) {
      step.errors.push_back(error_of(model.nets[n].name.empty() ? "(deck)" : model.nets[n].name,
                                     std::move(by_net[n]), estimate, energy, floor));
    }
  }
  step.errors.push_back(error_of("*", std::move(all), estimate, energy, floor));
}

std::vector<std::string> describe_coarse_nets(const results::RunResult& run) {
  struct Worst {
    const results::NetErrorEstimate* error = nullptr;
    const results::CrackLengthResult* increment = nullptr;
    const results::LoadStepResult* step = nullptr;
  };
  double most = 0.0;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::ForceBalance& net : step.nets) {
        most = std::max(most, net.energy);
      }
    }
  }
  std::map<std::string, Worst> by_net;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::NetErrorEstimate& error : step.errors) {
        if (energy_of(step, error.net) < no_energy * most) {
          continue; // next to nothing strains it
        }
        Worst& worst = by_net[error.net];
        if (error.net != "*" && error.part > coarse_mesh &&
            (worst.error == nullptr || error.part > worst.error->part)) {
          worst = {&error, &increment, &step};
        }
      }
    }
  }
  std::vector<std::string> reported;
  for (const auto& [net, worst] : by_net) {
    if (worst.error == nullptr) {
      continue;
    }
    std::string labels;
    for (const base::ElementId e : worst.error->worst) {
      labels += fmt::format("{}{}", labels.empty() ? "" : ", ",
                            worst.increment->mesh.element_label[e.index()]);
    }
    reported.push_back(fmt::format(
        "net {}: the mesh is coarse for step {}{}: estimated energy error {:.1f} %, which is about "
        "how far stresses are off on the whole{}; it is too stiff by {:.1f} %. {:.0f} % of that "
        "stems from the elements {}",
        net, worst.step->step,
        run.increments.size() > 1 ? fmt::format(", increment {}", worst.increment->number) : "",
        100.0 * worst.error->part, has_bars(*worst.step) ? " (K has its own error bars)" : "",
        100.0 * worst.error->part * worst.error->part, 100.0 * worst.error->worst_share, labels));
  }
  return reported;
}

} // namespace spricka::analysis
