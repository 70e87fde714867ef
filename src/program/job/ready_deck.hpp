// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/outcome.hpp"
#include "base/source.hpp"
#include "deck/imported_step.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"
#include "program/job/log.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

/// How one deck has ended, with its results where there are some.
struct RunOutcomeWithResults {
  base::ProgramOutcome kind = base::ProgramOutcome::done;
  std::string error; ///< the first one, with its place, or how many checks failed
  std::optional<results::RunResult> run;
  std::string profile = {}; ///< the table of --profile, where it is asked for
};

/// A deck that has been read: fit to be solved (model) or refused.
struct CheckedDeck {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;   ///< of reading
  deck::DeckReadOptions options;   ///< as it was read
  deck::ImportedGeometry imported; ///< what is known of it, with errors too
  std::vector<std::string> flaws;  ///< what bodies in space have of each crack
  std::optional<model::Model> model;
  RunOutcomeWithResults refusal; ///< without a model
};

/// Reads and checks a deck; messages go to the log. Cards that this version does not have are
/// refused (not_solvable), so is a deck without a step. Throws std::system_error on file trouble.
/// What was `reported` already is not said again, as of the other points of a sweep.
CheckedDeck read_and_check_deck(const std::filesystem::path& deck,
                                const deck::DeckReadOptions& options, const Log& log,
                                const base::Diagnostics* reported = nullptr);

/// A deck that has been read before, with its meshes finer: nothing new to tell of it.
CheckedDeck read_deck_silently(const std::filesystem::path& deck,
                               const deck::DeckReadOptions& options);

/// What is wrong goes to the log, but for what was `reported` before, and the first error into the
/// outcome.
RunOutcomeWithResults report_refusal(const base::SourceTexts& sources,
                                     const base::Diagnostics& list, base::ProgramOutcome kind,
                                     const Log& log, const base::Diagnostics* reported = nullptr);

/// Without what was `reported` before, word for word: places move where a card above has changed.
/// Null: nothing was.
base::Diagnostics find_news(const base::Diagnostics& list, const base::Diagnostics* reported);

/// "lug.deck:12:18: E108: text" of the first error; empty without one.
std::string first_error_text(const base::SourceTexts& sources,
                             const base::Diagnostics& diagnostics);

} // namespace spricka::program
