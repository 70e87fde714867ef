// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint_list.hpp"
#include "archive/checkpoint_writer.hpp"
#include "archive/increment_store.hpp"
#include "base/clock.hpp"
#include "base/source.hpp"
#include "model/forward.hpp"
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

class Checkpoint final : public IncrementStore {
public:
  /// Opens both places. Throws FileFailure for files that cannot be used.
  Checkpoint(CheckpointOptions place, const std::filesystem::path& deck,
             const base::SourceTexts& sources, const model::Model& model);

  /// Whether the state fits the deck. To be asked first, once. `why_law_moves_fronts`: why fronts
  /// of one law or spectrum of $GROW can serve no other; empty: they can.
  [[nodiscard]] std::optional<CheckpointMismatch>
  find_mismatch(const std::function<std::string()>& why_law_moves_fronts);
  using Listener = std::function<void(const std::string& code, const std::string& text)>;
  /// Called with all that is told, so far and from now on.
  void set_report_listener(Listener listener);
  /// What was passed over or left out, each with its code.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& reported_problems() const {
    return reported_;
  }

  [[nodiscard]] bool is_of_another_law() const override { return another_law_; }
  void begin_tolerance_round() override { ++round_; }
  [[nodiscard]] bool has_stored_increment(int number) const override;
  [[nodiscard]] double requested_length_of_increment(int number) const override;
  [[nodiscard]] StoredIncrement read_stored_increment(int number) const override;
  void accept_increment(int number) override;
  void list_increment_of_another_law(int number, std::vector<results::LogLine> log) override;
  void store_last_of_another_law(SolvedIncrement again) override;
  void reject_increments_from(int number, const std::string& why) override;
  /// On disk when `every` says so.
  void store_increment(double asked, SolvedIncrement done) override;
  /// Whether the next increment would probably not be finished in time: as long as the longer of
  /// the last two. Never before one was solved, so that every session gets further.
  [[nodiscard]] bool would_exceed_time_limit() const override;
  /// Seconds of the limit.
  [[nodiscard]] std::string run_limit_text() const override;

  /// Puts on disk what is not there yet; from any thread. The number of increments that are kept.
  std::size_t flush();
  [[nodiscard]] std::size_t reused_increment_count() const { return taken_; }
  [[nodiscard]] const std::filesystem::path& restart_source_file() const { return place_.read; }
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
