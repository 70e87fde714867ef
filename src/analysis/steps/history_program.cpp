// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/history_program.hpp"

#include "model/model.hpp"
#include "model/spectrum_runs.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

bool mounts(const model::Step& step) {
  return std::ranges::any_of(step.actions, [](const model::StepAction& action) {
    return std::holds_alternative<model::MountContact>(action) ||
           std::holds_alternative<model::DismountContact>(action);
  });
}

// Loads and fits at t of a load path, 0 FROM to 1 TO; mounted as FROM is.
StepActionFactors on_path(const StepActionFactors& from, const StepActionFactors& to, double t) {
  StepActionFactors at = from;
  at.case_factor += t * (to.case_factor - from.case_factor);
  for (std::size_t c = 0; c < at.fit.size(); ++c) {
    at.fit[c] += t * (to.fit[c] - from.fit[c]);
  }
  return at;
}

GrowthLoadHistory of_spectrum(const model::Model& model,
                              const std::vector<StepActionFactors>& of_step,
                              const std::vector<int>& increments) {
  const model::SpectrumDefinition& card = model.spectra[*model.growth->spectrum];
  const model::LoadPathDefinition& path = model.load_paths[card.path];
  GrowthLoadHistory program;
  program.start = path.from.index();
  program.per_unit = increments[path.to.index()];
  double highest = -1.0;
  std::size_t mark = 0;
  for (const model::SpectrumBlock& run : model::divide_spectrum_into_blocks(card)) {
    RepeatedLoadSegment& leg =
        program.legs.emplace_back(RepeatedLoadSegment{{}, run.count, run.alone});
    for (const double t : run.t) {
      leg.places.push_back(
          {on_path(of_step[path.from.index()], of_step[path.to.index()], t), t, 0});
      // The cracks grow, and turn, at the largest load.
      if (t > highest) {
        highest = t;
        program.grow_at = mark;
      }
      ++mark;
    }
  }
  return program;
}

// From the first of the two steps on by the steps between to the second, and straight back.
GrowthLoadHistory of_steps(const model::Model& model, const std::vector<StepActionFactors>& of_step,
                           const std::vector<int>& increments) {
  const std::size_t high = model.growth->kmax.index();
  const std::size_t low = model.growth->kmin.index();
  const auto [first, last] = std::minmax(high, low);
  GrowthLoadHistory program;
  program.start = last;
  program.grow_at = high - first;
  program.smallest = low - first;
  RepeatedLoadSegment& leg = program.legs.emplace_back();
  int most = 1;
  for (std::size_t s = first; s <= last; ++s) {
    most = std::max(most, increments[s]);
    leg.places.push_back({of_step[s], 0.0, increments[s]});
    if (s > first && mounts(model.steps[s])) {
      program.none =
          fmt::format("step {} mounts or dismounts a contact between {} and {}",
                      model.steps[s].name, model.steps[first].name, model.steps[last].name);
    }
  }
  // The way back from the last step to the first goes in as many increments as any step needs.
  leg.places.front().increments = most;
  return program;
}

} // namespace

bool depends_on_load_order(const model::Model& model) {
  return model.growth && model.growth->law != model::CrackGrowthLaw::increment &&
         model::has_friction(model);
}

GrowthLoadHistory make_growth_load_history(const model::Model& model,
                                           const std::vector<StepActionFactors>& of_step,
                                           const std::vector<int>& increments) {
  return model.growth->spectrum ? of_spectrum(model, of_step, increments)
                                : of_steps(model, of_step, increments);
}

} // namespace spricka::analysis
