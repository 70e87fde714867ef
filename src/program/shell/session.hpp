// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "model/model.hpp"
#include "program/shell/condensed_deck.hpp"
#include "program/shell/deck_changes.hpp"
#include "program/shell/tried_sizes.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

struct SessionOptions : SolverThreadsAndStop {
  /// Reads and checks the deck.
  std::function<CheckedDeck(const deck::DeckReadOptions&)> read;
  /// Told what is odd about cards that were read anew by themselves; may be empty.
  std::function<void(const base::SourceTexts&, const base::Diagnostics&)> report;
  std::vector<std::pair<std::string, std::string>> defines; ///< -D of the command line
};

/// Substeps of a change where something rubs.
inline constexpr int default_substeps = 10;

/// What a map runs over: t of a load path, or the factor of a load case.
struct PathParameterRange {
  std::string what = "t";
  double from = 0.0, to = 1.0; ///< at t = 0 and t = 1
};

/// A deck on the bench: what its steps have set, what was changed since, and the answers. It knows
/// nothing of texts printed. An operation that fails leaves everything as it was.
class ShellSession {
public:
  explicit ShellSession(SessionOptions options) : options_(std::move(options)) {}

  /// Reads the deck, condenses it and goes to the end of its leading step (KMAX of $GROW, else the
  /// last). Again, it forgets all changes and reads the deck anew. Trouble with the deck has been
  /// told by `read`.
  base::OptionalFailure open() { return read_again({}); }

  // What is set.
  base::OptionalFailure
  go_to_step(const std::string& name); ///< the state at the end of a step of the deck
  /// A data line of $STEP, LOAD, FIT, MOUNT or DISMOUNT: pending until the next solve(). Trouble
  /// where a contact is mounted already, or absent, or keeps what it was mounted with.
  base::OptionalFailure add_step_line(const std::string& line);
  /// The header of a card with keys to change (deck_edit.hpp). The deck is read again, and the same
  /// way solved; bodies that are as they were stay condensed.
  base::OptionalFailure change_card(const std::string& header);
  /// A line of $PARAMETER, likewise.
  base::OptionalFailure change_parameter(const std::string& line);
  /// Takes the last change or go_to_step() back.
  base::OptionalFailure undo();

  /// Makes the changes that are pending; where something rubs in so many substeps from the last
  /// state on, else path-free.
  base::OptionalFailure solve(int substeps = default_substeps);
  /// After an operation that failed late makes what it left unusable anew. Call it before others.
  base::OptionalFailure restore_after_failure();
  [[nodiscard]] bool has_pending_changes() const { return !set_.pending.actions.empty(); }

  // Answers about the present state; what is pending is solved before.
  base::OptionalFailure
  estimate_accuracy(); ///< error bars and sensitivities of K, once for a state
  /// At the present state: its factors, the model as it is shown, and what was condensed for it.
  [[nodiscard]] const InteractiveSolver& solver() const { return deck_->solver(); }
  [[nodiscard]] const results::RunResult& run_results() const { return solver().run_results(); }
  [[nodiscard]] const results::LoadStepResult& current_result() const {
    return solver().current_result();
  }
  /// Estimated errors of the nets in the energy norm, once for a state.
  void estimate_net_errors() { deck_->solver().estimate_net_errors(); }
  /// The end of a step of the deck becomes a further step of run_results().
  base::OptionalFailure include_deck_step_result(std::size_t step) {
    return deck_->solver().add_deck_step_result(step);
  }
  /// The growth by the law of $GROW, of the deck's own steps and loads. Fronts that are solved
  /// serve other laws where they do not hang on the law; with `anew` all are solved again.
  base::OptionalFailure grow(bool anew) { return deck_->grow(anew); }
  [[nodiscard]] const ShellGrowth& growth() const { return deck_->growth(); }
  /// K along a $LOADPATH of the deck.
  base::OptionalFailure follow_deck_load_path(const std::string& name);
  /// K while the factor of a load case goes from one value to another, all else as it is; the path
  /// has the name of the case. Values as a LOAD of $STEP has them.
  base::OptionalFailure follow_load_case_range(const std::string& load_case,
                                               const std::string& from, const std::string& to);
  /// The path that was followed last; null: none at this state.
  [[nodiscard]] const results::LoadPathResult* last_followed_path() const;
  [[nodiscard]] const PathParameterRange& path_parameter_range() const { return range_; }

  /// States with the present loads and cards at all sizes of the cracks that were tried, by size.
  [[nodiscard]] std::vector<FrontsAtSize> fronts_by_size() const {
    return tried_.at(deck_->setting_to_compare());
  }

  [[nodiscard]] const model::Model& model() const { return deck_->model(); } ///< as it is now
  /// Files that the deck was read from.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  [[nodiscard]] const SessionDeckChanges& changes() const { return set_; }
  /// Whether cards or parameters have other values than in the deck's file.
  [[nodiscard]] bool has_changed_cards() const {
    return !set_.lines.empty() || !options_.defines.empty();
  }
  [[nodiscard]] const std::string& base_step_name() const { return model().steps[set_.base].name; }
  /// A contact or crack with friction: the order counts.
  [[nodiscard]] bool has_friction() const { return model::has_friction(model()); }
  /// Notes of states that were told, each once.
  [[nodiscard]] std::set<std::string>& reported_notes() { return reported_; }

private:
  base::OptionalFailure read_again(SessionDeckChanges to);
  base::OptionalFailure change_deck(SessionDeckChanges to, deck::DeckCardList text,
                                    const std::string& line);
  base::OptionalFailure change_growth_law(SessionDeckChanges to);
  [[nodiscard]] bool differs_in_growth_law_alone(const SessionDeckChanges& to) const;
  void take_state();
  base::OptionalFailure follow(const model::LoadPathDefinition& card,
                               const std::vector<model::Step>& from,
                               const std::vector<model::Step>& to, const PathParameterRange& range);

  SessionOptions options_;
  std::vector<std::filesystem::path> files_;
  std::unique_ptr<CondensedDeck> deck_;
  SessionDeckChanges set_;
  std::vector<SessionDeckChanges> earlier_;
  std::string mapped_;
  PathParameterRange range_;
  TriedSizes tried_;
  std::set<std::string> reported_;
};

} // namespace spricka::program
