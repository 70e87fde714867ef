// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint_list.hpp"
#include "archive/checkpoint_writer.hpp"
#include "base/clock.hpp"
#include "base/source.hpp"
#include "model/forward.hpp"
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The state of a run on disk, after its increments ($RESTART). A restart file NAME.rst lists the
/// increments, each in a file of its own in NAME.rst.d; NAME.rst.1 is the list before the last.
/// manual/restart.md says what they hold.
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

struct CheckpointOptions {
  std::filesystem::path read;  ///< empty: from the start
  std::filesystem::path write; ///< empty: nothing is kept
  std::optional<int> at;       ///< last increment to take over; empty: all
  int every = 1;
  double seconds = 0.0;  ///< wall time that the program has; 0: no limit
  base::Stopwatch since; ///< from here on
};

/// Why a state does not fit the deck: shown at its place, ProgramOutcome::deck_error.
struct CheckpointMismatch {
  std::string code;
  base::SourceSpan span;
  std::string text;
};

class Checkpoint {
public:
  /// Opens both places. Throws FileFailure for files that cannot be used.
  Checkpoint(CheckpointOptions place, const std::filesystem::path& deck,
             const base::SourceTexts& sources, const model::Model& model);
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;

  /// Whether the state fits the deck. To be asked first, once. `why_law_moves_fronts`: why a law or
  /// spectrum of $GROW has a part in where its fronts are; empty: it has none.
  [[nodiscard]] std::optional<CheckpointMismatch>
  find_mismatch(const std::function<std::string()>& why_law_moves_fronts);
  using Listener = std::function<void(const std::string& code, const std::string& text)>;
  /// Whether the fronts are those of the deck, but were found for another law or spectrum: what
  /// the state says of rates and cycles is none of this growth.
  [[nodiscard]] bool is_of_another_law() const { return another_law_; }
  /// Called with all that is told, so far and from now on.
  void set_report_listener(Listener listener);
  /// What was passed over or left out, each with its code.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& reported_problems() const {
    return reported_;
  }

  /// A run begins; with $TIPNET TOL there are several.
  void begin_tolerance_round() { ++round_; }
  /// Whether increment `number` of this round is there to be taken.
  [[nodiscard]] bool has_stored_increment(int number) const;
  /// The crack length that increment was asked for.
  [[nodiscard]] double requested_length_of_increment(int number) const;
  /// The increment of this round, which has_stored_increment(number). Throws FileFailure.
  [[nodiscard]] StoredIncrement read_stored_increment(int number) const;
  /// It stands for what a run from the start would have solved: it is listed again, but for one of
  /// another law.
  void accept_increment(int number);
  /// Lists an increment of another law again, with what this law makes of it in words. Its state
  /// stays that of the other: nothing goes on from there.
  void list_increment_of_another_law(int number, std::vector<results::LogLine> log);
  /// Keeps the last one that was taken over with its state by this law.
  void store_last_of_another_law(SolvedIncrement again);
  /// This increment and all after it will be solved, not taken; says why.
  void reject_increments_from(int number, const std::string& why);

  /// Keeps an increment that was solved, on disk when `every` says so. Throws FileFailure E563.
  void store_increment(double asked, SolvedIncrement done);
  /// Whether the next increment would probably not be finished in time: as long as the longer of
  /// the last two. Never before one was solved, so that every session gets further.
  [[nodiscard]] bool would_exceed_time_limit() const;
  /// Puts on disk what is not there yet; from any thread. The number of increments that are kept.
  std::size_t flush();
  [[nodiscard]] std::size_t reused_increment_count() const { return taken_; }
  [[nodiscard]] const std::filesystem::path& restart_source_file() const { return place_.read; }
  /// Seconds and increments of the limit in words, for messages.
  [[nodiscard]] std::string run_limit_text() const;
  [[nodiscard]] bool writes_increments() const { return writer_.has_value(); }
  [[nodiscard]] const std::filesystem::path& written_file() const { return place_.write; }

private:
  [[nodiscard]] CheckpointList read_newest();
  [[nodiscard]] std::string list_bytes(const std::vector<CheckpointEntry>& entries) const;
  void list_again(const CheckpointEntry& entry);
  void add_to_writer(double asked, SolvedIncrement done);
  [[nodiscard]] const CheckpointEntry* find(int number) const;
  void tell(const std::string& code, const std::string& text);

  CheckpointOptions place_;
  const base::SourceTexts& sources_;
  const model::Model& model_;
  std::vector<CardFingerprint> cards_; ///< of the deck now
  CheckpointList found_;               ///< in the file that is read
  int round_ = 0;
  std::vector<double> walls_;     ///< [s] of increments solved in this session
  std::size_t dropped_steps_ = 0; ///< of the earlier deck, at its end
  bool another_law_ = false;
  std::vector<std::pair<std::string, std::string>> reported_;
  Listener listener_;
  std::atomic<std::size_t> taken_ = 0; ///< from an earlier run
  std::optional<CheckpointWriter> writer_;
};

} // namespace spricka::archive
