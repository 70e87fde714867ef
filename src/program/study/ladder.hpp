// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/model_variants.hpp"
#include "program/study/variant_runs.hpp"

#include <optional>
#include <string>
#include <vector>

/// What the variants of a ladder give, and which of them is enough.
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

struct ModelVariantResult : VariantRun {
  ModelVariant variant;
  double difference = 0.0; ///< the largest, with its sign, as a part of the answer
  double bar = 0.0;        ///< the largest, as a part
  ModelVariantVerdict verdict = ModelVariantVerdict::missing;
};

struct ModelHierarchy {
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

/// Answers of the most telling group that there are: K before pressures and the rest. Those that
/// are not the deck's own checks: of the step with the largest of them, with $GROW of its KMAX.
std::vector<AnswerRequest> choose_hierarchy_answers(const model::Model& model,
                                                    const results::RunResult& run);

/// Fills differences, verdicts and the cheapest variant.
void compare(ModelHierarchy& ladder);

/// Whether the variant's model does not have an answer, which its image or nothing stands for.
bool lacks_answer(const ModelVariantResult& variant, std::size_t answer);

/// The deck of a variant with the richest variant's answers as its checks, to the tolerance; of a
/// part by symmetry its part of energies; no answers that the variant's model does not have.
deck::DeckCardList deck_with_checks(const ModelHierarchy& ladder,
                                    const ModelVariantResult& variant);

} // namespace spricka::program
