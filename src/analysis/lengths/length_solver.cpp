// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/length_solver.hpp"

#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/error_bars.hpp"
#include "analysis/adjoint/sensitivities.hpp"
#include "analysis/recover/finite_results.hpp"
#include "analysis/recover/load_paths.hpp"
#include "analysis/recover/net_errors.hpp"
#include "analysis/recover/recover_step.hpp"
#include "analysis/scene/gone_nodes.hpp"
#include "analysis/steps/let_go.hpp"
#include "analysis/steps/lip_contact.hpp"
#include "analysis/steps/repeated_steps.hpp"
#include "base/clock.hpp"
#include "base/tidy.hpp"
#include "fe/stress.hpp"
#include "mesh/boundary.hpp"
#include "report/report.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

std::vector<bool> pictured_steps(const model::Model& model, bool last_increment) {
  std::vector<bool> pictured = asked_steps(model, last_increment);
  if (model.growth && model.growth->kmax.valid()) {
    pictured[model.growth->kmax.index()] = true;
  } else if (!pictured.empty()) {
    pictured.back() = true;
  }
  return pictured;
}

std::vector<bool> asked_steps(const model::Model& model, bool last_increment) {
  std::vector<bool> pictured(model.steps.size(), false);
  for (const model::Output& output : model.outputs) {
    const bool stress = std::any_of(output.requests.begin(), output.requests.end(),
                                    [](const auto& request) { return request.quantity == "S"; });
    if (output.format == model::OutputFormat::vtu || stress) {
      for (const std::size_t s : report::wanted_steps(model, output, last_increment)) {
        pictured[s] = true;
      }
    }
  }
  for (const model::Check& check : model.checks) {
    for (std::size_t s = 0; check.quantity == "ERROR" && s < model.steps.size(); ++s) {
      const auto* step = std::get_if<std::string>(&check.arguments.at(1));
      pictured[s] = pictured[s] || (step != nullptr && *step == model.steps[s].name);
    }
  }
  return pictured;
}

namespace {

std::vector<results::Stress> as_results(const std::vector<fe::Stress>& stress) {
  std::vector<results::Stress> out(stress.size());
  for (std::size_t n = 0; n < stress.size(); ++n) {
    std::copy_n(stress[n].data(), 6, out[n].begin());
  }
  return out;
}

std::vector<results::SurfaceFace> outer_surface(const model::Mesh& mesh) {
  std::vector<results::SurfaceFace> surface;
  if (mesh.dim != 3) {
    return surface;
  }
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    const base::ElementType type = mesh.type[face.element.index()];
    const std::span<const int> side = shape::side_nodes(type, face.side);
    results::SurfaceFace out;
    out.element = face.element;
    const std::size_t corners = shape::side_corners(type, face.side);
    const auto node = [&](std::size_t i) {
      return mesh.nodes_of(face.element)[static_cast<std::size_t>(side[i])];
    };
    for (std::size_t i = 0; i < corners; ++i) {
      out.outline.push_back(node(i));
      if (side.size() >= 2 * corners) {
        out.outline.push_back(node(corners + i));
      }
    }
    surface.push_back(std::move(out));
  }
  return surface;
}

bool rubs(const Scene& scene) {
  return std::ranges::any_of(scene.contacts,
                             [](const model::Contact& contact) { return contact.mu > 0.0; });
}

std::size_t unknowns(const std::vector<BodyNet>& bodies) {
  std::size_t n = 0;
  for (const BodyNet& body : bodies) {
    n += body.region.map.freedom.size();
    for (const std::unique_ptr<Net>& part : body.parts) {
      n += static_cast<std::size_t>(part->map.locals);
    }
  }
  return n;
}

void log_paths(const std::vector<results::LoadPath>& paths, LogWriter& log) {
  for (const results::LoadPath& path : paths) {
    if (path.t.empty()) {
      continue;
    }
    log.add("LOADPATH",
            fmt::format("path {}: {} breakpoints, {} pivots, {} factorisations, residual {:.1e}, K "
                        "of its steps to {:.1e}",
                        path.name, path.t.size() < 2 ? 0 : path.t.size() - 2, path.pivots,
                        path.factorisations, path.residual, path.mismatch));
  }
}

} // namespace

// Reports know nodes of sets but not of faces.
void add_face_nodes(const model::Model& model, model::Mesh& mesh) {
  for (const model::FaceSet& set : mesh.face_sets) {
    const bool wanted = std::ranges::any_of(model.outputs, [&](const model::Output& output) {
      return std::ranges::any_of(output.requests,
                                 [&](const auto& request) { return request.name == set.name; });
    });
    const bool there = std::ranges::any_of(
        mesh.node_sets, [&](const model::NodeSet& nodes) { return nodes.name == set.name; });
    if (wanted && !there && !set.name.empty()) {
      mesh.node_sets.push_back({set.name, mesh::nodes_of_faces(mesh, set.faces), set.span});
    }
  }
}

