// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_loop.hpp"

#include "analysis/adjoint/error_bars_base.hpp"
#include "analysis/lengths/compared_lives.hpp"
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/growth_records.hpp"
#include "analysis/lengths/growth_region.hpp"
#include "analysis/lengths/growth_rules.hpp"
#include "analysis/lengths/kept_fronts.hpp"
#include "analysis/lengths/length_solver.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "analysis/lengths/pass_counter.hpp"
#include "analysis/lengths/pictured_steps.hpp"
#include "analysis/lengths/recorder.hpp"
#include "analysis/lengths/resume.hpp"
#include "analysis/lengths/shown_results.hpp"
#include "analysis/lengths/spectrum_parts.hpp"
#include "growth/advance_error.hpp"
#include "growth/crack_lines.hpp"
#include "growth/growth_integrator.hpp"
#include "model/model.hpp"
#include "results/growth_end.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

bool asks_for_derivatives(const model::Model& model) {
  return std::ranges::any_of(model.checks, [](const model::ResultCheck& check) {
    return check.quantity.starts_with("DK");
  });
}

// Whether K has error bars at all stations: it is corrected by them, or they are asked for.
bool estimates_K(const model::Model& model) {
  return corrects_K(model) || asks_for_derivatives(model) ||
         std::ranges::any_of(model.tip_nets,
                             [](const auto& tip) { return tip.tolerance.has_value(); }) ||
         std::ranges::any_of(model.checks, [](const model::ResultCheck& check) {
           return check.quantity.find(".BAR") != std::string::npos;
         });
}

class GrowthLoop {
public:
  GrowthLoop(const model::Model& model, const SolveOptions& options, base::Diagnostics& diagnostics,
             base::OptionalFailure& trouble, results::RunResult& run)
      : model_(model), options_(options), diagnostics_(diagnostics), trouble_(trouble), run_(run),
        measure_(model), solver_(model, options, run.log, trial_, trial_trouble_),
        on_the_way_(options.stresses
                        ? steps_with_requested_stresses(model, false)
                        : PicturedSteps{std::vector<bool>(model.steps.size(), false)}) {}

  bool run() {
    std::unique_ptr<growth::CrackKinematics> kinematics =
        make_crack_kinematics(model_, diagnostics_);
    if (!kinematics) {
      return false;
    }
    const bool of_another_law =
        options_.checkpoint != nullptr && options_.checkpoint->is_of_another_law();
    const std::optional<results::NamedArrays> kept =
        of_another_law ? std::nullopt : take_over_kept();
    growth::GrowthIntegrator integrator = restore_or_report_damage([&] {
      return growth::GrowthIntegrator(
          model_, measure_.rates_between_stations(), std::move(kinematics),
          kept ? state_from(*kept) : growth::GrowthState(), extent_after_passes());
    });
    RecondensedGrowthRegion region(model_);
    if (kept) {
      restore_or_report_damage([&] { region.restore_state(*kept); });
    }
    mark_.emplace(run_.log);
    tell_progress("read");
    if (of_another_law) {
      restore_or_report_damage([&] { measure_kept(integrator, region); });
    }
    while (!integrator.growth_end()) {
      if (is_time_up(options_.checkpoint, trouble_)) {
        return false;
      }
      // Mistakes of a state that is tried count only if it is the first.
      trial_ = {};
      const std::optional<growth::CrackGeometry> next = next_state(integrator, region);
      if (integrator.growth_end()) {
        break;
      }
      if (!(next && station(*next, region, integrator))) {
        // Nothing shorter than the first state could be tried: what is wrong with it is the deck's.
        if (run_.increments.empty()) {
          diagnostics_ = std::move(trial_);
          trouble_ = trial_trouble_;
          return false;
        }
        if (integrator.growth_end()) {
          break;
        }
        const std::string why = why_not_solved();
        integrator.shorten_step(why);
        LogWriter(run_.log).add_line("GROW", fmt::format("a shorter advance: {}", why));
        trial_trouble_.reset();
      }
    }
    finish(integrator);
    return true;
  }

private:
  // Where cycles act on each other the passes are not those of the stations' rates.
  [[nodiscard]] growth::ExtentAfterCycles extent_after_passes() const {
    if (!measure_.interaction()) {
      return {};
    }
    return [this](const std::vector<growth::SolvedStation>& stations, double passes) {
      return PassCounter(*measure_.spectrum(), *measure_.interaction())
          .extent_after_passes(stations, passes);
    };
  }

  // Stations of an earlier run; the state behind the last of them.
  std::optional<results::NamedArrays> take_over_kept() {
    const ScopedProfileInterval span(options_.checkpoint != nullptr ? options_.recorder : nullptr,
                                     "RESTART", "stations of an earlier run");
    std::optional<results::NamedArrays> state;
    for (int number = 1;; ++number) {
      std::optional<archive::StoredIncrement> kept =
          accept_stored_increment(model_, options_.checkpoint, number, 0.0, pictured_at(number));
      if (!kept) {
        return state;
      }
      state = std::move(kept->state);
      append_increment(std::move(*kept), run_);
      report_resumed_increment(options_, run_, run_.increments.size() + 1);
    }
  }

