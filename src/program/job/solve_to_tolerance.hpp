// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/ready_deck.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace spricka::program {

/// Whether some $TIPNET has TOL.
bool has_k_tolerance(const model::Model& model);

/// The deck read anew, with its meshes refined; without a model if it can't be read so.
using RefinedDeckReader =
    std::function<CheckedDeck(const std::map<std::string, deck::NetRefinement>&)>;

/// A run that was refined until every K with a tolerance has it, or why it ended before.
struct RefinedRun {
  std::optional<results::RunResult> run; ///< of the last round, its `rounds` filled; empty: refused
  std::optional<CheckedDeck> deck;       ///< what was solved; empty: the deck as it was given
  std::string why_not;                   ///< why K is not within its tolerance; empty: it is
};

/// One solution of a model; where there is none, why.
using ModelSolveFunction = std::function<std::optional<results::RunResult>(
    const model::Model&, base::OptionalFailure& trouble)>;

/// Solves, finds by the error bars of K what is too coarse, meshes that finer and solves again
/// (manual, tolerance.1 to 4). Where a finer mesh cannot be read or solved, the round before
/// stands.
RefinedRun solve_to_tolerance(const CheckedDeck& deck, const RefinedDeckReader& read_finer,
                              const ModelSolveFunction& solve);

} // namespace spricka::program
