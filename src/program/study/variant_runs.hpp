// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/ready_deck.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/run_options.hpp"
#include "program/study/deck_answers.hpp"
#include "program/study/deck_variant.hpp"
#include "program/trials/deck_runs.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The engine of studies and ladders: one deck run in many variants, each as a process of its own.
namespace spricka::program {

/// A variant, what its run took and what it found.
struct StudyTrial {
  DeckVariant variant = {};
  ChildProcessResult end = {};
  std::size_t unknowns = 0;                      ///< of its largest increment
  std::vector<VariantCheckAndFactor> asked = {}; ///< [answer]; empty: the run has no results
  std::vector<AnswerReading> readings = {};      ///< [answer]; empty: the run has no results
  std::string trouble = {};                      ///< why there are no results, in one line
};

/// Which answers of the run of the deck itself all variants are asked for.
using AnswerChoice =
    std::function<std::vector<AnswerRequest>(const model::Model&, const results::RunResult&)>;

/// A deck and the folders in which its variants run.
class VariantRuns {
public:
  VariantRuns(const RunOptions& options, CheckedDeck& ready, const Log& log);

  [[nodiscard]] const StudiedDeck& deck() const { return deck_; }
  [[nodiscard]] const model::Model& model() const { return *deck_.ready->model; }
  /// What all variants are asked for, from run_original_deck() on.
  [[nodiscard]] const std::vector<AnswerRequest>& requested_answers() const { return answers_; }
  /// Where decks of variants are written; gone at the end.
  [[nodiscard]] const std::filesystem::path& scratch_folder() const { return runs_.folder(); }
  /// The folder that is left at the end, absolute.
  [[nodiscard]] const std::filesystem::path& final_folder() const { return place_; }
  /// The same, to be filled.
  RunFolder& run_folder() { return *folder_; }
  DeckRuns& process_runs() { return runs_; }

  /// Runs the deck itself, which decides by `choose` what is asked for. Where it has no results, or
  /// nothing to be asked for, it is told (E555), and the outcome is that of the run, or
  /// not_solvable.
  base::ProgramOutcome run_original_deck(StudyTrial& given, const AnswerChoice& choose);

  /// Runs others, at most `at_once` at a time and each with `cpu_seconds` at most, or with 0 as
  /// long as it takes; tells of each that has ended. What is not run, as all are stopped, stays.
  void run_other_variants(const std::vector<StudyTrial*>& trials, int at_once,
                          double cpu_seconds = 0.0);

  /// Whether this process is one task of a job array: it runs its share, and concludes nothing.
  [[nodiscard]] bool is_task() const { return task_; }
  /// Of a task: runs its share of all variants, that of the deck itself among them, each with
  /// `cpu_seconds` at most, and tells of each that has ended.
  base::ProgramOutcome run_share(const std::vector<StudyTrial*>& trials, int at_once,
                                 double cpu_seconds = 0.0);

  /// Of a collector: says which runs no task has finished (E553), and gives stopped; else done.
  [[nodiscard]] base::ProgramOutcome report_missing_runs() const;

private:
  [[nodiscard]] ChildRun child_of(const DeckVariant& variant, double cpu_seconds) const;
  void tell(const DeckVariant& variant, const ChildProcessResult& end, std::size_t count);
  /// False: the run has no results. Else `choose`, where there is one, has its say first.
  bool read_trial(const ChildRun& child, const ChildProcessResult& end, const AnswerChoice& choose,
                  StudyTrial& trial);

  const Log& log_;
  bool quiet_;
  std::string engine_; ///< of the equations; empty: as the decks say
  bool task_;
  std::size_t reported_ = 0;  ///< runs that were told of
  std::size_t asked_for_ = 0; ///< runs, of which a collector may miss some
  StudiedDeck deck_;
  std::filesystem::path place_;
  std::unique_ptr<RunFolder> folder_; ///< null in a task, which leaves runs and nothing else
  std::vector<AnswerRequest> answers_;
  DeckRuns runs_; ///< last: a signal removes the folder as well
};

/// Reads the deck and lets `work` run variants of it: without a folder in `given` into one of the
/// deck's name with `extension`. Where the work is done the folder is put in place and `summary`,
/// which the work has filled, goes to stdout; a signal ends all and leaves nothing. What the tasks
/// of a job array have run stays in a folder with .runs behind its name.
base::ProgramOutcome run_deck_variants(
    const RunOptions& given, const char* extension,
    const std::function<base::ProgramOutcome(VariantRuns&, std::string& summary)>& work);

} // namespace spricka::program
