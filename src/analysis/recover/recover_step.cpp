// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/recover_step.hpp"

#include "analysis/recover/body_overlap.hpp"
#include "analysis/recover/contact_limits.hpp"
#include "analysis/recover/gather_fronts.hpp"
#include "analysis/recover/judge_size.hpp"
#include "analysis/recover/recover_contacts.hpp"
#include "model/model.hpp"

#include <numeric>

namespace spricka::analysis {

namespace {

void add_node(results::ForceBalance& balance, const StepState& state, base::NodeId n, int dim) {
  const auto at = static_cast<Eigen::Index>(n.index()) * dim;
  balance.applied.head(dim) += state.force.segment(at, dim);
  balance.contact.head(dim) += state.contact.segment(at, dim);
  balance.reaction.head(dim) += state.reaction.segment(at, dim);
  if (state.tie.size() > 0) {
    balance.tie.head(dim) += state.tie.segment(at, dim);
  }
}

void drop_radial(results::ForceBalance& balance) { // radial forces balance round the circumference
  for (base::Vec3* sum : {&balance.applied, &balance.contact, &balance.reaction, &balance.tie}) {
    sum->x() = 0.0;
  }
}

void gather_bodies(const model::Model& model, const Discretisation& scene,
                   const std::vector<SubstructuredBody>& bodies, const StepState& state,
                   results::LoadStepResult& out) {
  for (const SubstructuredBody& body : bodies) {
    results::ForceBalance balance;
    balance.body = body.name;
    for (const base::NodeId n : body.body.nodes) {
      add_node(balance, state, n, scene.cracked.mesh.dim);
    }
    for (const base::ElementId e : body.body.elements) {
      balance.energy += state.energy[e.index()];
    }
    if (model::is_axisymmetric(model)) {
      drop_radial(balance);
    }
    out.balance.push_back(balance);
  }
}

// What presses on a rigid target has to be taken by whatever holds it.
void gather_targets(const model::Model& model, const results::LoadStepResult& found,
                    std::vector<results::ForceBalance>& targets) {
  for (std::size_t r = 0; r < model.rigids.size(); ++r) {
    results::ForceBalance balance;
    balance.body = model.rigids[r].name;
    bool used = false;
    for (std::size_t c = 0; c < model.contacts.size(); ++c) {
      if (model.contacts[c].rigid == base::RigidId(r)) {
        balance.contact -= found.contacts[c].force_on_slave;
        used = true;
      }
    }
    balance.reaction = -balance.contact;
    if (model::is_axisymmetric(model)) {
      drop_radial(balance);
    }
    if (used) {
      targets.push_back(balance);
    }
  }
}

void gather_nets(const model::Model& model, const Discretisation& scene, const StepState& state,
                 results::LoadStepResult& out) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<results::ForceBalance> nets(model.nets.size());
  std::vector<bool> used(model.nets.size(), false);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    used[mesh.element_net[e].index()] = true;
    nets[mesh.element_net[e].index()].energy += state.energy[e];
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    add_node(nets[mesh.node_net[n].index()], state, base::NodeId(n), mesh.dim);
  }
  for (std::size_t n = 0; n < nets.size(); ++n) {
    nets[n].body = model.nets[n].name.empty() ? "(deck)" : model.nets[n].name;
    if (model::is_axisymmetric(model)) {
      drop_radial(nets[n]);
    }
    if (used[n]) {
      out.nets.push_back(nets[n]);
    }
  }
}

} // namespace

results::LoadStepResult collect_step_results(const model::Model& model, const Discretisation& scene,
                                             const std::vector<SubstructuredBody>& bodies,
                                             const model::Step& step, const StepState& state) {
  results::LoadStepResult out;
  out.step = step.name;
  out.u = state.u;
  out.reaction = state.reaction;
  out.temperature = state.temperature;
  out.energy = std::accumulate(state.energy.begin(), state.energy.end(), 0.0);
  out.tied = state.tie.size() > 0;
  out.increments = state.increments;
  out.iterations = state.iterations;
  out.pivots = state.pivots;
  out.notes = state.notes;
  evaluate_fronts(model, scene, state, out);
  recover_contacts(scene, state, out);
  gather_bodies(model, scene, bodies, state, out);
  gather_nets(model, scene, state, out);
  gather_targets(model, out, out.targets);
  warn_of_large_deformation(model, scene, bodies, state, out);
  warn_of_large_slip(model, scene, bodies, state, out);
  warn_of_body_overlaps(model, scene, bodies, state, out);
  return out;
}

} // namespace spricka::analysis
