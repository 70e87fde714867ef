// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/kept_fronts.hpp"

#include "analysis/lengths/growth_records.hpp"
#include "analysis/lengths/growth_rules.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "analysis/lengths/resume.hpp"
#include "base/damaged_field.hpp"
#include "geometry/polyline.hpp"
#include "growth/crack_kinematics.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double same_length = 1e-6; // relative

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

// The arm of the only tip at a front that was kept: of its growth, or as it was given.
double arm_of(const archive::StoredIncrement& kept) {
  if (!kept.state.reals.contains("station.s")) {
    return kept.increment.a;
  }
  const growth::GrowthState state = growth::growth_state_from_arrays(kept.state.reals);
  if (state.stations.empty() || state.stations.back().tips.size() != 1) {
    throw base::CorruptStoredField("station_tip.a", "stations of other tips");
  }
  return state.stations.back().tips.front().a;
}

} // namespace

std::string why_law_moves_fronts(const model::Model& model) {
  const model::CrackGrowthSettings& growth = *model.growth;
  if (growth.direction != model::GrowthDirection::path) {
    return "K turns its crack, by advances that hang on the law: only on a given path "
           "(DIRECTION=PATH) do fronts serve another law";
  }
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
  base::Diagnostics unheard; // the growth itself tells what is wrong with its cracks
  const std::unique_ptr<growth::CrackKinematics> kinematics = make_crack_kinematics(model, unheard);
  if (kinematics && kinematics->tips().size() == 1 && kinematics->current_cracks().solids.empty()) {
    return {};
  }
  return "each of its tips grows by the law, so that another one leads to other fronts: those of "
         "one tip in the plane, on its path, serve any law";
}

std::string add_kept_front(const model::Model& model, const archive::StoredIncrement& kept,
                           GrowthRateEvaluator& measure, growth::GrowthIntegrator& integrator) {
  const double arm = arm_of(kept);
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const bool first = stations.empty();
  const double longest =
      model.growth->last_length.value_or(std::numeric_limits<double>::infinity());
  if (arm > longest * (1.0 + same_length)) {
    return fmt::format("AMAX is {:.6g}, it is for a = {:.6g}", longest, arm);
  }
  base::Diagnostics trouble;
  const std::optional<growth::CrackGeometry> cracks = integrator.extend_cracks_to({arm}, trouble);
  if (!cracks || (!first && !(arm > stations.back().tips.front().a))) {
    return fmt::format("the crack cannot grow to a = {:.6g} there", arm);
  }
  const double begin =
      geometry::polyline_length(cracks->lines[integrator.tips().front().line].points);
  if (first && std::abs(begin - arm) > same_length * arm) {
    return fmt::format("the growth begins at a = {:.6g}, it is for a = {:.6g}", begin, arm);
  }
  if (continues_K_below_closing(model) && faces_close(kept.increment)) {
    return "the law knows R < 0, and K with faces that overlap was not kept";
  }
  const std::optional<results::LoadPathResult> path =
      corrected_growth_load_path(model, kept.increment);
  // Fronts and sections are for SFLOW alone.
  const std::vector<mesh::CrackFront> no_fronts;
  const std::vector<double> no_sections;
  const std::optional<LoadHistoryKResult> no_history;
  const std::optional<OverlappingFaceResults> no_overlap;
  std::optional<std::vector<growth::TipStation>> found =
      measure.evaluate_tip_rates({kept.increment, no_fronts, no_sections, *cracks, no_history,
                                  no_overlap, path ? &*path : nullptr},
                                 integrator.tips());
  if (!found) {
    return measure.trouble()->why;
  }
  if (first && !measure.spectrum() && measure.is_load_reversed()) {
    return "K is larger at KMIN than at KMAX";
  }
  integrator.accept_station(std::move(*found));
  return {};
}

std::optional<archive::StoredIncrement>
KeptFrontsOfAnotherLaw::take_over(growth::GrowthIntegrator& integrator,
                                  const std::function<std::vector<bool>(int number)>& pictured) {
  archive::Checkpoint& checkpoint = *options_.checkpoint;
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
