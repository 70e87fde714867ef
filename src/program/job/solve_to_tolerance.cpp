// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/solve_to_tolerance.hpp"

#include "analysis/refine/refinement_plan.hpp"
#include "analysis/refine/wide_bars.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// A round leaves at least 0.3 of every size: eight rounds are more than any mesh can use.
constexpr int most_rounds = 8;

std::size_t unknowns(const results::RunResult& run) {
  std::size_t most = 0;
  for (const results::CrackLengthResult& increment : run.increments) {
    const std::vector<bool> used = model::mark_nodes_in_use(increment.mesh);
    const auto nodes = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    most = std::max(most, nodes * static_cast<std::size_t>(increment.mesh.dim));
  }
  return most;
}

// Bars against what is asked for; `why_not` where no mesh can give it.
results::ToleranceRound look_at(const model::Model& model, const results::RunResult& run,
                                std::string& why_not) {
  const analysis::ToleranceShortfall now = analysis::find_tolerance_shortfall(model, run);
  results::ToleranceRound round;
  round.unknowns = unknowns(run);
  round.worst = now.where;
  round.bar = now.bar;
  round.wanted = now.wanted;
  if (!now.no_bar.empty()) {
    why_not = "there is no error bar of " + now.no_bar;
  } else if (now.below_floor) {
    why_not = "TOL is smaller than the floor of the error bars";
  } else if (!now.parted.empty() && round.bar <= round.wanted) {
    why_not =
        "the error bars are within the tolerance, but two ways to compute K differ by more: " +
        now.parted;
  }
  return round;
}

// More freedoms than these no K needs: what asks for them has an error that finer
// meshes do not end.
constexpr double most_freedoms = 2e6;
// A round that leaves more than this of the bar has not helped.
constexpr double no_progress = 0.85;
constexpr double part_of_memory = 0.8; // that a run may take

std::string percent(double part) {
  return fmt::format("{:.3g} %", 100.0 * part);
}

// Why another round is not worth its while: the bar stands still, or falls so slowly that no mesh
// would do; empty: it is.
std::string no_use(const std::vector<results::ToleranceRound>& rounds) {
  const std::size_t n = rounds.size();
  if (n < 3) {
    return {};
  }
  const results::ToleranceRound& now = rounds[n - 1];
  const results::ToleranceRound& before = rounds[n - 3];
  const double left = now.bar / before.bar;
  const double grown = static_cast<double>(now.unknowns) / static_cast<double>(before.unknowns);
  if (left > no_progress && grown > 1.5) {
    return fmt::format(
        "finer meshes do not help: the error bar is {} with {} freedoms and was {} with {}",
        percent(now.bar), now.unknowns, percent(before.bar), before.unknowns);
  }
  // The bar falls with this power of the freedoms; where it hardly does the power is kept off zero.
  const double rate = -std::log(left) / std::log(std::max(grown, 1.1));
  const double needed = static_cast<double>(now.unknowns) *
                        std::pow(now.bar / now.wanted, 1.0 / std::max(rate, 0.02));
  if (needed > most_freedoms) {
    return fmt::format("the error bar falls too slowly: from {} to {} while freedoms grew from {} "
                       "to {}; more than {:.0e} freedoms would be needed",
                       percent(before.bar), percent(now.bar), before.unknowns, now.unknowns,
                       most_freedoms);
  }
  return {};
}

// Why the next mesh is too large to be solved: by its freedoms, or by the memory that the last one
// took; empty: it is not.
std::string too_large(const model::Model& now, const model::Model& next,
                      double patch_element_growth, const results::ToleranceRound& round) {
  const auto dim = static_cast<double>(now.mesh.dim);
  const double host = dim * static_cast<double>(now.mesh.node_count());
  // What the solved mesh has beyond its host are the patches.
  const double patches = std::max(0.0, static_cast<double>(round.unknowns) - host);
  const double freedoms =
      dim * static_cast<double>(next.mesh.node_count()) + patch_element_growth * patches;
  if (freedoms > most_freedoms) {
    return fmt::format("the next mesh would have some {:.1e} freedoms, at most {:.0e} are tried",
                       freedoms, most_freedoms);
  }
  // Fill grows a little faster than the freedoms.
  const double grown = std::max(1.0, freedoms / static_cast<double>(round.unknowns));
  const double bytes =
      static_cast<double>(base::peak_memory()) * grown * (1.0 + 0.1 * std::log2(grown));
  const auto machine = static_cast<double>(base::process_memory_limit());
  if (grown > 1.0 && bytes > part_of_memory * machine) {
    return fmt::format("the next mesh, of some {:.1e} freedoms, would take about {:.1f} of {:.1f} "
                       "GB of memory",
                       freedoms, bytes / 1e9, machine / 1e9);
  }
  return {};
}

