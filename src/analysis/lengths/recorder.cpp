// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/recorder.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace spricka::analysis {

namespace {

// Where the system does not tell it is not known, which is not nothing.
std::optional<std::size_t> known(std::size_t bytes) {
  return bytes > 0 ? std::optional(bytes) : std::nullopt;
}

} // namespace

ProfileRecorder::ProfileRecorder(const base::Stopwatch& since, double cpu_before)
    : cpu_before_(cpu_before) {
  profile_.begin = since.start_time();
}

void ProfileRecorder::add_work(const std::string& processor, const std::string& text,
                               const base::Stopwatch& watch, std::optional<double> flops) {
  results::ProcessorInterval span{.processor = processor,
                                  .text = text,
                                  .begin = watch.start_time(),
                                  .end = base::steady_clock_seconds(),
                                  .cpu = watch.cpu_time(),
                                  .flops = flops,
                                  .resident = known(base::resident_memory()),
                                  .peak = known(base::peak_memory())};
  const std::scoped_lock lock(guard_);
  if (length_) {
    span.length = profile_.lengths.size();
  }
  profile_.intervals.push_back(std::move(span));
}

void ProfileRecorder::add_startup_work(const base::Stopwatch& since) {
  add_work("START", "libraries, command line", since);
  const std::scoped_lock lock(guard_);
  profile_.intervals.back().cpu = base::cpu_seconds() - cpu_before_;
}

void ProfileRecorder::add_work(std::vector<results::NetCost> nets) {
  const std::scoped_lock lock(guard_);
  for (results::NetCost& net : nets) {
    if (length_) {
      net.length = profile_.lengths.size();
    }
    profile_.nets.push_back(std::move(net));
  }
}

void ProfileRecorder::add_work(const results::MesherCost& work) {
  const std::scoped_lock lock(guard_);
  profile_.mesher.push_back(work);
}

void ProfileRecorder::begin_tolerance_round() {
  const std::scoped_lock lock(guard_);
  ++round_;
}

void ProfileRecorder::begin_length() {
  const std::scoped_lock lock(guard_);
  length_.emplace();
}

void ProfileRecorder::end_length(std::optional<double> a, bool counts) {
  const std::scoped_lock lock(guard_);
  if (length_) {
    profile_.lengths.push_back({.a = a,
                                .counts = counts,
                                .round = std::max(round_, 1),
                                .begin = length_->start_time(),
                                .end = base::steady_clock_seconds(),
                                .cpu = length_->cpu_time()});
    length_.reset();
  }
}

results::RunProfile ProfileRecorder::finish() {
  const std::scoped_lock lock(guard_);
  profile_.end = base::steady_clock_seconds();
  profile_.cpu = base::cpu_seconds() - cpu_before_;
  profile_.peak = known(base::peak_memory());
  return std::move(profile_);
}

// What there is no memory to take down is left out: the run has other troubles then.
ScopedProfileInterval::~ScopedProfileInterval() {
  try {
    if (recorder_ != nullptr) {
      recorder_->add_work(processor_, text_, watch_);
    }
  } catch (const std::exception&) {
    recorder_ = nullptr;
  }
}

ScopedProfileCrackLength::ScopedProfileCrackLength(ProfileRecorder* recorder)
    : recorder_(recorder) {
  if (recorder_ != nullptr) {
    recorder_->begin_length();
  }
}

ScopedProfileCrackLength::~ScopedProfileCrackLength() {
  try {
    if (recorder_ != nullptr) {
      recorder_->end_length(a_, counts_);
    }
  } catch (const std::exception&) {
    recorder_ = nullptr;
  }
}

} // namespace spricka::analysis
