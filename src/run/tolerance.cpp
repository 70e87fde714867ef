// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/tolerance.hpp"

#include "base/clock.hpp"
#include "run/refinement_plan.hpp"
#include "run/wide_bars.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::run {

namespace {

// Each round takes at most a third of every size: eight are more than any mesh can use.
constexpr int most_rounds = 8;

std::size_t unknowns(const results::Run& run) {
  std::size_t most = 0;
  for (const results::Increment& increment : run.increments) {
    const std::vector<bool> used = model::nodes_in_use(increment.mesh);
    const auto nodes = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    most = std::max(most, nodes * static_cast<std::size_t>(increment.mesh.dim));
  }
  return most;
}

// Bars against what is asked for; `why_not` where no mesh can give it.
results::ToleranceRound look_at(const model::Model& model, const results::Run& run,
                                std::string& why_not) {
  const Shortfall now = shortfall(model, run);
  results::ToleranceRound round;
  round.unknowns = unknowns(run);
  round.worst = now.where;
  round.bar = now.bar;
  round.wanted = now.wanted;
  if (!now.no_bar.empty()) {
    why_not = "there is no error bar of " + now.no_bar;
  } else if (now.below_floor) {
    why_not = "TOL is smaller than the floor of the bars";
  } else if (!now.parted.empty() && round.bar <= round.wanted) {
    why_not = "the bars are inside, but two ways to K part by more: " + now.parted;
  }
  return round;
}

// A force per node adds up to another total where its set has gained nodes: the case's name.
std::string case_that_grew(const model::Model& given, const model::Model& finer) {
  for (std::size_t c = 0; c < given.cases.size(); ++c) {
    for (std::size_t l = 0; l < given.cases[c].loads.size(); ++l) {
      const model::Load& load = given.cases[c].loads[l];
      if (load.type == model::LoadType::force &&
          given.mesh.set(load.nodes).nodes.size() !=
              finer.mesh.set(finer.cases[c].loads[l].nodes).nodes.size()) {
        return given.cases[c].name;
      }
    }
  }
  return {};
}

} // namespace

bool wants_tolerance(const model::Model& model) {
  return std::any_of(model.tip_nets.begin(), model.tip_nets.end(),
                     [](const model::TipNet& tip) { return tip.tolerance.has_value(); });
}

ToleratedRun solve_to_tolerance(const ReadyDeck& deck, const ReadFiner& read_finer,
                                const SolveOnce& solve) {
  ToleratedRun out;
  RefinementPlan plan(*deck.model);
  std::vector<results::ToleranceRound> rounds;
  std::optional<ReadyDeck> finer;
  for (int number = 1; out.why_not.empty(); ++number) {
    const base::Stopwatch watch;
    std::string why;
    std::optional<results::Run> run = solve(finer ? *finer->model : *deck.model, why);
    if (!run) {
      out.why_not = "a finer mesh has no solution: " + why;
      break;
    }
    out.run = std::move(run);
    out.deck = std::move(finer);
    const model::Model& model = out.deck ? *out.deck->model : *deck.model;
    results::ToleranceRound& round = rounds.emplace_back(look_at(model, *out.run, out.why_not));
    round.number = number;
    round.cpu = watch.cpu();
    if (!out.why_not.empty() || round.bar <= round.wanted) {
      break;
    }
    round.next = plan.refine(model, *out.run);
    if (round.next.empty() || number == most_rounds) {
      out.why_not = round.next.empty() ? "no finer mesh would help"
                                       : fmt::format("{} rounds did not do", most_rounds);
      break;
    }
    finer = read_finer(plan.nets());
    if (!finer->model) {
      out.why_not = "the deck can't be meshed finer: " + finer->refusal.error;
      break;
    }
    if (const std::string grew = case_that_grew(*deck.model, *finer->model); !grew.empty()) {
      out.why_not =
          fmt::format("forces of load case {} stand on single nodes, of which a finer mesh "
                      "has more: use TYPE=RESULTANT or TRACTION",
                      grew);
      break;
    }
    plan.apply(*finer->model);
  }
  if (!rounds.empty()) {
    rounds.back().next = out.why_not.empty() ? "inside" : out.why_not;
    out.run->rounds = std::move(rounds);
  }
  return out;
}

} // namespace spricka::run