// A force per node adds up to another total where its set has gained nodes: the case's name.
std::string case_that_grew(const model::Model& given, const model::Model& finer) {
  for (std::size_t c = 0; c < given.cases.size(); ++c) {
    for (std::size_t l = 0; l < given.cases[c].loads.size(); ++l) {
      const model::Load& load = given.cases[c].loads[l];
      if (load.type == model::LoadType::force &&
          given.mesh.set_with_id(load.nodes).nodes.size() !=
              finer.mesh.set_with_id(finer.cases[c].loads[l].nodes).nodes.size()) {
        return given.cases[c].name;
      }
    }
  }
  return {};
}

/// Models of a deck as it was given, of the last round and of the next.
struct Models {
  const model::Model& given;
  const model::Model& now;
  const model::Model& next;
};

// Why the next mesh is not solved; empty: it is.
std::string why_not_next(const Models& models, double patch_element_growth,
                         const results::ToleranceRound& round) {
  if (const std::string grew = case_that_grew(models.given, models.next); !grew.empty()) {
    return fmt::format("forces of load case {} stand on single nodes, of which a finer mesh "
                       "has more: use TYPE=RESULTANT or TRACTION",
                       grew);
  }
  return too_large(models.now, models.next, patch_element_growth, round);
}

} // namespace

bool has_k_tolerance(const model::Model& model) {
  return std::any_of(model.tip_nets.begin(), model.tip_nets.end(),
                     [](const model::TipMeshSettings& tip) { return tip.tolerance.has_value(); });
}

RefinedRun solve_to_tolerance(const CheckedDeck& deck, const RefinedDeckReader& read_finer,
                              const ModelSolveFunction& solve) {
  RefinedRun out;
  analysis::RefinementPlan plan(*deck.model);
  std::vector<results::ToleranceRound> rounds;
  std::optional<CheckedDeck> finer;
  for (int number = 1; out.why_not.empty(); ++number) {
    const base::Stopwatch watch;
    base::OptionalFailure trouble;
    std::optional<results::RunResult> run = solve(finer ? *finer->model : *deck.model, trouble);
    if (!run) {
      out.why_not = "a finer mesh has no solution: " + trouble->why;
      break;
    }
    out.run = std::move(run);
    // From here on the last round that has a solution is what stands.
    out.deck = std::move(finer);
    const model::Model& model = out.deck ? *out.deck->model : *deck.model;
    results::ToleranceRound& round = rounds.emplace_back(look_at(model, *out.run, out.why_not));
    round.number = number;
    round.cpu = watch.cpu_time();
    if (!out.why_not.empty() || round.bar <= round.wanted) {
      break;
    }
    out.why_not = no_use(rounds);
    if (!out.why_not.empty()) {
      break;
    }
    round.next = plan.refine_from_errors(model, *out.run);
    if (round.next.empty() || number == most_rounds) {
      out.why_not = round.next.empty() ? "no finer mesh would help"
                                       : fmt::format("{} rounds were not enough", most_rounds);
      break;
    }
    finer = read_finer(plan.refinements());
    if (!finer->model) {
      out.why_not = "the deck can't be meshed finer: " + finer->refusal.error;
      break;
    }
    out.why_not =
        why_not_next({*deck.model, model, *finer->model}, plan.patch_element_growth(), round);
    if (!out.why_not.empty()) {
      break;
    }
    // The deck read again knows nothing of the patches' own factors.
    plan.apply_to_model(*finer->model);
  }
  if (!rounds.empty()) {
    rounds.back().next = out.why_not.empty() ? "inside" : out.why_not;
    out.run->rounds = std::move(rounds);
  }
  return out;
}

} // namespace spricka::program
