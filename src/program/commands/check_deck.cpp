// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/check_deck.hpp"

#include "analysis/lengths/growth_loop.hpp"
#include "analysis/lengths/growth_rules.hpp"
#include "analysis/lengths/length.hpp"
#include "analysis/steps/held_modes.hpp"
#include "base/clock.hpp"
#include "base/exit_codes.hpp"
#include "base/memory.hpp"
#include "base/messages.hpp"
#include "base/printable.hpp"
#include "geometry/polyline.hpp"
#include "growth/crack_lines.hpp"
#include "mesh/quality.hpp"
#include "model/model.hpp"
#include "program/commands/sweep_deck.hpp"
#include "program/job/failures.hpp"
#include "program/job/geometry_report.hpp"
#include "program/job/point_record.hpp"
#include "program/job/ready_deck.hpp"
#include "program/job/standard_streams.hpp"
#include "program/preview/forecast.hpp"
#include "program/preview/preview_model.hpp"
#include "report/check_listing.hpp"
#include "sense/half_model.hpp"
#include "sense/load_totals.hpp"
#include "sense/mirrors.hpp"
#include "solve/one_thread.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Long enough for a clock, short enough for a prompt; where all else is rough, shorter.
constexpr double rate_seconds = 0.02;
constexpr double short_rate_seconds = 0.004;

/// How the cost of a deck is to be foretold.
enum class ForecastMethod { none, law, analysis };

// DA bounds how far the fastest tip goes between two stations, AMAX where the first one ends.
double stations_at_least(const model::Model& model, const std::vector<mesh::CrackLine>& lines) {
  const model::CrackGrowthSettings& growth = *model.growth;
  if (!growth.largest_advance || !growth.last_length || lines.empty()) {
    return 1.0;
  }
  double way = *growth.last_length;
  for (const mesh::CrackLine& line : lines) {
    if (growth::is_growing_crack(model, line.crack.index())) {
      way = std::min(way, *growth.last_length -
                              (line.embedded ? 0.5 : 1.0) * geometry::polyline_length(line.points));
    }
  }
  return std::max(1.0, std::ceil(way / *growth.largest_advance * (1.0 - 1e-9)));
}

std::string growth_words(const model::Model& model, double stations) {
  if (!analysis::grows_by_law(model)) {
    return {};
  }
  return stations > 1.0
             ? fmt::format(
                   "  a growth by a law: DA asks for at least {:.0f} stations like the first, "
                   "flops and CPU time are of that many\n",
                   stations)
             : "  a growth by a law: figures are of its first station, mostly there are some ten "
               "or "
               "more\n";
}

/// One deck's preview; what it finds wrong stays in its members.
class Previewer {
public:
  Previewer(const model::Model& model, int threads, solve::EquationEngine engine)
      : model_(model), threads_(threads), engine_(engine) {}

