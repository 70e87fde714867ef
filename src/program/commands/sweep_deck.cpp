// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/sweep_deck.hpp"

#include "analysis/lengths/recorder.hpp"
#include "archive/deck_digest.hpp"
#include "archive/folder_mark.hpp"
#include "archive/safe_file.hpp"
#include "base/exit_codes.hpp"
#include "base/printable.hpp"
#include "model/model.hpp"
#include "program/job/failures.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/point_record.hpp"
#include "program/job/restart_run.hpp"
#include "program/job/standard_streams.hpp"
#include "program/profile/profile.hpp"
#include "report/drawing/file.hpp"
#include "report/sweep_files.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using results::SweepPoint;

/// The folder of a sweep: it is locked from open() on, and knows which tables in it are of sweeps.
class SweepFolder {
public:
  explicit SweepFolder(fs::path path) : path_(std::move(path)) {}
  ~SweepFolder() {
    if (lock_) {
      close();
    }
  }
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

  // A folder of a sweep is gone on with, any other refused but for an empty one.
  void open() {
    check_folder_ownership(path_, true);
    fs::create_directories(path_);
    lock_ = archive::FolderLock::acquire_lock(path_, path_);
    check_folder_ownership(path_, true); // another run may have ended meanwhile
    if (!lock_) {
      throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                              path_.string());
    }
    if (!archive::read_folder_manifest(path_)) {
      archive::write_folder_manifest(path_, {archive::RunOrSweepFolder::sweep, {}});
    }
    archive::write_lock_owner(path_);
  }

  // Folders of points that the sweep does not have.
  void remove_others(const std::set<std::string>& wanted) const {
    std::vector<fs::path> others;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      const std::string name = entry.path().filename().string();
      if (name.find_first_not_of("0123456789") == std::string::npos && !wanted.contains(name)) {
        others.push_back(entry.path());
      }
    }
    std::ranges::for_each(others, archive::remove_manifest_files);
  }

  // Nobody works in it any more.
  void close() const {
    std::error_code ignored;
    fs::remove(path_ / archive::owner_name, ignored);
  }

  // A table of ours, new or to be replaced.
  [[nodiscard]] fs::path table_file(const std::string& name) const {
    const archive::FolderManifest mark =
        archive::read_folder_manifest(path_).value_or(archive::FolderManifest{});
    if (std::ranges::find(mark.files, name) == mark.files.end()) {
      if (fs::exists(fs::symlink_status(path_ / name))) {
        throw archive::FileFailure("E464",
                                   fmt::format("{} is there, and no sweep wrote it; name another "
                                               "folder with --out",
                                               (path_ / name).string()));
      }
      archive::add_to_folder_manifest(path_, name);
    }
    return path_ / name;
  }

private:
  fs::path path_;
  std::optional<archive::FolderLock> lock_;
};

class SweepRun {
public:
  SweepRun(const RunOptions& options, const CheckedDeck& deck, const Log& log)
      : options_(options), deck_(deck), log_(log), out_(canonical_folder(options.out)),
        points_(sweep_points(*deck.model)) {
    sweep_.count = points_.size();
    for (const auto& [name, value] : points_.front()) {
      sweep_.parameters.push_back(name);
    }
  }

