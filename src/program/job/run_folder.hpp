// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/folder_lock.hpp"
#include "base/source.hpp"
#include "model/forward.hpp"
#include "results/imported_geometry.hpp"
#include "results/results.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace spricka::program {

inline constexpr const char* k_table_name = "k.csv";
inline constexpr const char* listing_name = "listing.txt";
inline constexpr const char* sweep_table_name = "sweep.csv";
inline constexpr const char* results_name = "results.h5"; ///< whole, for programs

/// The folder as the program uses it: absolute, links followed, without a slash at its end.
std::filesystem::path canonical_folder(const std::filesystem::path& folder);

/// Throws FileFailure E464 when a folder that is there is not one that a run (a sweep) may write:
/// it holds files and no mark, or the mark of the other kind (archive/folder_mark.hpp).
void check_folder_ownership(const std::filesystem::path& folder, bool sweep);

/// The run folder. Everything is written into a folder FOLDER.part beside it, that takes its place
/// in one move at the end, or not at all: results of an earlier run stay until then. Files in the
/// earlier folder that no run wrote are taken over into the new one. Both folders are locked
/// against a second run.
class RunFolder {
public:
  /// Throws std::system_error or FileFailure (E464, E465) when the folder cannot be used.
  explicit RunFolder(const std::filesystem::path& folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// Whether results of an earlier run stand in the folder's place.
  [[nodiscard]] bool replaces_earlier_run() const { return replaces_; }

  /// Writes listing, k.csv, pressure.csv, pictures and requested files, and adds its own cost to
  /// the run's log before the listing is made. Throws std::system_error.
  void write_results(const base::SourceTexts& sources, const model::Model& model,
                     results::RunResult& run, const results::ReportedGeometry& geometry);
  /// Writes k.csv of what is found so far into FOLDER.part, where it can be read while the run goes
  /// on; write_results() replaces it. From one thread.
  void write_interim_k(const model::Model& model, const results::RunResult& so_far);
  /// Leaves FOLDER.part with that table alone, for a run that ends without results; the next run
  /// removes it. The file; empty: no K was found, and nothing stays.
  std::optional<std::filesystem::path> retain_interim_k();
  /// What has been written so far [bytes].
  [[nodiscard]] std::uintmax_t written_bytes() const;
  /// Adds a file of that name.
  void add_file(const std::string& name, const std::string& text);
  /// Puts the folder in place; without it nothing stays.
  void commit();
  /// Removes what is written so far, from any thread: the program ends now. Whoever writes is let
  /// finish his file first and waits for ever then. With `leaves_k` as retain_interim_k().
  std::optional<std::filesystem::path> abandon(bool leaves_k = false);

private:
  void open_place();
  void open_part();
  /// Writes a file of ours with `write`, which gets its path.
  void put(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);
  void put_requested(const model::Model& model, const results::RunResult& run);
  void move_into_place();
  void take_over_foreign(const std::filesystem::path& old) const;

  std::filesystem::path folder_;
  std::filesystem::path part_; ///< where it is written
  bool replaces_ = false;
  bool done_ = false;
  bool shows_k_ = false; ///< k.csv of a run under way is there, or was
  std::optional<archive::FolderLock> place_lock_, part_lock_;
  std::timed_mutex writing_;
  std::vector<std::string> names_; ///< written so far
};

/// Keeps k.csv of a run under way up to date: K of all increments that are finished, and of the
/// steps of the one that is not.
class InterimKTable {
public:
  InterimKTable(const model::Model& model, RunFolder& folder) : model_(model), folder_(folder) {}

  /// The increment under way has a new K, or a bar of one.
  void update_increment(const results::CrackLengthResult& increment);
  /// How many increments of the run are finished; their K stays in the table.
  void set_finished_increments(std::size_t increments) { finished_ = increments; }

private:
  const model::Model& model_;
  RunFolder& folder_;
  results::RunResult run_; ///< K alone
  std::size_t finished_ = 0;
};

} // namespace spricka::program
