// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/recorder.hpp"
#include "base/clock.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::analysis {

/// Writes lines of the processor log, each with the time since the one before, and the same into a
/// profile where one is recorded.
class LogWriter {
public:
  explicit LogWriter(std::vector<results::LogLine>& lines, ProfileRecorder* recorder = nullptr)
      : lines_(lines), recorder_(recorder) {}
  /// A line of the log with CPU and wall time since the one before; the profile has it with `flops`
  /// too.
  void add_line(const std::string& processor, const std::string& text,
                std::optional<double> flops = {}) {
    lines_.push_back({.processor = processor,
                      .text = text,
                      .cpu = watch_.cpu_time(),
                      .wall = watch_.wall_time()});
    record_in_profile(processor, text, flops);
  }
  /// The same for the profile alone: what the listing does not tell.
  void record_in_profile(const std::string& processor, const std::string& text,
                         std::optional<double> flops = {}) {
    if (recorder_ != nullptr) {
      recorder_->add_work(processor, text, watch_, flops);
    }
    watch_ = base::Stopwatch();
  }
  /// What was done by nets since the line before.
  void record_net_costs(std::vector<results::NetCost> nets) {
    if (recorder_ != nullptr) {
      recorder_->add_work(std::move(nets));
    }
  }

private:
  std::vector<results::LogLine>& lines_;
  ProfileRecorder* recorder_;
  base::Stopwatch watch_;
};

} // namespace spricka::analysis