  /// Every length. Without a forecast only mistakes are looked for.
  void look(ForecastMethod method) {
    if (analysis::grows_by_law(model_)) {
      analysis::make_crack_kinematics(model_, diagnostics);
      if (!diagnostics.has_errors()) {
        if (const auto lines = growth::crack_lines(model_, 0.0, diagnostics)) {
          stations = stations_at_least(model_, *lines);
        }
      }
      if (diagnostics.has_errors()) {
        return;
      }
    }
    const std::vector<double> lengths = growth::growth_loop_crack_lengths(model_);
    analysis::CrackRegionPlan plan = analysis::plan_crack_region(model_, lengths, diagnostics);
    if (diagnostics.has_errors()) {
      return;
    }
    const bool exact = method == ForecastMethod::analysis;
    ForecastSettings settings{
        .threads = threads_, .rate = {}, .exact = exact, .several_lengths = lengths.size() > 1};
    if (method != ForecastMethod::none) {
      settings.rate = solve::measure_flop_rate(exact ? rate_seconds : short_rate_seconds);
    }
    CostForecast future(model_, settings);
    preview.flop_rate = settings.rate.measured;
    preview.exact = exact;
    analysis::CondensationCache cache; // stays empty: nothing is condensed
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const base::Stopwatch watch;
      model::Model sized = model_;
      sized.cracks = growth::resize_solid_cracks(model_, lengths[i]);
      const std::unique_ptr<analysis::CrackLengthAnalysis> length =
          analysis::CrackLengthAnalysis::create(
              {.model = sized, .cache = cache, .threads = threads_, .engine = engine_}, lengths[i],
              plan, diagnostics);
      if (!length) {
        return;
      }
      const double scene_cpu = watch.cpu_time();
      length->number_freedoms();
      const analysis::Discretisation& scene = length->discretisation();
      if (i == 0) {
        look_closely(scene, length->bodies());
      }
      results::CrackLengthPreview figures = preview_mesh_at_crack_length(model_, scene);
      figures.number = static_cast<int>(i) + 1;
      if (method != ForecastMethod::none) {
        future.forecast_crack_length(length->condensation_request(), length->bodies(), scene,
                                     scene_cpu, figures);
      }
      preview.lengths.push_back(std::move(figures));
    }
  }

  results::DeckPreview preview;
  base::Diagnostics diagnostics;              ///< mistakes of cards
  std::vector<base::OperationFailure> unheld; ///< what the whole model shows
  double stations = 1.0;                      ///< that a growth by a law takes at least

private:
  // What does not change from length to length, or hardly: seen once.
  void look_closely(const analysis::Discretisation& scene,
                    const std::vector<analysis::SubstructuredBody>& bodies) {
    preview.nets = preview_nets(model_, scene);
    preview.quality = preview_mesh_quality(model_, scene);
    preview.inside_out = mesh::find_invalid_elements(scene.cracked.mesh).size();
    preview.pairs = preview_contact_pairs(scene);
    preview.bodies = analysis::rigid_mode_support(model_, scene, bodies);
    preview.loads = sense::compute_load_totals(model_);
    preview.mirrors = sense::find_symmetry_planes(model_);
    for (results::SymmetryPlanePreview& mirror : preview.mirrors) {
      mirror.no_half = mirror.against.empty() ? sense::half_model_obstacle(model_, mirror) : "";
    }
    unheld = analysis::unsupported_loads(model_, scene, bodies);
  }

  const model::Model& model_;
  int threads_;
  solve::EquationEngine engine_;
};

base::ProgramOutcome verdict(const base::SourceTexts& sources, const Previewer& found,
                             const Log& log) {
  base::Diagnostics all = found.diagnostics;
  for (const base::OperationFailure& load : found.unheld) {
    all.error(load.span, "E510", load.why, failure_remedy(load));
  }
  log.report_diagnostics(sources, all);
  return found.diagnostics.has_errors() ? base::ProgramOutcome::deck_error
         : !found.unheld.empty()        ? base::ProgramOutcome::not_solvable
                                        : base::ProgramOutcome::done;
}

// The points of a sweep, read and put together one after another.
base::ProgramOutcome check_points(const RunOptions& options, const CheckedDeck& deck,
                                  const Log& log, results::DeckPreview& preview) {
  base::ProgramOutcome worst = base::ProgramOutcome::done;
  if (deck.model->sweeps.empty()) {
    return worst;
  }
  const std::vector<SweepPointValues> points = sweep_points(*deck.model);
  base::Diagnostics reported = deck.diagnostics;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string words = sweep_point_text(points[i]);
    const CheckedDeck point = read_and_check_deck(
        options.deck, {.defines = options.defines, .sweep_values = points[i]}, log, &reported);
    for (const base::Diagnostic& d : point.diagnostics.messages()) {
      reported.warning(d.span, d.code, d.text); // of whatever severity
    }
    base::ProgramOutcome outcome = point.refusal.kind;
    if (point.model) {
      Previewer look(*point.model, 1, requested_engine(options, *point.model));
      look.look(ForecastMethod::none);
      outcome = verdict(point.sources, look, log);
    }
    if (outcome != base::ProgramOutcome::done) {
      log.report_message(
          base::Severity::error, "E550",
          fmt::format("point {:03} ({}): exit code {}", i + 1, words, base::exit_code(outcome)));
    }
    preview.sweep.push_back(words);
    worst = std::max(worst, outcome);
  }
  return worst;
}

