// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/recover_step.hpp"

#include "analysis/recover/body_overlap.hpp"
#include "analysis/recover/contact_limits.hpp"
#include "analysis/recover/gather_fronts.hpp"
#include "analysis/recover/judge_faces.hpp"
#include "analysis/recover/judge_size.hpp"
#include "analysis/recover/recover_contacts.hpp"
#include "analysis/scene/tip_name.hpp"
#include "analysis/scene/tip_surroundings.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "base/tidy.hpp"
#include "crack/load_jumps.hpp"
#include "crack/stress_intensity.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

const model::CrackExtensionSettings* vce_of(const model::Model& model, base::CrackId crack) {
  for (const model::CrackExtensionSettings& vce : model.vces) {
    if (vce.crack == crack) {
      return &vce;
    }
  }
  return nullptr;
}

void gather_tips(const model::Model& model, const Discretisation& scene, const StepState& state,
                 results::StepResult& out) {
  for (std::size_t t = 0; t < scene.cracked.fronts.size(); ++t) {
    const mesh::CrackFront& front = scene.cracked.fronts[t];
    const model::CrackDefinition& crack = model.cracks[front.crack.index()];
    crack::TipIntensityRequest request;
    request.state = crack.state;
    if (const model::CrackExtensionSettings* vce = vce_of(model, front.crack)) {
      request.shift = vce->shift;
      request.opening = vce->opening;
    }
    const std::optional<crack::CrackFaceForces> crack_faces =
        crack_face_forces(scene, front, state);
    request.crack_faces = crack_faces ? &*crack_faces : nullptr;
    const std::vector<crack::ExtensionField>& fields = scene.tips[t].fields;
    const crack::TipLoads loads = tip_loads(model, scene, fields, state.case_factor);
    const crack::StressIntensity K =
        crack::stress_intensity(model, scene.cracked, front, fields, request, state.u, loads);
    results::TipResult result;
    result.name = tip_name(model, scene.cracked, front);
    result.a = base::remove_round_off(front.a);
    result.x = front.tip_point().x;
    result.direction = front.tip_point().growth;
    result.K1 = K.K1;
    result.K2 = K.K2;
    result.G = K.G;
    result.G_from_K = K.G_from_K;
    result.spread = K.spread;
    result.T = K.T;
    result.K_opening = K.opening;
    std::vector<bool> discontinuous;
    if (!fields.empty()) {
      discontinuous =
          crack::load_jump_domains(crack::tip_setting(model, scene.cracked, front, fields, loads),
                                   fields, std::hypot(K.K1, K.K2));
    }
    for (std::size_t d = 0; d < K.domains.size(); ++d) {
      if (!discontinuous[d]) { // others are no measure of each other
        result.K1_domain.push_back(K.domains[d].K1);
      }
    }
    if (K.shift_error && std::abs(*K.shift_error) > 2e-5) { // of G; 1e-5 of K (crack.15)
      out.notes.push_back(results::less_exact_note(
          fmt::format("{}: G by the finite shift is {:+.2g} of the analytic "
                      "one off, and K by half of that: the shift is too "
                      "large or lost in round-off; leave SHIFT of $VCE out",
                      result.name, *K.shift_error)));
    }
    if (!K.domains.empty() && std::ranges::all_of(K.domains, [](const crack::DomainIntensity& d) {
          return std::isnan(d.G);
        })) {
      out.notes.push_back(
          results::note(fmt::format("{}: loads or temperatures jump within all domains of K, "
                                    "which leave G to K: it is (K1^2 + K2^2)/E'",
                                    result.name)));
    }
    result.two_materials = K.two_materials;
    check_crack_faces({model, scene, front, state, K}, result, out);
    out.tips.push_back(std::move(result));
  }
}

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
                   results::StepResult& out) {
  for (const SubstructuredBody& body : bodies) {
    results::ForceBalance balance;
    balance.body = body.name;
    for (const base::NodeId n : body.body.nodes) {
      add_node(balance, state, n, scene.cracked.mesh.dim);
    }
    for (const base::ElementId e : body.body.elements) {
      balance.energy += state.energy[e.index()];
    }
    if (model::axisymmetric(model)) {
      drop_radial(balance);
    }
    out.balance.push_back(balance);
  }
}

// What presses on a rigid target has to be taken by whatever holds it.
void gather_targets(const model::Model& model, const results::StepResult& found,
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
    if (model::axisymmetric(model)) {
      drop_radial(balance);
    }
    if (used) {
      targets.push_back(balance);
    }
  }
}

void gather_nets(const model::Model& model, const Discretisation& scene, const StepState& state,
                 results::StepResult& out) {
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
    if (model::axisymmetric(model)) {
      drop_radial(nets[n]);
    }
    if (used[n]) {
      out.nets.push_back(nets[n]);
    }
  }
}

} // namespace

results::StepResult collect_results(const model::Model& model, const Discretisation& scene,
                                    const std::vector<SubstructuredBody>& bodies,
                                    const model::Step& step, const StepState& state) {
  results::StepResult out;
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
  gather_tips(model, scene, state, out);
  evaluate_fronts(model, scene, state, out);
  recover_contacts(scene, state, out);
  gather_bodies(model, scene, bodies, state, out);
  gather_nets(model, scene, state, out);
  gather_targets(model, out, out.targets);
  check_small_strain(model, scene, bodies, state, out);
  warn_of_large_slip(model, scene, bodies, state, out);
  warn_of_overlaps(model, scene, bodies, state, out);
  return out;
}

} // namespace spricka::analysis
