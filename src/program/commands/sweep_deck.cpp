// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/sweep_deck.hpp"

#include "base/exit_codes.hpp"
#include "base/printable.hpp"
#include "model/model.hpp"
#include "program/commands/sweep_point.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/point_record.hpp"
#include "program/job/restart_run.hpp"
#include "program/job/standard_streams.hpp"
#include "program/job/sweep_folder.hpp"
#include "report/drawing/file.hpp"
#include "report/sweep_files.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using results::SweepPoint;

class SweepRun {
public:
  SweepRun(const RunOptions& options, const CheckedDeck& deck, const Log& log)
      : options_(options), deck_(deck), log_(log), out_(canonical_folder(options.out)),
        points_(sweep_points(*deck.model)), solver_(options, deck, log, out_.path()) {
    sweep_.count = points_.size();
    for (const auto& [name, value] : points_.front()) {
      sweep_.parameters.push_back(name);
    }
  }

  /// All points, with the tables after each.
  base::ProgramOutcome run() {
    out_.open(archive::LockSharing::exclusive);
    const InterruptHandler interrupt(
        [this](int signal) { return last_words(signal).value_or(128 + signal); });
    // Else it is of an earlier sweep, until there is a point.
    if (!fs::exists(out_.path() / sweep_table_name)) {
      write_tables();
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      SweepPoint point = find_or_compute(i);
      if (point.outcome == base::ProgramOutcome::stopped) {
        return base::ProgramOutcome::stopped;
      }
      finish_point(point);
      sweep_.points.push_back(std::move(point));
      write_tables();
    }
    finish_sweep();
    return worst_;
  }

  /// The points of one task, beside the other tasks; tables are the collector's.
  base::ProgramOutcome run_task(const ArrayTask& task) {
    out_.open(archive::LockSharing::shared);
    // What is finished is kept in any case: the task that is run again goes on.
    const InterruptHandler interrupt([this](int signal) {
      return last_words(signal).value_or(base::exit_code(base::ProgramOutcome::stopped));
    });
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (task.has_run(i)) {
        own.push_back(i);
      }
    }
    std::vector<std::string> taken;
    // Points that another process has at the first try are looked at once more at the end.
    for (const bool last : {false, true}) {
      std::vector<std::size_t> left;
      for (const std::size_t i : own) {
        const SweepPoint point = find_or_compute(i);
        if (point.outcome == base::ProgramOutcome::stopped) {
          return base::ProgramOutcome::stopped;
        }
        if (point.taken) {
          left.push_back(i);
          if (last) {
            taken.push_back(point.folder);
          }
        } else {
          finish_point(point);
        }
      }
      own = std::move(left);
    }
    if (!taken.empty()) {
      log_.report_message(base::Severity::note, "E554",
                          fmt::format("another process computes {}", fmt::join(taken, ", ")));
      return base::ProgramOutcome::stopped;
    }
    say(fmt::format("task {} of {}: {} of {} points are finished in {}; spricka sweep --collect "
                    "makes the tables when all tasks have ended\n",
                    task.number, task.count, done_.load(), points_.size(),
                    base::make_printable(options_.out.string())));
    return worst_;
  }

  /// Tables of what tasks have computed, and what is missing.
  base::ProgramOutcome collect() {
    if (!fs::exists(out_.path())) {
      log_.report_message(base::Severity::error, "E553",
                          fmt::format("no task has begun: {} is not there", options_.out.string()));
      return base::ProgramOutcome::stopped;
    }
    out_.open(archive::LockSharing::shared);
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      SweepPoint point = find_point(i, true);
      if (!point.reused) {
        missing.push_back(point.folder);
        continue;
      }
      worst_ = std::max(worst_, point.outcome);
      report_failure(point);
      sweep_.points.push_back(std::move(point));
    }
    write_tables();
    if (missing.empty()) {
      finish_sweep();
      return worst_;
    }
    log_.report_message(base::Severity::error, "E553",
                        missing_runs_text(missing, points_.size(), "point", options_.out));
    return base::ProgramOutcome::stopped;
  }

