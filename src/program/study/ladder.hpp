// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/deck_answers.hpp"
#include "program/study/rungs.hpp"
#include "program/trials/child_run.hpp"

#include <optional>
#include <string>
#include <vector>

/// What the rungs of a ladder give, and which of them is enough.
namespace spricka::program {

/// How a rung's answers stand to those of the richest.
enum class RungVerdict {
  richest,
  within,    ///< with both bars
  undecided, ///< the bars are too wide to tell
  outside,
  missing ///< no answers: left out, or not solved
};

/// "within", "not within": for tables.
const char* name_of(RungVerdict verdict);

struct RungResult {
  Rung rung;
  ChildEnd end;
  std::size_t unknowns = 0;
  std::vector<Reading> readings; ///< [answer]; empty: none
  std::string trouble;           ///< why not
  /// [answer] How its deck asks for them, of a plane model of a solid; else empty.
  std::vector<Counterpart> asked = {};
  double difference = 0.0; ///< the largest, with its sign, as a part of the answer
  double bar = 0.0;        ///< the largest, as a part
  RungVerdict verdict = RungVerdict::missing;
};

struct Ladder {
  double tolerance = 0.02;
  std::vector<Answer> answers; ///< of one group
  std::vector<double> scales;  ///< [answer] what differences are parts of
  std::vector<RungResult> rungs;
  std::optional<std::size_t> richest;
  /// Of those within, by CPU time; of those that take as long (within 15 %) the simplest.
  std::optional<std::size_t> cheapest;
  /// Rungs that were ended before they had an answer; with one of them nothing is concluded.
  std::vector<std::string> stopped = {};
};

/// Answers of the most telling group that there are: K before pressures and the rest. Those that
/// are not the deck's own checks: of the step with the largest of them, with $GROW of its KMAX.
std::vector<Answer> ladder_answers(const model::Model& model, const results::RunResult& run);

/// Fills differences, verdicts and the cheapest rung.
void compare(Ladder& ladder);

/// Whether the rung's model does not have an answer, which its image or nothing stands for.
bool lacks(const RungResult& rung, std::size_t answer);

/// The deck of a rung with the richest rung's answers as its checks, to the tolerance; of a part by
/// symmetry its part of energies; no answers that the rung's model does not have.
deck::DeckText with_checks(const Ladder& ladder, const RungResult& rung);

} // namespace spricka::program
