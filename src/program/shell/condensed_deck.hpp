// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/mount_memory.hpp"
#include "base/outcome.hpp"
#include "program/job/ready_deck.hpp"
#include "program/shell/bench.hpp"
#include "program/shell/deck_changes.hpp"
#include "program/shell/shell_growth.hpp"
#include "program/shell/solver_controls.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>

namespace spricka::program {

/// A deck as it was read, its nets condensed for one size of each crack, and the solver that is
/// asked of it.
class CondensedDeck {
public:
  /// `text`: the cards of the deck, which has a model.
  CondensedDeck(CheckedDeck deck, const deck::DeckCardList& text,
                const SolverThreadsAndStop& controls);
  CondensedDeck(const CondensedDeck&) = delete;
  CondensedDeck& operator=(const CondensedDeck&) = delete;

  /// Nets that are as they were in the deck before stay condensed.
  void reuse_nets(const CondensedDeck& before) { cache_ = before.cache_; }
  /// Where only sizes of cracks differ, the region condensed apart, compliances of contacts and
  /// what was mounted stay, too.
  void reuse_region(const CondensedDeck& before);
  /// Condenses and solves the steps to the present state. Once, before the solver is asked.
  base::OptionalFailure open(const SessionDeckChanges& changes);
  /// A new solver for the same model, at the end of the steps.
  base::OptionalFailure renew_solver(const SessionDeckChanges& changes);

  /// Another law of growth, cycles or ends: `text` differs from the deck's in these alone. All else
  /// stays as it is. `news`: warnings of the new cards, with the places in sources().
  base::OptionalFailure change_growth_law(const deck::DeckCardList& text,
                                          const std::filesystem::path& file,
                                          base::Diagnostics& news);
  /// Parameters, in upper case, that geometry scripts take for their constants.
  [[nodiscard]] std::set<std::string> script_constants() const;
  /// The growth by the law that the cards have now.
  base::OptionalFailure grow(bool anew) { return growth_.grow(model(), deck_.sources, anew); }
  [[nodiscard]] const ShellGrowth& growth() const { return growth_; }
  [[nodiscard]] const base::SourceTexts& sources() const { return deck_.sources; }

  [[nodiscard]] const model::Model& model() const { return *deck_.model; }
  [[nodiscard]] InteractiveSolver& solver() { return *solver_; }
  [[nodiscard]] const InteractiveSolver& solver() const { return *solver_; }
  /// All that K depends on but the sizes of cracks: cards, loads, fits, as a text to compare.
  [[nodiscard]] std::string setting_to_compare() const;

private:
  base::OptionalFailure make_solver(bool first, std::unique_ptr<InteractiveSolver>& solver);

  CheckedDeck deck_; ///< with the lengths that $GROW begins with
  SolverThreadsAndStop controls_;
  std::string other_cards_; ///< all cards but $CRACK
  analysis::CrackRegionPlan plan_;
  std::shared_ptr<analysis::CondensationCache> cache_ =
      std::make_shared<analysis::CondensationCache>();
  std::shared_ptr<analysis::ContactDataForNextLength> contact_ =
      std::make_shared<analysis::ContactDataForNextLength>();
  std::shared_ptr<analysis::MountOffsetMemory> memory_; ///< where $GROW says MOUNTED=FIRST
  std::unique_ptr<InteractiveSolver> solver_;
  ShellGrowth growth_;
};

} // namespace spricka::program