private:
  [[nodiscard]] std::string folder_name(std::size_t i) const {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(points_.size()).size());
    return fmt::format("{:0{}}", i + 1, digits);
  }

  [[nodiscard]] SweepPoint find_point(std::size_t i, bool failures) const {
    const std::optional<SweepPoint> known = solver_.find(points_[i], folder_name(i), failures);
    SweepPoint point = known.value_or(SweepPoint{});
    point.number = i + 1;
    point.folder = folder_name(i);
    point.reused = known.has_value();
    for (const auto& [name, value] : points_[i]) {
      point.values.push_back(value);
    }
    return point;
  }

  SweepPoint find_or_compute(std::size_t i) {
    SweepPoint point = find_point(i, false);
    if (!point.reused) {
      solver_.compute(points_[i], point);
    }
    return point;
  }

  void finish_point(const SweepPoint& point) {
    worst_ = std::max(worst_, point.outcome);
    report_failure(point);
    tell(point);
    ++done_;
  }

  void finish_sweep() const {
    std::set<std::string> wanted;
    for (const SweepPoint& point : sweep_.points) {
      wanted.insert(point.folder);
      if (!has_results(point.outcome)) {
        wanted.insert(point.folder + failed_point_ending);
      }
    }
    out_.remove_others(wanted);
    say(fmt::format("{} points; results in {}\n", points_.size(),
                    base::make_printable(options_.out.string())));
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

  void say(const std::string& text) const {
    if (!options_.quiet) {
      write_to_stdout(text);
    }
  }

  // "003 of 12: delta = 0.042, mu = 0.15"
  [[nodiscard]] std::string head(const SweepPoint& point) const {
    return fmt::format("{} of {}: {}", point.folder, points_.size(),
                       sweep_point_text(points_[point.number - 1]));
  }

  void report_failure(const SweepPoint& point) const {
    if (point.outcome != base::ProgramOutcome::done) {
      log_.report_message(base::Severity::error, "E550",
                          fmt::format("point {}: {} ({}): {}", head(point),
                                      report::sweep_point_status(point),
                                      base::exit_code(point.outcome), point.error));
    }
  }

  void tell(const SweepPoint& point) const {
    say(fmt::format("{}: {}{}{}\n", head(point), report::sweep_point_status(point),
                    point.reused ? " earlier" : "", result_text(point)));
    std::fflush(stdout);
  }

  // The life, else K1 at the last length.
  [[nodiscard]] std::string result_text(const SweepPoint& point) const {
    const auto life = std::ranges::find(point.cells, "N", &results::SweepResultValue::quantity);
    if (life != point.cells.end()) {
      return fmt::format("  N = {:.7g}", life->value);
    }
    const std::string step = results::shown_step_name(*deck_.model, {});
    int last = 0;
    for (const results::SweepResultValue& cell : point.cells) {
      last = std::max(last, cell.increment);
    }
    std::string text;
    for (const results::SweepResultValue& cell : point.cells) {
      if (cell.quantity == "K1" && cell.step == step && cell.increment == last) {
        text += fmt::format("  K1 {} = {:.7g}", cell.name, cell.value);
      }
    }
    return text;
  }

  // On the watcher's thread, while the point goes on being computed. Its locks are not given back:
  // nothing more is written. The exit code, where increments of the point are kept.
  std::optional<int> last_words(int signal) {
    using namespace std::chrono_literals;
    const std::optional<base::ProgramOutcome> kept = solver_.abandon(signal);
    [[maybe_unused]] const bool whole = tables_guard_.try_lock_for(10s);
    out_.close();
    log_.report_message(
        base::Severity::note, "E551",
        fmt::format("stopped by {}; {} of {} points are finished, run again to go on",
                    signal_name(signal), done_.load(), points_.size()));
    return kept ? std::optional(base::exit_code(*kept)) : std::nullopt;
  }

  const RunOptions& options_;
  const CheckedDeck& deck_;
  const Log& log_;
  SweepFolder out_;
  std::vector<SweepPointValues> points_;
  SweepPointSolver solver_;
  results::SweepResult sweep_;
  base::ProgramOutcome worst_ = base::ProgramOutcome::done;
  std::atomic<std::size_t> done_{0};
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
  SweepRun sweep(options, deck, log);
  return options.collect ? sweep.collect()
         : options.array ? sweep.run_task(*options.array)
                         : sweep.run();
}

} // namespace spricka::program
