// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/progress_line.hpp"

#include "program/job/standard_streams.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace spricka::program {

namespace {

using Json = nlohmann::ordered_json;

/// Between two lines of a log [s]: runs that are over sooner say nothing.
constexpr double line_every = 30.0;

std::string in_words(std::optional<double> left, bool of_increment) {
  if (!left) {
    return "";
  }
  const std::string_view of = of_increment ? " of this increment" : "";
  return *left < 120.0 ? fmt::format(", about {:.0f} s left{}", *left, of)
                       : fmt::format(", about {:.0f} min left{}", *left / 60.0, of);
}

} // namespace

void RemainingTime::begin_increment(double now) {
  begun_ = now;
  first_step_ = now;
  step_ended_ = now;
  step_ = 0;
}

void RemainingTime::record_progress(const analysis::RunProgress& progress, double now) {
  if (progress.increments > 0) {
    increments_ = progress.increments;
  }
  if (progress.stage.empty()) {
    increment_ = progress.increment;
    took_ += under_way_ ? now - begun_ : 0.0;
    solved_ += under_way_ ? 1 : 0;
    under_way_ = false;
    begin_increment(now);
    return;
  }
  if (!under_way_ && solved_ == 0) {
    begin_increment(now);
  }
  under_way_ = true;
  if (progress.steps == 0) {
    first_step_ = now; // what comes before the steps
    step_ended_ = now;
    step_ = 0;
  } else {
    steps_ = progress.steps;
    step_ended_ = progress.step > step_ ? now : step_ended_;
    step_ = progress.step;
  }
}

std::optional<double> RemainingTime::seconds(double now) const {
  if (step_ == 0 && solved_ == 0) {
    return std::nullopt;
  }
  const double each = step_ > 0 ? (step_ended_ - first_step_) / static_cast<double>(step_) : 0.0;
  const double this_one = first_step_ - begun_ + each * static_cast<double>(steps_);
  const double usual = solved_ > 0 ? took_ / static_cast<double>(solved_) : this_one;
  if (increment_ >= increments_) {
    return 0.0;
  }
  const double rest = (step_ > 0 ? this_one : usual) - (now - begun_);
  return std::max(0.0, rest) + usual * static_cast<double>(increments_ - increment_ - 1);
}

ProgressLine::ProgressLine(LogFormat format, bool quiet)
    : kind_(quiet                        ? ProgressOutput::none
            : format == LogFormat::json  ? ProgressOutput::json
            : isatty(STDERR_FILENO) != 0 ? ProgressOutput::terminal
                                         : ProgressOutput::lines) {}

ProgressLine::~ProgressLine() {
  if (width_ > 0) {
    write_to_stderr("\n");
  }
}

void ProgressLine::show(const std::string& text) {
  const std::size_t width = std::max(text.size(), width_); // covers what was longer before
  write_to_stderr(fmt::format("\r{:<{}}", text, width));
  width_ = width;
}

void ProgressLine::report_progress(const analysis::RunProgress& progress) {
  const double now = watch_.wall_time();
  left_.record_progress(progress, now);
  open_end_ = progress.increments > 0 ? progress.open_end : open_end_;
  const std::optional<double> left = left_.seconds(now);
  const bool ends = progress.stage.empty();
  if (kind_ == ProgressOutput::json && (ends || progress.steps > 0)) {
    Json record{{"type", ends ? "progress" : "stage"},
                {"increment", left_.finished_increments()},
                {"of", left_.total_increments()}};
    if (!ends) {
      record.update(
          {{"stage", progress.stage}, {"step", progress.step}, {"steps", progress.steps}});
    }
    record["seconds_left"] = left ? Json(*left) : Json();
    write_to_stderr(record.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  }
  if (kind_ != ProgressOutput::terminal &&
      (kind_ != ProgressOutput::lines || now - reported_ < line_every)) {
    return;
  }
  std::string text =
      fmt::format("  increment {}{}: {}", left_.finished_increments() + (ends ? 0 : 1),
                  open_end_ ? "" : fmt::format(" of {}", left_.total_increments()),
                  ends ? "done" : progress.stage);
  if (progress.steps > 0) {
    text += fmt::format(", {} of {} steps done", progress.step, progress.steps);
  }
  text += ends && open_end_ ? "" : in_words(left, open_end_);
  if (kind_ == ProgressOutput::terminal) {
    show(text);
  } else {
    write_to_stderr(fmt::format("{}, {:.0f} s so far\n", text, now));
  }
  reported_ = now;
}

} // namespace spricka::program
