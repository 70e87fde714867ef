// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

/// What a run hands over, increment by increment, to a later run of the same deck.
namespace spricka::archive {

/// An increment with what the loop carried behind it.
struct StoredIncrement {
  results::CrackLengthResult increment;
  results::NamedArrays state;
  std::vector<results::LogLine> log;
  double cpu = 0.0, wall = 0.0; ///< [s] that it took
};

/// The same of one that was solved just now.
struct SolvedIncrement {
  const results::CrackLengthResult& increment;
  results::NamedArrays state;
  std::vector<results::LogLine> log;
  double cpu = 0.0, wall = 0.0; ///< [s]
};

/// Gives the loop over crack lengths the increments of an earlier run, and keeps those that it
/// adds.
class IncrementStore {
public:
  IncrementStore() = default;
  IncrementStore(const IncrementStore&) = delete;
  IncrementStore& operator=(const IncrementStore&) = delete;
  virtual ~IncrementStore() = default;

  /// Whether the fronts are those of the deck, but were found for another law or spectrum: what
  /// the state says of rates and cycles is none of this growth.
  [[nodiscard]] virtual bool is_of_another_law() const = 0;
  /// A run begins; with $TIPNET TOL there are several.
  virtual void begin_tolerance_round() = 0;
  /// Whether increment `number` of this round is there to be taken.
  [[nodiscard]] virtual bool has_stored_increment(int number) const = 0;
  /// The crack length that increment was asked for.
  [[nodiscard]] virtual double requested_length_of_increment(int number) const = 0;
  /// The increment of this round, which has_stored_increment(number). Throws FileFailure where it
  /// is kept in a file that cannot be used.
  [[nodiscard]] virtual StoredIncrement read_stored_increment(int number) const = 0;
  /// It stands for what a run from the start would have solved: it is listed again, but for one of
  /// another law.
  virtual void accept_increment(int number) = 0;
  /// Lists an increment of another law again, with what this law makes of it in words. Its state
  /// stays that of the other: nothing goes on from there.
  virtual void list_increment_of_another_law(int number, std::vector<results::LogLine> log) = 0;
  /// Keeps the last one that was taken over with its state by this law.
  virtual void store_last_of_another_law(SolvedIncrement again) = 0;
  /// This increment and all after it will be solved, not taken; says why.
  virtual void reject_increments_from(int number, const std::string& why) = 0;
  /// Keeps an increment that was solved. Throws FileFailure E563 where a file cannot be written.
  virtual void store_increment(double asked, SolvedIncrement done) = 0;
  /// Whether the run is to end before the next increment.
  [[nodiscard]] virtual bool would_exceed_time_limit() const = 0;
  /// Why, in words.
  [[nodiscard]] virtual std::string run_limit_text() const = 0;
};

} // namespace spricka::archive