  // Fronts of a run by another law, until the growth by this one ends or one does not serve.
  void measure_kept(growth::GrowthIntegrator& integrator, RecondensedGrowthRegion& region) {
    const ScopedProfileInterval span(options_.recorder, "RESTART", "K of an earlier run");
    KeptFrontsOfAnotherLaw fronts(model_, options_, measure_, run_);
    std::optional<archive::StoredIncrement> last =
        fronts.take_over(integrator, [&](int number) { return pictured_at(number); });
    if (last) {
      solver_.restore_state(last->state);
      region.restore_state(last->state);
      options_.checkpoint->store_last_of_another_law({run_.increments.back(),
                                                      state_of(integrator, region),
                                                      std::move(last->log), last->cpu, last->wall});
    }
    mark_.emplace(run_.log);
  }

  growth::GrowthState state_from(const results::NamedArrays& arrays) {
    solver_.restore_state(arrays);
    measure_.restore_state(arrays);
    return growth::growth_state_from_arrays(arrays.reals);
  }

  [[nodiscard]] results::NamedArrays state_of(const growth::GrowthIntegrator& integrator,
                                              const RecondensedGrowthRegion& region) const {
    results::NamedArrays state;
    state.reals = growth::growth_state_to_arrays(integrator.growth_state());
    solver_.save_state(state);
    region.save_state(state);
    measure_.save_state(state);
    return state;
  }

  void keep(const growth::GrowthIntegrator& integrator, const RecondensedGrowthRegion& region) {
    mark_->store_increment(options_.checkpoint, 0.0, run_.increments.back(),
                           state_of(integrator, region));
    mark_.emplace(run_.log);
  }

  [[nodiscard]] PicturedSteps pictured_at(int number) const {
    return number == 1 ? pictured_at_end(false) : on_the_way_;
  }

  // Of the first increment, or of the last.
  [[nodiscard]] PicturedSteps pictured_at_end(bool last) const {
    return options_.stresses ? steps_with_stress_recovery(model_, run_.increments, last)
                             : on_the_way_;
  }

  // Where to solve next; empty: no state can be made there.
  std::optional<growth::CrackGeometry> next_state(growth::GrowthIntegrator& integrator,
                                                  RecondensedGrowthRegion& region) {
    const ScopedProfileInterval span(options_.recorder, "GROW", "where to solve next");
    std::optional<growth::CrackGeometry> next = integrator.propose_next_cracks(trial_);
    if (next && next->solids.empty() && !integrator.growth_end()) {
      region.update_region(next->lines, integrator, run_.log);
    }
    return next;
  }

  // Solves, measures, and lets the integrator judge; false: not solvable there.
  bool station(const growth::CrackGeometry& cracks, RecondensedGrowthRegion& region,
               growth::GrowthIntegrator& integrator) {
    const bool first = integrator.growth_state().stations.empty();
    ScopedProfileCrackLength length(options_.recorder);
    std::optional<results::CrackLengthResult> increment =
        solver_.solve({cracks, 0.0, first ? pictured_at_end(false) : on_the_way_,
                       first || estimates_K(model_), first || asks_for_derivatives(model_)},
                      region.crack_region_plan());
    if (!increment) {
      return false;
    }
    length.set_length(increment->a);
    const ScopedProfileInterval span(options_.recorder, "GROW",
                                     "station measured, judged and kept");
    region.log_region_cost(solver_.bodies_are_divided(), run_.log);
    LogWriter log(run_.log);
    std::optional<std::vector<growth::TipStation>> found = measure_.evaluate_tip_rates(
        {*increment, solver_.crack_fronts(), solver_.plastic_load_ratios(), cracks,
         solver_.load_history(), solver_.overlap_results(), growth_load_path(model_, *increment)},
        integrator.tips(), integrator.trial_extents());
    if (!found) {
      trial_trouble_ = measure_.trouble();
      return false;
    }
    if (first && !measure_.spectrum() && measure_.is_load_reversed()) {
      trial_.error(model_.growth->span, "E453",
                   fmt::format("K of {} is larger at KMIN, {:.6g}, than at KMAX, {:.6g}",
                               integrator.tips().front().name, found->front().K_min,
                               found->front().K_max),
                   "KMAX names the step with the largest K, KMIN that with the smallest");
      return false;
    }
    // True all the same: the integrator has noted that it went too far and asks for a nearer state.
    if (!integrator.accept_or_reject_station(std::move(*found))) {
      const std::string where =
          cracks.solids.empty() ? fmt::format("a = {:.6g}", increment->a) : "this front";
      log.add_line("GROW", where + " lies too far ahead for the tolerance: solved again nearer");
      return true;
    }
    // Only a state that counts hands its slips and mountings on.
    solver_.accept_solved_state();
    length.mark_increment();
    increment->number = static_cast<int>(run_.increments.size()) + 1;
    const growth::SolvedStation& here = integrator.growth_state().stations.back();
    set_front_sizes_from_first_tips(model_, cracks, integrator.tips(), here, *increment);
    length.set_length(increment->a);
    run_.increments.push_back(std::move(*increment));
    log_last_station(integrator, log);
    hand_on_warnings();
    keep(integrator, region);
    tell_progress("");
    return true;
  }

