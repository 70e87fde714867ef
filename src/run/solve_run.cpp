// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/solve_run.hpp"

#include "base/clock.hpp"
#include "fe/stress.hpp"
#include "growth/crack_lines.hpp"
#include "run/gather.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::run {

namespace {

class Log {
public:
  explicit Log(std::vector<results::LogLine>& lines) : lines_(lines) {}
  void add(const std::string& processor, const std::string& text) {
    lines_.push_back({processor, text, watch_.cpu(), watch_.wall()});
    watch_ = base::Stopwatch();
  }

private:
  std::vector<results::LogLine>& lines_;
  base::Stopwatch watch_;
};

// Only the steps that will be pictured carry stresses: KMAX of a growth run, else the last step;
// all when a VTU output asks for each step.
std::vector<bool> pictured_steps(const model::Model& model) {
  std::vector<bool> pictured(model.steps.size(), false);
  if (model.growth && model.growth->kmax.valid()) {
    pictured[model.growth->kmax.index()] = true;
  } else if (!pictured.empty()) {
    pictured.back() = true;
  }
  for (const model::Output& output : model.outputs) {
    if (output.format == model::OutputFormat::vtu && output.every == model::OutputEvery::step) {
      pictured.assign(pictured.size(), true);
    }
  }
  return pictured;
}

void add_stress(const model::Model& model, const model::Mesh& mesh, results::StepResult& step) {
  const std::vector<fe::Stress> nodal =
      fe::nodal_stress(model, mesh, fe::element_node_stress(model, mesh, step.u));
  step.stress.resize(nodal.size());
  for (std::size_t n = 0; n < nodal.size(); ++n) {
    for (std::size_t c = 0; c < 6; ++c) {
      step.stress[n][c] = nodal[n][static_cast<Eigen::Index>(c)];
    }
  }
}

/// What is carried from one crack length to the next.
struct Carried {
  RegionPlan plan;
  CondensationCache cache;
};

std::size_t unknowns(const std::vector<BodyNet>& bodies) {
  std::size_t n = 0;
  for (const BodyNet& body : bodies) {
    n += body.region.map.freedom.size();
    n += body.rest ? static_cast<std::size_t>(body.rest->map.locals) : 0;
  }
  return n;
}

std::optional<std::vector<BodyNet>> condense(const model::Model& model, Scene& scene,
                                             const SolveOptions& options, Carried& carried,
                                             Log& log, std::optional<Refusal>& refusal) {
  // A prescribed displacement loads the free freedoms by -K u.
  base::Matrix load = scene.case_load;
  std::vector<base::ElementId> all;
  for (std::size_t e = 0; e < scene.cracked.mesh.element_count(); ++e) {
    all.emplace_back(e);
  }
  for (Eigen::Index c = 0; c < load.cols(); ++c) {
    if ((scene.case_displacement.col(c).array() != 0.0).any()) {
      base::Vector pull = base::Vector::Zero(load.rows());
      fe::add_internal_force(model, scene.cracked.mesh, all, scene.case_displacement.col(c), pull);
      load.col(c) -= pull;
    }
  }
  CondenseLog figures;
  std::vector<BodyNet> bodies =
      condense_bodies({model, scene.cracked.mesh, scene.cls, scene.rest_element, load,
                       options.threads},
                      carried.cache, figures);
  if (!figures.trouble.empty()) {
    refusal = Refusal{4, figures.trouble, {}};
    return std::nullopt;
  }
  log.add("CONDENSE",
          fmt::format("{} nets condensed, {} reused, {} unknowns, {:.3g} flops; stiffness {:.3f} "
                      "s, analysis {:.3f} s, numeric {:.3f} s",
                      figures.condensed, figures.reused, unknowns(bodies), figures.flops,
                      figures.stiffness_cpu, figures.analysis_cpu, figures.numeric_cpu));
  return bodies;
}

std::optional<results::Increment> solve_increment(const model::Model& model, double a,
                                                  const SolveOptions& options, Carried& carried,
                                                  results::Run& run,
                                                  base::Diagnostics& diagnostics,
                                                  std::optional<Refusal>& refusal) {
  Log log(run.log);
  std::optional<Scene> scene = make_scene(model, a, carried.plan, diagnostics);
  if (!scene) {
    return std::nullopt;
  }
  base::return_free_memory();
  log.add("TOPOLOGY", fmt::format("a = {:.6g}: {} nodes, {} elements, {} contact rows, {} tips", a,
                                  scene->cracked.mesh.node_count(),
                                  scene->cracked.mesh.element_count(), scene->table.rows.size(),
                                  scene->cracked.tips.size()));
  const std::optional<std::vector<BodyNet>> bodies =
      condense(model, *scene, options, carried, log, refusal);
  if (!bodies) {
    return std::nullopt;
  }
  StepSolver solver(model, *scene, *bodies);
  log.add("CONTACT", "compliances of the contact rows");
  results::Increment increment;
  increment.a = a > 0.0 || scene->cracked.tips.empty() ? a : scene->cracked.tips.front().a;
  increment.notes = scene->notes;
  const std::vector<bool> pictured = pictured_steps(model);
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    Refusal why;
    const std::optional<StepState> state = solver.solve(model.steps[s], why);
    if (!state) {
      why.why = fmt::format("step {}: {}", model.steps[s].name, why.why);
      refusal = why;
      return std::nullopt;
    }
    log.add("CONTACT", fmt::format("step {}: {} iterations, {} pivots, imbalance {:.1e}",
                                   model.steps[s].name, state->iterations, state->pivots,
                                   state->imbalance));
    increment.steps.push_back(gather_step(model, *scene, *bodies, model.steps[s], *state));
    if (pictured[s]) {
      add_stress(model, scene->cracked.mesh, increment.steps.back());
    }
    log.add("VCE", fmt::format("step {}: {} tips, pressures, balance", model.steps[s].name,
                               scene->cracked.tips.size()));
  }
  increment.mesh = std::move(scene->cracked.mesh);
  return increment;
}

} // namespace

std::optional<results::Run> solve_run(const model::Model& model, const SolveOptions& options,
                                      base::Diagnostics& diagnostics,
                                      std::optional<Refusal>& refusal) {
  results::Run run;
  const base::Stopwatch watch;
  const std::vector<double> lengths = growth::crack_lengths(model);
  Carried carried{plan_region(model, lengths, diagnostics), {}};
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    std::optional<results::Increment> increment =
        solve_increment(model, lengths[i], options, carried, run, diagnostics, refusal);
    if (!increment) {
      return std::nullopt;
    }
    increment->number = static_cast<int>(i) + 1;
    run.increments.push_back(std::move(*increment));
    if (options.progress) {
      options.progress(i + 1, lengths.size());
    }
  }
  run.cpu = watch.cpu();
  run.wall = watch.wall();
  run.peak_memory = base::peak_memory();
  return run;
}

} // namespace spricka::run
