// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "base/source.hpp"
#include "program/job/run_options.hpp"
#include "program/study/variant_runs.hpp"

#include <optional>
#include <string>
#include <vector>

/// Simpler models of a deck, from rung to rung: what they give, and which of them is enough.
namespace spricka::program {

/// How a variant's answers stand to those of the richest.
enum class ModelVariantVerdict {
  richest,
  within,    ///< with both bars
  undecided, ///< the bars are too wide to tell
  outside,
  missing ///< no answers: left out, or not solved
};

/// "within", "not within": for tables.
const char* display_name(ModelVariantVerdict verdict);

struct ModelVariantResult : StudyTrial {
  double difference = 0.0; ///< the largest, with its sign, as a part of the answer
  double bar = 0.0;        ///< the largest, as a part
  ModelVariantVerdict verdict = ModelVariantVerdict::missing;
};

struct SimplerModelComparison {
  double tolerance = 0.02;
  std::vector<AnswerRequest> answers; ///< of one group
  std::vector<double> scales;         ///< [answer] what differences are parts of
  std::vector<ModelVariantResult> variants;
  std::optional<std::size_t> richest;
  /// Of those within, by CPU time; of those that take as long (within 15 %) the simplest.
  std::optional<std::size_t> cheapest;
  /// Rungs that were ended before they had an answer; with one of them nothing is concluded.
  std::vector<std::string> stopped = {};
};

/// Fills differences, verdicts and the cheapest variant.
void judge_simpler_models(SimplerModelComparison& ladder);

/// Tables and a closing sentence for the terminal: the variants, and what was left out.
std::string simpler_models_text(const model::Model& model, const SimplerModelComparison& ladder);

/// A row for each variant and answer.
std::string simpler_models_csv(const SimplerModelComparison& ladder);

/// The HTML page: sentence, chart of differences against CPU time, tables.
std::string simpler_models_page(const base::SourceTexts& sources, const model::Model& model,
                                const SimplerModelComparison& ladder);

/// What the command line asks of a ladder.
struct SimplerModelRunOptions {
  RunOptions deck;         ///< out empty: the deck's name with .ladder
  double tolerance = 0.02; ///< of the answers, as a part
  int jobs = 1;            ///< runs at once
};

/// Runs ever simpler models of a deck's joint, compares their answers with those of the deck and
/// names the cheapest that is within the tolerance. Writes ladder.csv, ladder.html, the decks of
/// all variants, and that of the cheapest with the deck's answers as checks, into a folder. The
/// outcome is that of the deck itself where it cannot be solved.
base::ProgramOutcome run_simpler_models(const SimplerModelRunOptions& options);

} // namespace spricka::program
