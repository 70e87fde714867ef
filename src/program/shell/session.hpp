// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/mount_memory.hpp"
#include "base/outcome.hpp"
#include "model/model.hpp"
#include "program/job/job.hpp"
#include "program/shell/bench.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

using Defines = std::vector<std::pair<std::string, std::string>>;

struct SessionOptions {
  std::function<ReadyDeck(const Defines&)> read;   ///< reads and checks the deck with these
  Defines defines;                                 ///< -D of the command line
  std::function<int(const model::Model&)> threads; ///< empty: one
  std::function<bool()> stopped; ///< asked between the stages of a computation; may be empty
};

/// A size given to a crack.
struct CrackSize {
  double a = 0.0; ///< its length; in space the semi-axis A of an ellipse [length]
  double c = 0.0; ///< in space the semi-axis C, else 0 [length]
  bool operator==(const CrackSize&) const = default;
};

/// Substeps of a change where something rubs.
inline constexpr int default_substeps = 10;

/// What a map runs over: t of a load path, or the factor of a load case.
struct MapRange {
  std::string what = "t";
  double from = 0.0, to = 1.0; ///< at t = 0 and t = 1
};

/// A deck on the bench: what its steps have set, what was changed since, and the answers. It knows
/// nothing of words typed or texts printed; names are those of the deck, upper case, or an
/// operation ends with trouble and the name that was probably meant. An operation that fails leaves
/// everything as it was.
class ShellSession {
public:
  explicit ShellSession(SessionOptions options);

  /// Reads the deck, condenses it and goes to the end of its leading step (KMAX of $GROW, else the
  /// last). Called once; trouble with the deck has been told by `read`.
  base::Trouble open();

  // What is set. Factors and lengths take effect at the next solve().
  base::Trouble go_to_step(const std::string& name); ///< the state at the end of a step of the deck
  /// Scales a load case from the next solve on. Trouble: no case has that name.
  base::Trouble set_load_factor(const std::string& load_case, double factor);
  /// Scales the declared fit of a contact from the next solve on. Trouble: there is no such
  /// contact, or it has no fit.
  base::Trouble set_fit_factor(const std::string& contact, double factor);
  /// The interference itself [length], negative: clearance: its factor becomes 1. Solves from the
  /// first step on.
  base::Trouble set_interference(const std::string& contact, double value);
  /// Puts a contact in force or takes it away with the next solve; a pending change is taken back.
  /// Trouble: it is so already, or $GROW keeps what was mounted at the first length.
  base::Trouble set_mounted(const std::string& contact, bool on);
  /// Cuts the crack anew, condenses what it touches and solves the same way again. In space the
  /// semi-axes of an ellipse; without C the present ratio of both is kept.
  base::Trouble set_crack_length(const std::string& crack, double a, std::optional<double> c = {});
  /// A parameter: the deck is read again; what was set by name is kept.
  base::Trouble define_parameter(const std::string& name, const std::string& expression);
  /// What the last define() would have changed, had it not been set by name (or by $GROW) before.
  [[nodiscard]] const std::vector<std::string>& overridden_settings() const { return covered_; }
  base::Trouble reset(); ///< as after open(); the deck is read again

  /// Makes the changes that are pending; where something rubs in so many substeps from the last
  /// state on, else path-free.
  base::Trouble solve(int substeps = default_substeps);
  /// After an operation that failed late makes what it left unusable anew. Call it before others.
  base::Trouble restore_after_failure();
  [[nodiscard]] bool has_pending_changes() const { return !changes_.actions.empty(); }

  // Answers about the present state; what is pending is solved before.
  base::Trouble estimate_accuracy(); ///< error bars and sensitivities of K, once for a state
  [[nodiscard]] const results::RunResult& run_results() const { return bench_->run_results(); }
  [[nodiscard]] const results::StepResult& current_result() const {
    return bench_->current_result();
  }
  /// Notes of the present state that were not given before, and its warnings, first.
  std::vector<std::string> new_notes();
  [[nodiscard]] const analysis::StepFactors& factors() const { return bench_->factors(); }
  /// A quantity of $CHECK with the value at the present state for the step NOW, at the end of one
  /// of the deck's for another name.
  base::Trouble evaluate(const model::ResultCheck& check, double& value);
  /// K along a $LOADPATH of the deck.
  base::Trouble map_path(const std::string& name);
  /// K while the factor of a load case goes from one value to another, all else as it is; the path
  /// has the name of the case.
  base::Trouble map_case(const std::string& load_case, double from, double to);
  /// The path that was followed last; null: none at this state.
  [[nodiscard]] const results::LoadPathResult* last_mapped_path() const;
  [[nodiscard]] const MapRange& map_range() const { return range_; }

