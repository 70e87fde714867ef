// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/kept_fronts.hpp"

#include "analysis/lengths/growth_records.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "analysis/lengths/resume.hpp"
#include "base/damaged_field.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Whether the faces of a crack touch at a tip, in a step or on a part of a path.
bool faces_close(const results::CrackLengthResult& increment) {
  const auto closed = [](const results::FrontResult& front) {
    return std::ranges::any_of(front.points, &results::FrontPointResult::closed);
  };
  const auto touch = [](const results::LoadPathFront& front) {
    return std::ranges::any_of(front.points, [](const results::LoadPathFrontPoint& point) {
      return faces_touch_on_path(point.smooth[0]);
    });
  };
  return std::ranges::any_of(increment.steps,
                             [&](const results::LoadStepResult& step) {
                               return std::ranges::any_of(step.fronts, closed);
                             }) ||
         std::ranges::any_of(increment.paths, [&](const results::LoadPathResult& path) {
           return std::ranges::any_of(path.fronts, touch);
         });
}

// The cracks that grew by another law, at a front that was kept; why they cannot be those of this
// growth goes to `why_not`.
std::optional<growth::CrackGeometry> cracks_of_earlier_growth(const growth::GrowthState& earlier,
                                                              growth::GrowthIntegrator& integrator,
                                                              std::string& why_not) {
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  if (!stations.empty() && !earlier.stations.empty() &&
      !(earlier.stations.back().s > stations.back().s)) {
    why_not = "the cracks cannot grow to it from the one before";
    return std::nullopt;
  }
  return integrator.go_to_cracks_of(earlier);
}

// The same of cracks whose size was given.
std::optional<growth::CrackGeometry>
cracks_of_given_size(double a, growth::GrowthIntegrator& integrator, std::string& why_not) {
  base::Diagnostics trouble;
  std::optional<growth::CrackGeometry> cracks = integrator.extend_cracks_to_size(a, trouble);
  if (!cracks) {
    why_not = trouble.messages().front().text;
  }
  return cracks;
}

} // namespace

std::string why_law_moves_fronts(const model::Model& model) {
  const model::CrackGrowthSettings& growth = *model.growth;
  if (model::has_friction(model)) {
    return "with friction its loads are followed one after another: K of other loads was not found";
  }
  if (growth.flow_stress) {
    return "with SFLOW it hangs on stresses that were not kept: without, its fronts serve another "
           "law";
  }
  if (std::ranges::any_of(model.tip_nets,
                          [](const auto& tip) { return tip.tolerance.has_value(); })) {
    return "with $TIPNET TOL its meshes hang on all fronts of a round";
  }
  return {};
}

std::string add_kept_front(const model::Model& model, const archive::StoredIncrement& kept,
                           GrowthRateEvaluator& measure, growth::GrowthIntegrator& integrator) {
  const bool first = integrator.growth_state().stations.empty();
  std::string why_not;
  const std::optional<growth::CrackGeometry> cracks =
      kept.state.reals.contains("station.s")
          ? cracks_of_earlier_growth(growth::growth_state_from_arrays(kept.state.reals), integrator,
                                     why_not)
          : cracks_of_given_size(kept.increment.a, integrator, why_not);
  if (!cracks) {
    return why_not;
  }
  const auto back = [&](std::string why) {
    integrator.go_back_to_last_station();
    return why;
  };
  if (continues_K_below_closing(model) && faces_close(kept.increment)) {
    return back("the law knows R < 0, and K with faces that overlap was not kept");
  }
  if (model.growth->spectrum &&
      kept.increment.paths.size() <= model.spectra[*model.growth->spectrum].path) {
    return back("K along the path of its spectrum was not kept");
  }
  // Fronts and sections are for SFLOW alone.
  const std::vector<mesh::CrackFront> no_fronts;
  const std::vector<double> no_sections;
  const std::optional<LoadHistoryKResult> no_history;
  const std::optional<OverlappingFaceResults> no_overlap;
  std::optional<std::vector<growth::TipStation>> found =
      measure.evaluate_tip_rates({kept.increment, no_fronts, no_sections, *cracks, no_history,
                                  no_overlap, growth_load_path(model, kept.increment)},
                                 integrator.tips(), integrator.trial_extents());
  if (!found) {
    return back(measure.trouble()->why);
  }
  if (first && !measure.spectrum() && measure.is_load_reversed()) {
    return back("K is larger at KMIN than at KMAX");
  }
  if (!integrator.accept_station_of_another_law(std::move(*found))) {
    return "the tips share the growth otherwise by the law now, which leads to other fronts: the "
           "cycles would be off by more than TOL";
  }
  return {};
}

std::optional<archive::StoredIncrement>
KeptFrontsOfAnotherLaw::take_over(growth::GrowthIntegrator& integrator,
                                  const std::function<PicturedSteps(int number)>& pictured) {
  archive::IncrementStore& checkpoint = *options_.checkpoint;
  std::optional<archive::StoredIncrement> last;
  for (int number = 1; !integrator.growth_end() && checkpoint.has_stored_increment(number);
       ++number) {
    std::optional<archive::StoredIncrement> kept =
        accept_stored_increment(model_, &checkpoint, number,
                                checkpoint.requested_length_of_increment(number), pictured(number));
    if (!kept) {
      break;
    }
    const std::string why_not = add_kept_front(model_, *kept, measure_, integrator);
    if (!why_not.empty()) {
      checkpoint.reject_increments_from(number, why_not);
      break;
    }
    if (last) {
      checkpoint.list_increment_of_another_law(number - 1, std::move(last->log));
    }
    measure_.warnings().restore_mesh_warnings(kept->state);
    last = append(std::move(*kept), integrator);
    report_resumed_increment(options_, run_, run_.increments.size() + 1);
  }
  return last;
}

// Its log tells of the station as the law before had it.
archive::StoredIncrement
KeptFrontsOfAnotherLaw::append(archive::StoredIncrement kept,
                               const growth::GrowthIntegrator& integrator) {
  std::erase_if(kept.log, [](const results::LogLine& line) {
    return line.processor == "GROW" && line.text.starts_with("station ");
  });
  archive::StoredIncrement rest{.increment = {},
                                .state = std::move(kept.state),
                                .log = {},
                                .cpu = kept.cpu,
                                .wall = kept.wall};
  const auto before = static_cast<std::ptrdiff_t>(run_.log.size());
  append_increment(std::move(kept), run_);
  LogWriter log(run_.log);
  log_last_station(integrator, log);
  rest.log.assign(run_.log.begin() + before, run_.log.end());
  return rest;
}

} // namespace spricka::analysis
