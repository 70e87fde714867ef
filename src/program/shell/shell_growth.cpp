// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/shell_growth.hpp"

#include "analysis/lengths/kept_fronts.hpp"
#include "analysis/lengths/solve_lengths.hpp"
#include "archive/checkpoint_list.hpp"
#include "base/hasher.hpp"
#include "model/model.hpp"
#include "program/shell/trouble.hpp"

#include <fmt/format.h>

namespace spricka::program {

namespace {

// All that rates hang on.
std::string text_of_growth_law(const model::Model& model) {
  base::Hasher hash;
  if (model.growth->spectrum) {
    const model::SpectrumDefinition& spectrum = model.spectra[*model.growth->spectrum];
    hash.value(spectrum.path);
    hash.value(spectrum.sequence);
    for (const double t : spectrum.turning_points) {
      hash.value(t);
    }
    for (const auto& [low, high, count] : spectrum.cycles) {
      hash.value(low);
      hash.value(high);
      hash.value(count);
    }
  }
  const auto [high, low] = hash.digest();
  return fmt::format("{} spectrum {:x} {:x}", archive::growth_settings_text(model), high, low);
}

/// Paths of fronts that are kept.
constexpr std::size_t most_front_paths = 16;

} // namespace

base::OptionalFailure ShellGrowth::grow_over(const model::Model& model,
                                             const base::SourceTexts& sources, FrontPath& path,
                                             GrowthOverFronts use) {
  path.fronts.begin_growth(use);
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  std::optional<results::RunResult> run = analysis::solve_run(
      model,
      {.threads = controls_.threads ? controls_.threads(model) : 1,
       .engine = controls_.engine ? controls_.engine(model) : base::EquationEngine::automatic,
       .checkpoint = &path.fronts,
       .stresses = false},
      diagnostics, trouble);
  solved_ = path.fronts.solved_count();
  if (run) {
    for (results::CrackLengthResult& increment : run->increments) {
      increment = archive::copy_fronts_of_increment(increment);
    }
    run->log.clear();
    result_ = std::move(run);
    return {};
  }
  if (diagnostics.has_errors()) {
    return located_failure(base::ProgramOutcome::deck_error, sources, diagnostics);
  }
  if (trouble->kind == base::ProgramOutcome::stopped) {
    trouble->why =
        fmt::format("stopped; {} fronts are solved and stay: grow goes on behind them", solved_);
  }
  return trouble;
}

// The newest path that serves to the end of the growth; else `best` is the one that serves longest.
bool ShellGrowth::grow_over_earlier_fronts(const model::Model& model,
                                           const base::SourceTexts& sources,
                                           const FrontPath*& best) {
  for (const std::unique_ptr<FrontPath>& path : paths_) {
    if (!grow_over(model, sources, *path, GrowthOverFronts::trial)) {
      return true;
    }
    if (best == nullptr || path->fronts.served_count() > best->fronts.served_count()) {
      best = path.get();
    }
  }
  return false;
}

base::OptionalFailure ShellGrowth::grow(const model::Model& model, const base::SourceTexts& sources,
                                        bool anew) {
  if (!model.growth || model.growth->law == model::CrackGrowthLaw::increment) {
    return invalid_input("the deck has no $GROW with a law of growth",
                         "$GROW LAW=PARIS KMAX=.. KMIN=.. C=.. M=.. KUNIT='MPa*m^0.5' AUNIT='m'");
  }
  if (result_ && !anew) {
    solved_ = 0;
    return {};
  }
  result_.reset();
  why_anew_.clear();
  if (anew) {
    paths_.clear();
  }
  const std::string law = text_of_growth_law(model);
  const std::array<double, 2> ends = archive::growth_length_and_cycle_limits(model);
  for (const std::unique_ptr<FrontPath>& path : paths_) {
    if (path->law == law && ends[0] >= path->ends[0] && ends[1] >= path->ends[1]) {
      path->ends = ends;
      return grow_over(model, sources, *path, GrowthOverFronts::goes_on);
    }
  }
  const FrontPath* best = nullptr;
  if (!paths_.empty()) {
    why_anew_ = analysis::why_law_moves_fronts(model);
    if (why_anew_.empty() && grow_over_earlier_fronts(model, sources, best)) {
      return {};
    }
  }
  // The path of an earlier law stays for others: this one goes on from a copy.
  const bool over_others = best != nullptr && best->fronts.served_count() > 0;
  if (best != nullptr) {
    why_anew_ = best->fronts.rejection_reason();
  }
  auto path = std::make_unique<FrontPath>(controls_.stopped);
  if (over_others) {
    path->fronts.copy_fronts(best->fronts);
  } else {
    path->law = law;
    path->ends = ends;
  }
  paths_.insert(paths_.begin(), std::move(path));
  if (paths_.size() > most_front_paths) {
    paths_.pop_back();
  }
  return grow_over(model, sources, *paths_.front(),
                   over_others ? GrowthOverFronts::another_law : GrowthOverFronts::goes_on);
}

} // namespace spricka::program
