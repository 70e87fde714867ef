// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/length_solver.hpp"

#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/shown_results.hpp"
#include "analysis/lengths/step_sequence.hpp"
#include "base/parallel.hpp"
#include "base/tidy.hpp"
#include "growth/section_limit.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

std::size_t unknowns(const std::vector<SubstructuredBody>& bodies) {
  std::size_t n = 0;
  for (const SubstructuredBody& body : bodies) {
    n += body.region.map.freedom.size();
    for (const std::unique_ptr<Substructure>& part : body.parts) {
      // Externals of a part are unknowns of the region already.
      n += static_cast<std::size_t>(part->map.locals);
    }
  }
  return n;
}

// By front in space, with SFLOW: force and moments of the section before it at the growth's largest
// load, over their plastic limit.
std::vector<double> section_load_ratios(const model::Model& model, const Discretisation& scene,
                                        const results::CrackLengthResult& increment) {
  std::vector<double> ratios;
  if (!model.growth || !model.growth->flow_stress) {
    return ratios;
  }
  for (const mesh::CrackFront& front : scene.cracked.fronts) {
    if (!front.is_tip()) {
      ratios.push_back(growth::plastic_load_ratio(
          {model, scene.cracked, *scene.ties, scene.cls}, front,
          increment.steps[largest_load_step(model)].u, *model.growth->flow_stress));
    }
  }
  return ratios;
}

// Takes K of faces that may overlap from the first solution of a state whose faces meet, where the
// law wants it.
std::optional<OverlappingFaceResults> take_overlap_results(const model::Model& model,
                                                           results::CrackLengthResult& increment) {
  const bool whole = increment.steps.size() == model.steps.size();
  if (!whole || !continues_K_below_closing(model)) {
    return std::nullopt;
  }
  OverlappingFaceResults free;
  for (results::LoadStepResult& step : increment.steps) {
    free.steps.push_back(std::move(step.fronts));
  }
  free.paths = std::move(increment.paths);
  return free;
}

} // namespace

CrackLengthContext CrackStateSolver::parts() {
  const bool keep = model_.growth && model_.growth->mounted == model::ContactMountingPolicy::first;
  return {.model = grown_ ? *grown_ : model_,
          .cache = cache_,
          .threads = options_.threads,
          .mounted = keep ? &mounted_ : nullptr,
          .contact = &contact_,
          .modes = model_.growth ? &modes_ : nullptr,
          .condensing = options_.condensing,
          .engine = options_.engine};
}

std::optional<results::CrackLengthResult> CrackStateSolver::solve(const CrackStateRequest& request,
                                                                  CrackRegionPlan& plan) {
  const base::ThreadShare share(options_.threads);
  LogWriter log(log_, options_.recorder);
  const double a = request.a;
  if (!request.cracks.solids.empty()) {
    if (!grown_) {
      grown_.emplace(model_);
    }
    grown_->cracks = request.cracks.solids;
  }
  std::unique_ptr<CrackLengthAnalysis> length =
      CrackLengthAnalysis::create(parts(), request.cracks.lines, plan, diagnostics_);
  if (!length) {
    return std::nullopt;
  }
  base::return_free_memory_to_system();
  const Discretisation& cut = length->discretisation();
  const double first = length->first_crack_size();
  // Fronts that K shapes are told by their stations.
  const double reported = a > 0.0 ? a : request.cracks.solids.empty() ? first : 0.0;
  log.add_line("TOPOLOGY",
               fmt::format("{}{} nodes, {} elements, {} contact rows, {}",
                           reported > 0.0 ? fmt::format("a = {:.6g}: ", reported) : "",
                           cut.cracked.mesh.node_count(), cut.cracked.mesh.element_count(),
                           cut.table.size(), describe_fronts(cut)));
  report_stage("meshed");
  results::CrackLengthResult increment;
  std::vector<std::size_t> touching;
  free_.reset();
  // Each round but the last makes a pair of one crack at least: there are no more rounds than
  // cracks and one.
  do {
    std::vector<std::string> news;
    if (!condense(*length, log, news)) {
      return std::nullopt;
    }
    report_stage("condensed");
    increment = {};
    increment.a = a > 0.0 ? a : base::restore_short_decimal(first);
    news.insert(news.begin(), cut.notes.begin(), cut.notes.end());
    increment.notes = results::make_plain_notes(news);
    StepSequence steps({.model = model_,
                        .options = options_,
                        .pictured = request.pictured,
                        .bars = request.bars && options_.error_bars,
                        .sensitivities = request.sensitivities,
                        .passes_overlap = continues_K_below_closing(model_) && !free_,
                        .contact = contact_,
                        .log = log},
                       *length);
    next_carried_ = carried_;
    trouble_ = steps.solve(increment, next_carried_);
    if (trouble_) {
      return std::nullopt;
    }
    if (steps.load_history()) {
      followed_ = std::move(steps.load_history());
    }
    touching = steps.cracks_with_overlapping_faces();
    // Of tips alone: the law is given K_min = 0 of fronts in space whose faces touch.
    if (!touching.empty() && !free_ && cut.has_tips()) {
      free_ = take_overlap_results(model_, increment);
    }
    close_faces(touching, *length, log);
  } while (!touching.empty());
  increment.unknowns = unknowns(length->bodies());
  divided_ = std::ranges::any_of(length->bodies(),
                                 [](const SubstructuredBody& body) { return !body.parts.empty(); });
  Discretisation scene = CrackLengthAnalysis::take_discretisation(std::move(length));
  fronts_ = scene.cracked.fronts;
  plastic_ = section_load_ratios(model_, scene, increment);
  // From here on what was mounted stands, for MOUNTED=FIRST.
  first_ = false;
  add_shown_results(model_, scene, increment);
  log.record_in_profile("RECOVER", "surface, results of the nodes that the patches took");
  return increment;
}

