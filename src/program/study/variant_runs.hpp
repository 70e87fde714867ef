// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/csv.hpp"
#include "base/outcome.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/run_options.hpp"
#include "program/study/deck_answers.hpp"
#include "program/study/mesh_parameters.hpp"
#include "program/trials/child_run.hpp"
#include "program/trials/scratch_folder.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The engine of studies and ladders: one deck run in many variants, each as a process of its own.
namespace spricka::program {

/// What the run of one variant took and found.
struct VariantRun {
  ChildEnd end;
  std::size_t unknowns = 0;            ///< of its largest increment
  std::vector<AnswerReading> readings; ///< [answer]; empty: the run has no results
  std::string trouble;                 ///< why not, in one line
};

/// Columns of a table: freedoms,cpu,wall,memory,exit_code.
base::CsvRow cost_fields(const VariantRun& run);

/// A deck and the folders in which its variants run.
class VariantRuns {
public:
  /// Called with a variant that has ended, and its results or null.
  using Ended = std::function<void(VariantRun, const results::RunResult*)>;

  VariantRuns(const RunOptions& options, ReadyDeck& ready, const Log& log);

  [[nodiscard]] const StudiedDeck& deck() const { return deck_; }
  [[nodiscard]] const model::Model& model() const { return *deck_.ready->model; }
  /// Where decks of variants are written; gone at the end.
  [[nodiscard]] const std::filesystem::path& scratch() const { return scratch_.path(); }
  /// The folder that is left at the end, absolute.
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }
  /// The same, to be filled.
  RunFolder& folder() { return folder_; }
  ChildRunner& children() { return children_; }
  /// Ends all that runs and removes what is written. From any thread.
  void abandon();

  /// A run of a deck in the scratch folder, on one thread.
  [[nodiscard]] static ChildRun child_of(const std::filesystem::path& deck,
                                         const Defines& defines = {});

  /// Runs the deck itself, which decides what is asked for: `ended` gives what it lacks to be
  /// asked, or nothing. Where it has no results, or lacks that, it is told (E555), and the outcome
  /// is that of the run, or not_solvable.
  base::Outcome
  run_given(const ChildRun& given,
            const std::function<std::string(VariantRun, const results::RunResult&)>& ended);

  /// Runs the others, at most `at_once` at a time; `ended` as of ChildRunner::run_all.
  void
  run_others(const std::vector<ChildRun>& variants, int at_once,
             const std::function<void(std::size_t, VariantRun, const results::RunResult*)>& ended);

private:
  const Log& log_;
  StudiedDeck deck_;
  std::filesystem::path place_;
  RunFolder folder_;
  ScratchFolder scratch_;
  ChildRunner children_;
};

/// Reads the deck and lets `work` run variants of it: without a folder in `given` into one of the
/// deck's name with `extension`. Where the work is done the folder is put in place and `summary`,
/// which the work has filled, goes to stdout; a signal ends all and leaves nothing.
base::Outcome
run_variants_of(const RunOptions& given, const char* extension,
                const std::function<base::Outcome(VariantRuns&, std::string& summary)>& work);

} // namespace spricka::program
