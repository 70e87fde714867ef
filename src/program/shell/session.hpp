// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/mount_memory.hpp"
#include "base/outcome.hpp"
#include "deck/deck_text.hpp"
#include "model/model.hpp"
#include "program/job/job.hpp"
#include "program/shell/bench.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

struct SessionOptions {
  /// Reads and checks the deck.
  std::function<CheckedDeck(const deck::DeckReadOptions&)> read;
  std::vector<std::pair<std::string, std::string>> defines; ///< -D of the command line
  std::function<int(const model::Model&)> threads;          ///< empty: one
  std::function<bool()> stopped;                            ///< may be empty
};

struct CrackSize {
  double a = 0.0; ///< its length; in space the semi-axis A of an ellipse [length]
  double c = 0.0; ///< in space the semi-axis C, else 0 [length]
  bool operator==(const CrackSize&) const = default;
};

/// Substeps of a change where something rubs.
inline constexpr int default_substeps = 10;

/// What a map runs over: t of a load path, or the factor of a load case.
struct PathParameterRange {
  std::string what = "t";
  double from = 0.0, to = 1.0; ///< at t = 0 and t = 1
};

/// What is set: the deck's cards as they are now, and the steps behind its own.
struct SessionDeckChanges {
  std::shared_ptr<const deck::DeckCardList> text; ///< with -D in its parameters
  std::vector<std::string> lines;                 ///< cards and parameters that were typed
  std::set<std::string> cracks;     ///< that were given keys: $GROW does not set their lengths
  std::size_t base = 0;             ///< the deck's step that the state began with
  std::vector<model::Step> applied; ///< behind it: one step where the order does not count
  model::Step pending;              ///< not solved yet
};

/// A deck on the bench: what its steps have set, what was changed since, and the answers. It knows
/// nothing of texts printed. An operation that fails leaves everything as it was.
class ShellSession {
public:
  explicit ShellSession(SessionOptions options);

  /// Reads the deck, condenses it and goes to the end of its leading step (KMAX of $GROW, else the
  /// last). Again, it forgets all changes and reads the deck anew. Trouble with the deck has been
  /// told by `read`.
  base::OptionalFailure open();

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
  [[nodiscard]] const results::RunResult& run_results() const { return bench_->run_results(); }
  [[nodiscard]] const results::StepResult& current_result() const {
    return bench_->current_result();
  }
  /// Notes of the present state that were not given before, and its warnings, first.
  std::vector<std::string> new_notes();
  [[nodiscard]] const analysis::StepActionFactors& factors() const { return bench_->factors(); }
  /// A result that $CHECK knows, with its arguments; NOW is the present state. Nothing is solved.
  base::OptionalFailure read_result_request(const std::string& line,
                                            model::ResultCheck& check) const;
  /// Its value at the present state for the step NOW, at the end of one of the deck's for another
  /// name.
  base::OptionalFailure evaluate(const model::ResultCheck& check, double& value);
  /// K along a $LOADPATH of the deck.
  base::OptionalFailure follow_deck_load_path(const std::string& name);
  /// K while the factor of a load case goes from one value to another, all else as it is; the path
  /// has the name of the case. Values as a LOAD of $STEP has them.
  base::OptionalFailure follow_load_case_range(const std::string& load_case,
                                               const std::string& from, const std::string& to);
  /// The path that was followed last; null: none at this state.
  [[nodiscard]] const results::LoadPathResult* last_followed_path() const;
  [[nodiscard]] const PathParameterRange& path_parameter_range() const { return range_; }

  /// A state with the present loads and cards that was found at one size of the cracks.
  struct FrontsAtSize {
    double a = 0.0; ///< as increments are sorted by it
    CrackSize size; ///< of the first crack
    std::vector<results::FrontResult> fronts;
  };
  /// All of them, by size.
  [[nodiscard]] std::vector<FrontsAtSize> fronts_by_size() const;

  [[nodiscard]] const model::Model& model() const { return *model_; } ///< as it is now
  [[nodiscard]] const model::Model& displayed_model() const { return bench_->displayed_model(); }
  /// Files that the deck was read from.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  [[nodiscard]] const SessionDeckChanges& changes() const { return set_; }
  /// Whether cards or parameters have other values than in the deck's file.
  [[nodiscard]] bool has_changed_cards() const {
    return !set_.lines.empty() || !options_.defines.empty();
  }
  [[nodiscard]] const std::string& base_step_name() const { return model_->steps[set_.base].name; }
  [[nodiscard]] bool has_friction() const; ///< a contact or crack with friction: the order counts
  /// Nets condensed and reused when cards changed last.
  [[nodiscard]] const analysis::CondensationStatistics& condensation_figures() const {
    return bench_->condensation_figures();
  }
  /// Size of a crack: axes of an ellipse, else the length that the present result has of it;
  /// without one that of the deck [length].
  [[nodiscard]] CrackSize crack_size(std::size_t crack) const;

private:
  base::OptionalFailure read_again(SessionDeckChanges to);
  base::OptionalFailure change_deck(SessionDeckChanges to, deck::DeckCardList text,
                                    const std::string& line);
  /// A bench for the model of a deck just read.
  base::OptionalFailure open_model();
  /// A new bench for the model as it is, at the end of the way so far.
  base::OptionalFailure rebuild();
  base::OptionalFailure make_bench(bool first, std::unique_ptr<InteractiveSolver>& bench);
  [[nodiscard]] std::vector<model::Step> way_to(std::size_t step) const;
  [[nodiscard]] std::vector<model::Step> way() const; ///< to the base step and what came after it
  [[nodiscard]] base::OptionalFailure goes_on_or_off(base::ContactId contact, bool on) const;
  /// The region that cracks of these lengths touch, and some more, to be condensed apart.
  [[nodiscard]] analysis::CrackRegionPlan plan_lengths() const;
  base::OptionalFailure follow(const model::LoadPathDefinition& card,
                               const std::vector<model::Step>& from,
                               const std::vector<model::Step>& to, const PathParameterRange& range);
  [[nodiscard]] std::string setting() const;
  void remember();

  SessionOptions options_;
  std::vector<std::filesystem::path> files_;
  std::unique_ptr<CheckedDeck> deck_;
  std::unique_ptr<model::Model> model_; ///< with the lengths that $GROW begins with
  std::string other_cards_;             ///< all cards but $CRACK
  analysis::CrackRegionPlan plan_;
  std::shared_ptr<analysis::CondensationCache> cache_ =
      std::make_shared<analysis::CondensationCache>();
  std::shared_ptr<analysis::ContactMemory> contact_ = std::make_shared<analysis::ContactMemory>();
  std::shared_ptr<analysis::MountOffsetMemory> memory_; ///< where $GROW says MOUNTED=FIRST
  std::unique_ptr<InteractiveSolver> bench_;
  SessionDeckChanges set_;
  std::vector<SessionDeckChanges> earlier_;
  std::string mapped_;
  PathParameterRange range_;
  struct TriedSize {
    std::string setting; ///< of all but lengths
    FrontsAtSize found;
  };
  std::vector<TriedSize> known_;
  std::set<std::string> reported_;
};

} // namespace spricka::program
