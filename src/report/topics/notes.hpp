// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/note.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// Notes of the run that differ by their numbers only, as one.
struct RepeatedNote {
  std::string where; ///< "increment 3, step LOAD" of the first
  results::Note first;
  int times = 1;
  std::string last; ///< where the last one is, if there are more
};

/// All notes of increments, steps, load paths and tests, in the order of their first appearance.
std::vector<RepeatedNote> collect_notes(const results::RunResult& run);

/// "increment 1, step LOAD: text (alike 11 more times, last in increment 6, step LOAD)".
std::string repeated_note_text(const RepeatedNote& note);

} // namespace spricka::report