void add_stress(const model::Model& model, const model::Mesh& mesh, results::StepResult& step) {
  const fe::StateField field{step.u, step.temperature};
  std::vector<fe::Stress> nodal =
      fe::nodal_stress(model, mesh, fe::element_node_stress(model, mesh, field));
  fill_stresses(model, mesh, field, nodal);
  step.stress = as_results(nodal);
  step.element_stress = as_results(fe::mean_stress(model, mesh, field));
}

std::optional<results::Increment> LengthSolver::solve(const LengthRequest& request,
                                                      const RegionPlan& plan) {
  LogWriter log(log_);
  const double a = request.a;
  std::optional<Scene> scene = make_scene(model_, request.lines, plan, diagnostics_);
  if (!scene) {
    return std::nullopt;
  }
  base::return_free_memory();
  const std::string length =
      scene->cracked.tips.empty()
          ? ""
          : fmt::format("a = {:.6g}: ", a > 0.0 ? a : scene->cracked.tips.front().a);
  log.add("TOPOLOGY",
          fmt::format("{}{} nodes, {} elements, {} contact rows, {} tips", length,
                      scene->cracked.mesh.node_count(), scene->cracked.mesh.element_count(),
                      scene->table.rows.size(), scene->cracked.tips.size()));
  results::Increment increment;
  std::vector<std::size_t> touching;
  free_.reset();
  do {
    const std::optional<std::vector<BodyNet>> bodies = condense(*scene, log);
    if (!bodies) {
      return std::nullopt;
    }
    increment = {};
    increment.a =
        a > 0.0 || scene->cracked.tips.empty() ? a : base::tidy(scene->cracked.tips.front().a);
    increment.notes = scene->notes;
    touching.clear();
    if (!walk_steps({*scene, *bodies, request}, log, increment, touching)) {
      return std::nullopt;
    }
    keep_free(touching, increment);
    close_faces(touching, *scene, log);
  } while (!touching.empty());
  tips_ = scene->cracked.tips;
  first_ = false;
  increment.kept = static_cast<std::size_t>(
      std::ranges::count_if(scene->cracked.host, [](base::ElementId e) { return e.valid(); }));
  increment.mesh = std::move(scene->cracked.mesh);
  increment.surface = outer_surface(increment.mesh);
  const std::vector<GonePlace> gone = gone_places(model_.mesh, increment.mesh);
  for (results::StepResult& step : increment.steps) {
    fill_displacements(increment.mesh, gone, step.u);
  }
  keep_gone_members(model_.mesh, increment.mesh);
  add_face_nodes(model_, increment.mesh);
  return increment;
}

std::optional<std::vector<BodyNet>> LengthSolver::condense(const Scene& scene, LogWriter& log) {
  CondenseLog figures;
  std::vector<BodyNet> bodies =
      condense_bodies({model_, scene.cracked.mesh, scene.cls, scene.ties, scene.rest_element,
                       loads_with_supports(model_, scene), options_.threads},
                      cache_, figures);
  if (!figures.trouble.empty()) {
    refusal_ = Refusal{4, figures.trouble, {}};
    return std::nullopt;
  }
  log.add("CONDENSE",
          fmt::format("{} nets condensed, {} reused, {} unknowns, {:.3g} flops; stiffness {:.3f} "
                      "s, analysis {:.3f} s, numeric {:.3f} s",
                      figures.condensed, figures.reused, unknowns(bodies), figures.flops,
                      figures.stiffness_cpu, figures.analysis_cpu, figures.numeric_cpu));
  return bodies;
}

// Faces that would overlap are a pair from now on, and all steps are solved anew.
void LengthSolver::close_faces(const std::vector<std::size_t>& lines, Scene& scene,
                               LogWriter& log) {
  if (lines.empty()) {
    return;
  }
  add_lip_pairs(model_, lines, scene);
  for (const std::size_t i : lines) {
    log.add("TOPOLOGY",
            fmt::format("the faces of {} meet: solved anew with contact between them, {} rows",
                        model_.cracks[i].name,
                        scene.pairs[scene.lip_pairs[i]->pair].normal.size()));
  }
  if (first_) {
    mounted_ = MountMemory(); // of steps that do not count
  }
}

bool LengthSolver::follow(LoadHistory& history, StepSolver& solver, LogWriter& log) {
  next_carried_ = carried_;
  Refusal why;
  FollowedLoads loads;
  if (!history.follow(solver, next_carried_, loads, why)) {
    refusal_ = why;
    return false;
  }
  if (loads.none.empty()) {
    log.add("CONTACT", fmt::format("loads of the growth followed: {} passes, {} increments, K "
                                   "changes by {:.1e} in the last",
                                   loads.passes, loads.increments, loads.change));
  }
  followed_ = std::move(loads);
  return true;
}

bool LengthSolver::numbers_are_sound(const results::StepResult& result, const model::Step& step) {
  const std::string what = not_finite(result);
  if (!what.empty()) {
    refusal_ = Refusal{4, fmt::format("step {}: {}", step.name, what), step.span};
  }
  return what.empty();
}

