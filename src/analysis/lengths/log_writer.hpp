// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/clock.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// Writes lines of the processor log, each with the time since the one before.
class LogWriter {
public:
  explicit LogWriter(std::vector<results::LogLine>& lines) : lines_(lines) {}
  void add(const std::string& processor, const std::string& text) {
    lines_.push_back(
        {.processor = processor, .text = text, .cpu = watch_.cpu(), .wall = watch_.wall()});
    watch_ = base::Stopwatch();
  }

private:
  std::vector<results::LogLine>& lines_;
  base::Stopwatch watch_;
};

} // namespace spricka::analysis