  /// States with the present loads and fits at different lengths, ascending: each an increment
  /// whose only step is NOW, fronts only.
  [[nodiscard]] results::RunResult results_by_length() const;
  /// The same by the size of the first crack, both axes of an ellipse.
  struct FrontsAtSize {
    CrackSize size;
    std::vector<results::FrontResult> fronts;
  };
  [[nodiscard]] std::vector<FrontsAtSize> fronts_by_size() const;

  [[nodiscard]] const model::Model& model() const { return *model_; } ///< as it is now
  [[nodiscard]] const model::Model& displayed_model() const { return bench_->displayed_model(); }
  [[nodiscard]] const base::SourceTexts& sources() const { return deck_->sources; }
  /// Name of the deck's step that the state began with, and what came after it: one step where the
  /// order does not count.
  [[nodiscard]] const std::string& base_step() const { return model_->steps[base_].name; }
  [[nodiscard]] const std::vector<model::Step>& applied_changes() const { return after_; }
  [[nodiscard]] const model::Step& pending_changes() const { return changes_; }
  /// Values given by the user here.
  [[nodiscard]] const std::map<std::string, CrackSize>& user_crack_sizes() const {
    return lengths_;
  }
  [[nodiscard]] const std::map<std::string, double>& user_interferences() const { return gaps_; }
  [[nodiscard]] const Defines& defines() const { return options_.defines; }
  [[nodiscard]] bool has_friction() const; ///< a contact or crack with friction: the order counts
  /// Nets condensed and reused when the lengths changed last.
  [[nodiscard]] const analysis::CondensationFigures& condensation_log() const {
    return bench_->condensation_log();
  }
  /// Size of a crack: axes of an ellipse, else the length that the present result has of it;
  /// without one that of the deck [length].
  [[nodiscard]] CrackSize crack_size(std::size_t crack) const;
  /// Contacts, and the faces of cracks that may touch.
  [[nodiscard]] std::vector<std::string> pair_names() const;

private:
  /// A bench for the model of a deck just read, with what is set by name.
  base::Trouble open_model();
  base::Trouble read_again(const Defines& defines, bool keep);
  /// Cards that parameters reach and that names set here may cover, as the deck has them.
  struct OriginalCards {
    std::vector<model::CrackDefinition> cracks;
    std::vector<model::Contact> contacts;
    std::vector<model::Step> steps;
  };
  [[nodiscard]] std::vector<std::string> covered_by(const OriginalCards& before) const;
  [[nodiscard]] analysis::StepFactors factors_at_base(const OriginalCards& cards) const;
  /// A new bench for the model as it is, at the end of the way so far.
  base::Trouble rebuild();
  base::Trouble make_bench(bool first, std::unique_ptr<InteractiveSolver>& bench);
  [[nodiscard]] std::vector<model::Step> way_to(std::size_t step) const;
  [[nodiscard]] std::vector<model::Step> way() const; ///< to the base step and what came after it
  /// The region that cracks of these lengths touch, and some more, to be condensed apart.
  [[nodiscard]] analysis::RegionPlan plan_lengths() const;
  void set_lengths_on(model::Model& model) const;
  [[nodiscard]] base::Trouble mappable() const;
  [[nodiscard]] std::string setting() const;
  void remember();
  void change(const model::Action& action);

  SessionOptions options_;
  std::unique_ptr<ReadyDeck> deck_;
  std::unique_ptr<model::Model> model_; ///< with the lengths and gaps that were set
  analysis::RegionPlan plan_;
  std::shared_ptr<analysis::CondensationCache> cache_ =
      std::make_shared<analysis::CondensationCache>();
  std::unique_ptr<analysis::ContactMemory> contact_ = std::make_unique<analysis::ContactMemory>();
  std::unique_ptr<analysis::MountOffsetMemory> memory_; ///< where $GROW says MOUNTED=FIRST
  std::unique_ptr<InteractiveSolver> bench_;
  std::size_t base_ = 0;
  std::vector<model::Step> after_;
  model::Step changes_;
  std::map<std::string, CrackSize> lengths_; ///< by crack
  std::map<std::string, double> gaps_;       ///< by contact, interference
  OriginalCards own_;
  std::vector<std::string> covered_;
  std::string mapped_;
  MapRange range_;
  struct TriedLengthResult {
    std::string setting; ///< of all but lengths
    double a = 0.0;
    FrontsAtSize found;
  };
  std::vector<TriedLengthResult> known_;
  Defines given_; ///< by the command line
  std::set<std::string> reported_;
};

} // namespace spricka::program
