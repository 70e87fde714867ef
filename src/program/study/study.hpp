// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "program/job/run_options.hpp"
#include "program/study/convergence.hpp"
#include "program/study/variant_runs.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Work against precision: the settings of a deck that are run, and what their runs say, the errors
/// of each, slopes, plateaus and the cheapest setting.
namespace spricka::program {

/// A parameter and the values that the command line wants of it.
struct ParameterVariation {
  std::string parameter;
  std::vector<std::string> values;
};

/// The settings of a study, the deck itself first, then by worth; their decks are written into
/// `folder`. Finenesses at which numbers of elements would be broken are replaced by the next that
/// a deck can be read with. What cannot be varied, and why, goes to `notes`.
std::vector<DeckVariant> plan_study_settings(const StudiedDeck& deck,
                                             const std::vector<ParameterVariation>& requests,
                                             const std::filesystem::path& folder,
                                             std::vector<std::string>& notes);

/// Trials with results of one family, coarse to fine. The deck as it is belongs to the series of
/// sizes: of all, of bodies, of tips, and of what is asked for.
std::vector<std::size_t> find_trials_of_family(const std::vector<StudyTrial>& trials,
                                               SettingFamily family);

/// What answers are compared with.
struct AnswerReference {
  double value = 0.0;
  double uncertainty = 0.0; ///< in the unit of the answer
  bool of_deck = false;     ///< the value of the deck's $CHECK; else of the finest setting
  double deck_is_off = 0.0; ///< a deck's value that is not used: by so much, in parts of the answer
  double scale = 0.0;       ///< what errors are parts of; 0: the answer is left out
};

/// Of one setting and group of answers: the largest, as parts of the answers. Not a number where
/// there is none.
struct AnswerGroupErrors {
  double plain = 0.0;
  double best = 0.0; ///< of the corrected values
  double bar = 0.0;

  /// The largest of the plain or of the corrected values.
  [[nodiscard]] double plain_or_corrected(bool corrected) const { return corrected ? best : plain; }
};

/// One series of a group.
struct SeriesVerdict {
  SettingFamily family = SettingFamily::whole;
  bool corrected = false;
  std::optional<ConvergenceRate> slope;
  std::optional<double> theory;        ///< the power that is expected
  std::optional<ErrorPlateau> plateau; ///< `first` counts the points
  std::string reason;                  ///< of the plateau
};

struct AnswerGroupVerdict {
  AnswerGroup group = AnswerGroup::K;
  std::vector<AnswerGroupErrors> errors; ///< [trial]
  double floor = 0.0; ///< how uncertain the references are: nothing below is told apart
  std::vector<SeriesVerdict> series;
  std::vector<std::string> sentences; ///< the cheapest settings, and CalculiX beside them
};

/// All that is shown of a study.
struct Study {
  std::vector<AnswerRequest> answers;
  std::vector<StudyTrial> trials;
  std::vector<std::string> notes;          ///< what was not varied or run, and why
  std::vector<AnswerReference> references; ///< [answer]
  std::optional<std::size_t> finest;       ///< trial that others are compared with
  std::vector<AnswerGroupVerdict> groups;  ///< those with answers, in their order
};

/// Fills references and groups with errors of all trials. A deck's reference counts where the
/// finest setting agrees with it within its own bar, or without one within its change from the next
/// coarser setting; else the finest setting's value does, corrected where it has a bar.
void assess_trials(Study& study);

/// What a plateau is judged by.
struct PlateauContext {
  const AnswerGroupVerdict& group; ///< its errors and floor
  const SeriesVerdict& series;
  const Study& study; ///< with its references
};

/// Why errors of a series stop falling, in words: how well the reference is known, what is not made
/// finer with the rest, quarter points that are missing, values at single nodes.
std::string plateau_reason(const PlateauContext& view, std::span<const MeshSizeAndError> points);

/// Settings with their cost and errors, series with slopes and plateaus, references of the deck
/// that are not used, the cheapest settings.
std::string study_text(const Study& study);

/// A row for each setting and answer.
std::string study_csv(const Study& study);

/// One page: error of each group of answers against CPU time and against freedoms, then the tables.
std::string study_page(const base::SourceTexts& sources, const model::Model& model,
                       const Study& study);

/// What the command line asks of a study.
struct StudyOptions {
  RunOptions deck;                          ///< out empty: the deck's name with .study
  std::vector<ParameterVariation> requests; ///< in place of what is found in the deck
  int jobs = 1;                             ///< runs at once; one alone has an honest CPU time
  /// [s] CPU of all runs; what would not fit is left out. With --array of each run.
  double budget = 600.0;
};

/// Work against precision: runs a deck in many settings, and says what each costs and how right it
/// is. Writes study.csv and study.html into a folder. The outcome is that of the deck itself where
/// it cannot be solved.
base::ProgramOutcome study_deck(const StudyOptions& options);

} // namespace spricka::program