// The first solution with faces that overlap is K of faces that may.
void LengthSolver::keep_free(const std::vector<std::size_t>& touching,
                             results::Increment& increment) {
  const bool whole = increment.steps.size() == model_.steps.size();
  if (touching.empty() || free_ || !whole || !continues_below_closing(model_)) {
    return;
  }
  free_.emplace();
  for (results::StepResult& step : increment.steps) {
    free_->steps.push_back(std::move(step.tips));
  }
  free_->paths = std::move(increment.paths);
}

// Stops at the first step with faces that would overlap: `touching` says which. Only where K of
// such faces is wanted the first solution goes on with them, without bars and pictures.
bool LengthSolver::walk_steps(const Way& way, LogWriter& log, results::Increment& increment,
                              std::vector<std::size_t>& touching) {
  const auto& [scene, bodies, request] = way;
  const bool keep = model_.growth && model_.growth->mounted == model::Mounted::first;
  StepSolver solver(model_, scene, bodies, keep ? &mounted_ : nullptr, &contact_);
  RepeatedSteps repeated(model_, request.pictured);
  LoadPaths paths(model_, scene, bodies);
  Adjoints adjoints(model_, scene, bodies);
  ErrorBars bars(model_, scene, model_.growth ? &modes_ : nullptr);
  Sensitivities sensitivities(model_, scene, bodies);
  LoadHistory history(model_, scene, bodies, paths);
  const bool follows = follows_history(model_);
  const bool goes_on = continues_below_closing(model_);
  log.add("CONTACT", "compliances of the contact rows");
  for (std::size_t s = 0; s < model_.steps.size(); ++s) {
    const model::Step& step = model_.steps[s];
    if (const std::size_t* earlier = repeated.of(s)) {
      repeated.take_over(s, solver, increment.steps);
      log.add("CONTACT", fmt::format("step {}: the same as step {}, taken over", step.name,
                                     model_.steps[*earlier].name));
      paths.keep(s, solver, increment.steps.back());
      continue;
    }
    if (std::vector<bool> start = contact_.start(scene, s, solver.closed()); !start.empty()) {
      solver.begin_from(std::move(start));
    }
    Refusal why;
    const std::optional<StepState> state = solver.solve(step, why);
    if (!state && !touching.empty()) {
      return true; // with faces that may overlap there is no answer
    }
    if (!state) {
      why.why = fmt::format("step {}: {}", step.name, why.why);
      why.why += let_go(model_, scene, bodies, step, why.why);
      refusal_ = why;
      return false;
    }
    log.add("CONTACT", fmt::format("step {}: {} iterations, {} pivots, imbalance {:.1e}", step.name,
                                   state->iterations, state->pivots, state->imbalance));
    if (!rubs(scene)) {
      contact_.keep(scene, s, solver.closed());
    }
    repeated.keep(s, solver);
    if (touching.empty()) {
      touching = touching_lines(model_, scene, state->u);
    }
    if (!touching.empty() && !(goes_on && !free_)) {
      return true;
    }
    increment.steps.push_back(gather_step(model_, scene, bodies, step, *state));
    if (!numbers_are_sound(increment.steps.back(), step)) {
      return false;
    }
    log.add("VCE", fmt::format("step {}: {} tips, pressures, balance", step.name,
                               scene.cracked.tips.size()));
    paths.keep(s, solver, increment.steps.back());
    if (follows) {
      history.keep(s, solver, increment.steps.back());
    }
    if (!touching.empty()) {
      continue;
    }
    if (!scene.cracked.tips.empty() && request.bars) {
      const std::vector<estimate::Adjoint>& of_K = adjoints.of_last_step(solver);
      log.add("ADJOINT", fmt::format("step {}: {} tips", step.name, of_K.size()));
      bars.add(*state, of_K, adjoints.held(), increment.steps.back());
      log.add("ESTIMATE", fmt::format("step {}: error bars of K", step.name));
      sensitivities.add(solver, *state, adjoints, increment.steps.back());
      log.add("SENSITIVITY", fmt::format("step {}: loads, fits, moduli, lengths", step.name));
    }
    if (request.pictured[s]) {
      add_stress(model_, scene.cracked.mesh, increment.steps.back());
      log.add("RECOVER", fmt::format("step {}: stresses", step.name));
      if (!numbers_are_sound(increment.steps.back(), step)) {
        return false;
      }
      add_errors(model_, scene, state->energy, increment.steps.back());
      log.add("ESTIMATE", fmt::format("step {}: energy error {:.1f} %", step.name,
                                      100.0 * increment.steps.back().errors.back().part));
    }
  }
  increment.paths = paths.follow(solver);
  for (const results::LoadPath& path : increment.paths) {
    if (const std::string what = not_finite(path); !what.empty()) {
      refusal_ = Refusal{4, fmt::format("load path {}: {}", path.name, what), {}};
      return false;
    }
  }
  if (!touching.empty()) {
    return true;
  }
  if (follows && !follow(history, solver, log)) {
    return false;
  }
  touching = paths.touching();
  if (!touching.empty()) {
    return true;
  }
  log_paths(increment.paths, log);
  return true;
}

} // namespace spricka::analysis