bool CrackStateSolver::condense(CrackLengthAnalysis& length, LogWriter& log,
                                std::vector<std::string>& news) {
  CondensationStatistics figures;
  const bool condensed = length.condense(figures);
  std::vector<std::string> engines;
  for (const results::NetCost& net : figures.nets) {
    if (!net.engine.empty() && !net.reused) {
      engines.push_back(fmt::format("{}: {}", net.name, net.engine));
      // In core without a word but where another engine has given the net up.
      if (net.engine.starts_with("Cholesky")) {
        news.push_back(fmt::format("{} was solved by {}", net.name, net.engine));
      }
    }
  }
  log.record_net_costs(std::move(figures.nets));
  if (!condensed) {
    trouble_ = figures.trouble;
    return false;
  }
  log.add_line(
      "CONDENSE",
      fmt::format("{} nets condensed, {} reused, {} unknowns, {:.3g} flops; stiffness {:.3f} "
                  "s, analysis {:.3f} s, numeric {:.3f} s",
                  figures.condensed, figures.reused, unknowns(length.bodies()), figures.flops,
                  figures.stiffness_cpu, figures.analysis_cpu, figures.numeric_cpu),
      figures.flops > 0.0 || figures.condensed == 0 ? std::optional(figures.flops) : std::nullopt);
  for (const std::string& concern : figures.inexact) {
    diagnostics_.warning({}, "W509", concern,
                         "what follows from them is no better: K, contact, life");
  }
  for (const std::string& given_up : news) {
    diagnostics_.note({}, "W510", given_up,
                      "the answer is as good; --engine cholesky spares the attempt");
  }
  for (const std::string& engine : engines) {
    log.add_line("CONDENSE", engine);
  }
  return true;
}

// Faces that would overlap are a pair from now on, and all steps are solved anew.
void CrackStateSolver::close_faces(const std::vector<std::size_t>& lines,
                                   CrackLengthAnalysis& length, LogWriter& log) {
  if (lines.empty()) {
    return;
  }
  length.add_face_contact(lines);
  const Discretisation& scene = length.discretisation();
  for (const std::size_t i : lines) {
    log.add_line("TOPOLOGY",
                 fmt::format("the faces of {} meet: solved anew with contact between them, {} rows",
                             model_.cracks[i].name,
                             scene.pairs[scene.crack_face_pairs[i]->pair].normal.size()));
  }
  if (first_) {
    mounted_ = MountOffsetMemory(); // of steps that do not count
  }
}

void CrackStateSolver::report_stage(std::string stage) const {
  if (options_.progress) {
    options_.progress({.stage = std::move(stage)});
  }
}

} // namespace spricka::analysis