  // That a stage is done; empty: an increment is.
  void tell_progress(std::string stage) const {
    if (options_.progress) {
      options_.progress({.increment = run_.increments.size(),
                         .increments = run_.increments.size() + 1,
                         .open_end = true,
                         .stage = std::move(stage)});
    }
  }

  // Of a state that counts.
  void hand_on_warnings() {
    for (const base::Diagnostic& d : trial_.messages()) {
      if (d.severity == base::Severity::warning) {
        measure_.warnings().keep_first_mesh_warning(d.code, d.text, run_.increments.size());
      }
    }
  }

  [[nodiscard]] std::string why_not_solved() const {
    if (trial_trouble_) {
      return trial_trouble_->why;
    }
    for (const base::Diagnostic& d : trial_.messages()) {
      if (d.severity == base::Severity::error) {
        return d.text;
      }
    }
    return "no mesh";
  }

  void finish(const growth::GrowthIntegrator& integrator) {
    const ScopedProfileInterval span(options_.recorder, "GROW", "lives");
    results::CrackLengthResult& last = run_.increments.back();
    const std::vector<bool> pictured = pictured_at_end(true).known;
    for (std::size_t s = 0; s < last.steps.size(); ++s) {
      // Which station is the last is known only now.
      if (pictured[s] && last.steps[s].stress.empty()) {
        add_stress_fields(model_, last.mesh, last.steps[s]);
      }
    }
    run_.growth = growth_records(model_, integrator, measure_);
    run_.growth->spectrum_parts = find_spectrum_parts(model_, run_, integrator, measure_);
    run_.growth->compared = lives_by_other_interactions(model_, integrator, measure_);
    std::ranges::move(lives_by_proportional_K(model_, run_, integrator, measure_),
                      std::back_inserter(run_.growth->compared));
    LogWriter(run_.log).add_line(
        "GROW", fmt::format("{}: {}; {} stations, {} solutions did not count", run_.growth->ended,
                            run_.growth->reason, integrator.growth_state().stations.size(),
                            integrator.growth_state().rejected));
    std::ranges::copy(measure_.warnings().all(), std::back_inserter(run_.warnings));
    for (std::string& text : describe_life_concerns(*run_.growth)) {
      run_.warnings.push_back({"W456", std::move(text)});
    }
    if (std::string outside = describe_use_outside_data(*run_.growth, model_); !outside.empty()) {
      run_.warnings.push_back({"W576", std::move(outside)});
    }
    if (options_.checkpoint != nullptr && options_.checkpoint->is_of_another_law() &&
        run_.growth->error > growth::largest_error_over_tolerance * model_.growth->tolerance) {
      run_.warnings.push_back(
          {"W456", fmt::format("the fronts taken over were set for another law or spectrum: cycles "
                               "may be off by {:.1e}, above TOL={:.1e}; a growth from the start "
                               "sets its own",
                               run_.growth->error, model_.growth->tolerance)});
    }
    if (results::growth_could_not_continue(*run_.growth)) {
      run_.warnings.push_back({"W456", "the growth ended early: " + run_.growth->reason});
    }
  }

  const model::Model& model_;
  const SolveOptions& options_;
  base::Diagnostics& diagnostics_;
  base::OptionalFailure& trouble_;
  results::RunResult& run_;
  base::Diagnostics trial_;             ///< of the state that is tried
  base::OptionalFailure trial_trouble_; ///< the same
  GrowthRateEvaluator measure_;
  CrackStateSolver solver_;
  PicturedSteps on_the_way_;
  std::optional<IncrementRecorder> mark_; ///< where the search for the next station began
};

} // namespace

bool grows_by_law(const model::Model& model) {
  return model.growth && model.growth->law != model::CrackGrowthLaw::increment &&
         !model.cracks.empty();
}

bool run_growth_by_law(const model::Model& model, const SolveOptions& options,
                       base::Diagnostics& diagnostics, base::OptionalFailure& trouble,
                       results::RunResult& run) {
  return GrowthLoop(model, options, diagnostics, trouble, run).run();
}

} // namespace spricka::analysis