void add_sums(double read_cpu, double stations, results::DeckPreview& preview) {
  preview.seconds = read_cpu;
  for (const results::CrackLengthPreview& length : preview.lengths) {
    preview.flops += stations * length.flops;
    preview.seconds += stations * length.seconds;
    preview.memory = std::max(preview.memory, length.memory);
  }
  preview.machine_memory = static_cast<double>(base::process_memory_limit());
}

// What no step before its own knows of, which a deck shows only by what it does not say.
void add_late_contacts(const model::Model& model, results::DeckPreview& preview) {
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const auto mounts = [&](const model::Step& step) {
      return std::ranges::any_of(step.actions, [&](const model::StepAction& action) {
        const auto* on = std::get_if<model::MountContact>(&action);
        return on != nullptr && on->contact == base::ContactId(c);
      });
    };
    const auto first = std::ranges::find_if(model.steps, mounts);
    if (first != model.steps.end() && first != model.steps.begin()) {
      preview.mounted_later.emplace_back(model.contacts[c].name, first->name);
    }
  }
}

} // namespace

base::ProgramOutcome check_deck(const RunOptions& options, const CheckedDeck& deck,
                                const Log& log) {
  const double read_cpu = base::cpu_seconds();
  const model::Model& model = *deck.model;
  const int threads = thread_count(options, model);
  try {
    solve::reserve_blas_workspace(threads); // as the run does: what is left decides who solves
  } catch (const std::bad_alloc&) {         // the run will say so
  }
  Previewer look(model, threads, requested_engine(options, model));
  look.look(options.exact_forecast ? ForecastMethod::analysis : ForecastMethod::law);
  const base::ProgramOutcome own = verdict(deck.sources, look, log);
  results::DeckPreview& preview = look.preview;
  preview.deck = base::make_printable(options.deck.string());
  preview.title = model.title;
  preview.units = model.units;
  preview.dim = model.mesh.dim;
  preview.geometry = report_imported_geometry(deck.imported);
  for (const model::Step& step : model.steps) {
    preview.steps.push_back(step.name);
  }
  add_late_contacts(model, preview);
  if (!preview.lengths.empty()) {
    std::vector<std::string>& notes = preview.lengths.front().notes;
    notes.insert(notes.begin(), deck.flaws.begin(), deck.flaws.end());
  }
  for (const base::Diagnostic* d : base::messages_by_severity(deck.diagnostics)) {
    if (d->severity == base::Severity::warning) {
      preview.warnings.push_back(d->text);
    }
  }
  add_sums(read_cpu, look.stations, preview);
  const base::ProgramOutcome points =
      own == base::ProgramOutcome::done ? check_points(options, deck, log, preview) : own;
  const base::ProgramOutcome outcome = std::max(own, points);
  if (options.json) {
    write_to_stdout(report::deck_preview_json(preview, outcome));
  } else if (!options.quiet && !preview.lengths.empty()) {
    write_to_stdout(report::deck_preview_listing(preview));
    write_to_stdout(growth_words(model, look.stations));
    write_to_stdout(fmt::format("\n{}: {}\n", base::make_printable(options.deck.string()),
                                outcome == base::ProgramOutcome::done ? "no mistakes found"
                                                                      : "see the messages"));
  }
  return outcome;
}

std::string list_refused_geometry(const CheckedDeck& deck) {
  results::ReportedGeometry geometry = report_imported_geometry(deck.imported);
  geometry.scripts.clear();
  return report::imported_geometry_listing(geometry, base::OutputUnit{deck.imported.length_name});
}

} // namespace spricka::program
