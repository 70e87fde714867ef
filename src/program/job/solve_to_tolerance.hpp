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
bool wants_tolerance(const model::Model& model);

/// The deck read anew, with its meshes refined; without a model if it can't be read so.
using ReadFiner = std::function<ReadyDeck(const std::map<std::string, deck::NetRefinement>&)>;

/// A run that was refined until every K with a tolerance has it, or why it ended before.
struct RefinedRun {
  std::optional<results::RunResult> run; ///< of the last round, its `rounds` filled; empty: refused
  std::optional<ReadyDeck> deck;         ///< what was solved; empty: the deck as it was given
  std::string why_not;                   ///< why K is not within its tolerance; empty: it is
};

/// One solution of a model; where there is none, why.
using SolveOnce = std::function<std::optional<results::RunResult>(const model::Model&,
                                                                  base::OptionalFailure& trouble)>;

/// Solves, finds by the error bars of K what is too coarse, meshes that finer and solves again
/// (manual, tolerance.1 to 4). Where a finer mesh cannot be read or solved, the round before
/// stands.
RefinedRun solve_to_tolerance(const ReadyDeck& deck, const ReadFiner& read_finer,
                              const SolveOnce& solve);

} // namespace spricka::program
