// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/clock.hpp"
#include "results/run_profile.hpp"

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Takes down what a run costs while it goes along. Stretches come from the main thread, one after
/// another; requests to the mesher may come from any.
class ProfileRecorder {
public:
  /// From where `since` was started; `cpu_before` [s] of the process are not the run's.
  explicit ProfileRecorder(const base::Stopwatch& since, double cpu_before);

  /// What was done since `watch` was started, and up to now.
  void add_work(const std::string& processor, const std::string& text, const base::Stopwatch& watch,
                std::optional<double> flops = {});
  /// What was before all else, since the process began.
  void add_startup_work(const base::Stopwatch& since);
  /// Nets of the length that is worked on.
  void add_work(std::vector<results::NetCost> nets);
  /// The cost of one call of the mesher.
  void add_work(const results::MesherCost& work);
  /// The lengths of a deck again, on a finer mesh.
  void begin_tolerance_round();
  void begin_length();
  /// The length that was begun last; one that came to no solution has no `a`.
  void end_length(std::optional<double> a, bool counts);

  /// All of it, up to now; the run is over.
  [[nodiscard]] results::RunProfile finish();

private:
  std::mutex guard_;
  results::RunProfile profile_;
  double cpu_before_;
  int round_ = 0;
  std::optional<base::Stopwatch> length_; ///< empty: between lengths
};

/// A stretch from its construction to its end; with a null recorder nothing at all.
class ScopedProfileInterval {
public:
  ScopedProfileInterval(ProfileRecorder* recorder, const char* processor, const char* text)
      : recorder_(recorder), processor_(processor), text_(text) {}
  ~ScopedProfileInterval();
  ScopedProfileInterval(const ScopedProfileInterval&) = delete;
  ScopedProfileInterval& operator=(const ScopedProfileInterval&) = delete;

private:
  ProfileRecorder* recorder_;
  const char* processor_;
  const char* text_;
  base::Stopwatch watch_;
};

/// A crack length from its construction to its end; with a null recorder nothing at all.
class ScopedProfileCrackLength {
public:
  explicit ScopedProfileCrackLength(ProfileRecorder* recorder);
  ~ScopedProfileCrackLength();
  ScopedProfileCrackLength(const ScopedProfileCrackLength&) = delete;
  ScopedProfileCrackLength& operator=(const ScopedProfileCrackLength&) = delete;
  /// Notes the crack length [length], which is known when the length has a solution.
  void set_length(double a) { a_ = a; }
  /// It is an increment of the run.
  void mark_increment() { counts_ = true; }

private:
  ProfileRecorder* recorder_;
  std::optional<double> a_;
  bool counts_ = false;
};

} // namespace spricka::analysis
