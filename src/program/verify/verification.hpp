// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/trials/child_run.hpp"
#include "program/trials/deck_outcome.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a verification has found, as plain records.
namespace spricka::program {

struct VerifiedDeck : ChildProcessResult {
  std::string name; ///< without .deck
  std::string title;
  std::string said_last; ///< where it has no results
  std::vector<DeckRunChecks> points;

  [[nodiscard]] bool failed() const { return exit_code != 0; }
  [[nodiscard]] std::size_t missed_check_count() const;
};

/// The checks of all its points.
[[nodiscard]] std::vector<results::CheckResult> checks_at_all_points(const VerifiedDeck& deck);

struct Verification {
  std::string program; ///< version and build
  std::string machine;
  std::vector<std::string> asked; ///< tiers, names and patterns
  int at_once = 1;
  double wall = 0.0;               ///< [s]
  std::vector<VerifiedDeck> decks; ///< by name
};

/// What a reference is off by, as its source states it: "+- 0.1 %" of its amount; empty: it states
/// nothing.
std::optional<double> stated_reference_accuracy(const results::CheckResult& check);

/// Whether a check compares with a value of this program itself.
bool has_recorded_reference(const results::CheckResult& check);
/// Whether some check of it has a reference.
bool has_check_with_reference(const VerifiedDeck& deck);

struct VerificationCounts {
  std::size_t points = 0;
  std::size_t checks = 0, missed = 0; ///< with a reference
  std::size_t recorded = 0, recorded_missed = 0;
  std::size_t with_reference = 0;        ///< decks
  std::size_t recorded_only = 0;         ///< decks
  std::size_t unchecked = 0;             ///< decks without a check that end with 0
  std::size_t failed = 0;                ///< decks that have not ended with 0
  std::size_t bars = 0, within_bars = 0; ///< of checks with a reference, and an error bar
  /// Of those outside: within the bar and what the reference itself is off by, as its source states
  /// it; and those whose source states nothing.
  std::size_t within_accuracy = 0, of_no_accuracy = 0;
  double cpu = 0.0;       ///< [s]
  std::size_t memory = 0; ///< [bytes] of the largest
};
/// Adds up decks, points and checks of a verification, with CPU time and the largest memory.
VerificationCounts count_checks_and_costs(const Verification& verification);

/// The worst end of a deck: check_failed if some value has missed its tolerance and that is all.
base::ProgramOutcome worst_outcome(const Verification& verification);

/// "110 decks, 146 runs, 1312 checks with a reference: 1310 passed, 2 missed", and what counts
/// apart, a sentence each.
std::vector<std::string> verification_summary(const Verification& verification);

/// verification.csv: a row for each check, or for a deck that has none; manual/verify.md names the
/// columns.
std::string verification_csv(const Verification& verification);

/// What such a file says, as far as a comparison needs it: texts of checks, errors, what is
/// allowed, costs. Empty if it is not there, or no such table. Throws std::system_error.
std::optional<Verification> read_verification_csv(const std::filesystem::path& file);

} // namespace spricka::program
