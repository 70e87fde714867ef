// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/solve_options.hpp"
#include "base/clock.hpp"
#include "program/job/log_format.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace spricka::program {

/// Seconds that are left of a run, from what its steps and crack lengths have taken so far.
class RemainingTime {
public:
  /// `now` [s] of any clock.
  void record_progress(const analysis::RunProgress& progress, double now);
  /// [s]; empty until the first step or increment is finished.
  [[nodiscard]] std::optional<double> seconds(double now) const;
  [[nodiscard]] std::size_t total_increments() const { return increments_; }
  [[nodiscard]] std::size_t finished_increments() const { return increment_; }

private:
  void begin_increment(double now);

  std::size_t increment_ = 0, increments_ = 0; ///< finished, and all
  std::size_t step_ = 0, steps_ = 0;           ///< the same in the increment under way
  double begun_ = 0.0;                         ///< [s] the increment under way
  double first_step_ = 0.0;                    ///< [s] when its first step began
  double step_ended_ = 0.0;                    ///< [s] the last that is finished
  double took_ = 0.0;                          ///< [s] all that were solved and are finished
  std::size_t solved_ = 0;                     ///< so many: others were taken over
  bool under_way_ = false;                     ///< a stage of an increment has been told
};

/// Tells how far a run is: on a terminal in one line that changes, in a log a line every half
/// minute, as JSON a record for each step and increment.
class ProgressLine {
public:
  ProgressLine(LogFormat format, bool quiet);
  ~ProgressLine(); ///< ends the line of a terminal
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Takes what the analysis says of itself and shows it, if it is time to. An empty stage ends an
  /// increment.
  void report_progress(const analysis::RunProgress& progress);

private:
  enum class ProgressOutput { none, terminal, lines, json };
  void show(const std::string& text);

  ProgressOutput kind_;
  base::Stopwatch watch_;
  RemainingTime left_;
  bool open_end_ = false; ///< how many increments there will be is not known
  double reported_ = 0.0; ///< [s] when the last line was written
  std::size_t width_ = 0; ///< of the terminal's line; 0: none is open
};

} // namespace spricka::program