  base::ProgramOutcome run() {
    out_.open();
    const InterruptHandler interrupt([this](int signal) { return last_words(signal); });
    return run_points();
  }

private:
  base::ProgramOutcome run_points() {
    // Else it is of an earlier sweep, until there is a point.
    if (!fs::exists(out_.path() / sweep_table_name)) {
      write_tables();
    }
    base::ProgramOutcome worst = base::ProgramOutcome::done;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      SweepPoint point = take_over(i);
      if (!point.reused) {
        compute(i, point);
      }
      if (point.outcome == base::ProgramOutcome::stopped) {
        return base::ProgramOutcome::stopped;
      }
      worst = std::max(worst, point.outcome);
      tell(point, points_[i]);
      sweep_.points.push_back(std::move(point));
      write_tables();
      ++done_;
    }
    std::set<std::string> wanted;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      wanted.insert(folder_name(i));
    }
    out_.remove_others(wanted);
    if (!options_.quiet) {
      write_to_stdout(fmt::format("{} points; results in {}\n", points_.size(),
                                  base::make_printable(options_.out.string())));
    }
    return worst;
  }

  [[nodiscard]] std::string folder_name(std::size_t i) const {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(points_.size()).size());
    return fmt::format("{:0{}}", i + 1, digits);
  }

  SweepPoint take_over(std::size_t i) {
    const std::string digest =
        archive::compute_deck_digest(deck_.sources, *deck_.model, points_[i]);
    const std::optional<SweepPoint> known = read_point_record(out_.path() / folder_name(i), digest);
    SweepPoint point = known.value_or(SweepPoint{});
    point.number = i + 1;
    point.folder = folder_name(i);
    point.reused = known.has_value();
    for (const auto& [name, value] : points_[i]) {
      point.values.push_back(value);
    }
    return point;
  }

  void compute(std::size_t i, SweepPoint& point) {
    try {
      open_point(point);
      solve_point(i, point);
    } catch (const archive::FileFailure& trouble) {
      point.outcome = base::ProgramOutcome::file_trouble;
      point.error = fmt::format("{}: {}", trouble.code(), trouble.what());
    } catch (const std::system_error& trouble) {
      point.outcome = base::ProgramOutcome::file_trouble;
      point.error = trouble.what();
    } catch (const std::exception& trouble) {
      const bool memory = is_out_of_memory(trouble);
      point.outcome = memory ? base::ProgramOutcome::not_solvable : base::ProgramOutcome::defect;
      point.error = memory ? "E466: " + out_of_memory_message()
                           : fmt::format("internal error: {}", trouble.what());
    }
    close_point();
  }

  void solve_point(std::size_t i, SweepPoint& point) {
    RunOptions options = options_;
    options.quiet = true;
    // Each point has a profile of its own, from here on.
    options.recorder = options.profile ? begin_profile() : nullptr;
    const CheckedDeck deck = read_point(options, i);
    const RunOutcomeWithResults outcome = deck.model ? solve(options, deck, point) : deck.refusal;
    point.outcome = outcome.kind;
    point.error = outcome.error;
    if (outcome.run) {
      record(*deck.model, *outcome.run, point);
      // The digest of what was read just now: a file edited meanwhile is not passed over later.
      folder_->add_file(
          point_record_name,
          point_record_text(sweep_, point,
                            archive::compute_deck_digest(deck.sources, *deck.model, points_[i])));
      folder_->commit();
    } else if (folder_->replaces_earlier_run()) {
      log_.report_message(base::Severity::note, "E467",
                          fmt::format("{} still holds the results of an earlier run",
                                      (out_.path() / point.folder).string()));
    }
  }

  [[nodiscard]] CheckedDeck read_point(const RunOptions& options, std::size_t i) const {
    const analysis::ScopedProfileInterval span(options.recorder.get(), "DECK", "deck and meshes");
    return read_and_check_deck(options.deck,
                               {.defines = options.defines, .sweep_values = points_[i]}, log_,
                               &deck_.diagnostics);
  }

  // Made and ended where last_words() knows of it.
  void open_point(const SweepPoint& point) {
    const std::scoped_lock lock(current_guard_);
    folder_.emplace(out_.path() / point.folder);
  }
  void close_point() {
    const std::scoped_lock lock(current_guard_);
    folder_.reset();
  }

  // Each point keeps its state in a folder of its own, beside its run folder.
  RunOutcomeWithResults solve(const RunOptions& options, const CheckedDeck& deck,
                              const SweepPoint& point) {
    const CheckpointOrRefusal opened =
        open_checkpoint(options, deck, out_.path() / (point.folder + ".restart"), log_);
    if (opened.refusal) {
      return *opened.refusal;
    }
    set_current(opened.checkpoint.get());
    try {
      RunOutcomeWithResults outcome =
          solve_and_write(options, deck, &*folder_, opened.checkpoint.get(), log_);
      set_current(nullptr);
      return outcome;
    } catch (...) {
      set_current(nullptr);
      throw;
    }
  }

  void set_current(archive::Checkpoint* checkpoint) {
    const std::scoped_lock lock(current_guard_);
    current_ = checkpoint;
  }

  static void record(const model::Model& model, const results::RunResult& run, SweepPoint& point) {
    point.checks = static_cast<int>(run.checks.size());
    point.passed = static_cast<int>(std::count_if(run.checks.begin(), run.checks.end(),
                                                  [](const auto& c) { return c.passed; }));
    point.warnings = static_cast<int>(run.warnings.size());
    point.cells = report::collect_sweep_values_of_run(model, run);
    for (const model::OutputFileRequest& output : model.outputs) {
      if (output.format == model::OutputFormat::csv &&
          output.every == model::OutputFrequency::end) {
        std::vector<results::SweepResultValue>& cells =
            point.requested[fs::path(output.file).filename().string()];
        const std::vector<results::SweepResultValue> more =
            report::collect_requested_end_values(model, output, run);
        cells.insert(cells.end(), more.begin(), more.end());
      }
    }
  }

  void write_tables() {
    const std::scoped_lock lock(tables_guard_);
    const model::Model& model = *deck_.model;
    for (const model::OutputFileRequest& output : model.outputs) {
      const std::string name = fs::path(output.file).filename().string();
      if (output.format == model::OutputFormat::csv &&
          output.every == model::OutputFrequency::end && name != sweep_table_name) {
        report::write_sweep_request_csv(out_.table_file(name), model, sweep_);
      }
    }
    report::write_sweep_csv(out_.table_file(sweep_table_name), model, sweep_);
    report::write_file(out_.table_file("sweep.html"),
                       report::sweep_page(deck_.sources, model, sweep_));
  }

  // One line for each point: failures to stderr, the others to stdout.
  void tell(const SweepPoint& point, const SweepPointValues& values) const {
    const std::string head =
        fmt::format("{} of {}: {}", point.folder, points_.size(), sweep_point_text(values));
    if (point.outcome != base::ProgramOutcome::done) {
      log_.report_message(base::Severity::error, "E550",
                          fmt::format("point {}: {} ({}): {}", head,
                                      report::sweep_point_status(point),
                                      base::exit_code(point.outcome), point.error));
    }
    if (options_.quiet) {
      return;
    }
    write_to_stdout(fmt::format("{}: {}{}", head, report::sweep_point_status(point),
                                point.reused ? " earlier" : ""));
    tell_result(point);
    write_to_stdout("\n");
    std::fflush(stdout);
  }

  // The life, else K1 at the last length.
  void tell_result(const SweepPoint& point) const {
    const auto life = std::ranges::find(point.cells, "N", &results::SweepResultValue::quantity);
    if (life != point.cells.end()) {
      write_to_stdout(fmt::format("  N = {:.7g}", life->value));
      return;
    }
    const std::string step = results::shown_step_name(*deck_.model, {});
    int last = 0;
    for (const results::SweepResultValue& cell : point.cells) {
      last = std::max(last, cell.increment);
    }
    for (const results::SweepResultValue& cell : point.cells) {
      if (cell.quantity == "K1" && cell.step == step && cell.increment == last) {
        write_to_stdout(fmt::format("  K1 {} = {:.7g}", cell.name, cell.value));
      }
    }
  }

  // On the watcher's thread, while the point goes on being computed. Its locks are not given back:
  // nothing more is written.
  int last_words(int signal) {
    using namespace std::chrono_literals;
    current_guard_.lock();
    if (folder_) {
      folder_->abandon();
    }
    std::optional<base::ProgramOutcome> kept;
    if (current_ != nullptr && current_->writes_increments()) {
      kept = stop_with_checkpoint(*current_, signal_name(signal), log_);
    }
    [[maybe_unused]] const bool whole = tables_guard_.try_lock_for(10s);
    out_.close();
    log_.report_message(
        base::Severity::note, "E551",
        fmt::format("stopped by {}; {} of {} points are finished, run again to go on",
                    signal_name(signal), done_.load(), points_.size()));
    return kept ? base::exit_code(*kept) : 128 + signal;
  }

  const RunOptions& options_;
  const CheckedDeck& deck_;
  const Log& log_;
  SweepFolder out_;
  std::vector<SweepPointValues> points_;
  results::SweepResult sweep_;
  std::atomic<std::size_t> done_{0};
  std::mutex current_guard_;
  archive::Checkpoint* current_ = nullptr; ///< of the point that is computed; guarded
  std::optional<RunFolder> folder_;        ///< of the same; guarded where it is made and ended
  std::timed_mutex tables_guard_;
};

} // namespace

std::vector<SweepPointValues> sweep_points(const model::Model& model) {
  std::vector<SweepPointValues> points{{}};
  for (const model::ParameterSweep& card : model.sweeps) {
    std::vector<SweepPointValues> more;
    for (const SweepPointValues& point : points) {
      for (const std::vector<double>& row : card.values) {
        more.push_back(point);
        for (std::size_t p = 0; p < card.parameters.size(); ++p) {
          more.back().emplace_back(card.parameters[p], row[p]);
        }
      }
    }
    points = std::move(more);
  }
  return points;
}

base::ProgramOutcome run_sweep(const RunOptions& options, const CheckedDeck& deck, const Log& log) {
  return SweepRun(options, deck, log).run();
}

} // namespace spricka::program
