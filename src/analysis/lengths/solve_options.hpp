// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace spricka::archive {
class IncrementStore;
}

namespace spricka::analysis {

class ProfileRecorder;

/// How far a run is; told at the end of each stage of an increment, and of the increment.
struct RunProgress {
  std::size_t increment = 0;  ///< those that are finished
  std::size_t increments = 0; ///< in all; 0: as told before
  bool open_end = false;      ///< a law ends where it will: `increments` are those begun
  std::string stage = {};     ///< what is done: "condensed", "step LOAD: K"; empty: the increment
  std::size_t step = 0;       ///< of the increment under way, those that are finished
  std::size_t steps = 0;      ///< and all that are to be solved
};

struct SolveOptions {
  int threads = 1;
  CondensationMode condensing = CondensationMode::automatic;
  solve::EquationEngine engine = solve::EquationEngine::automatic;
  /// Keeps increments, and gives back those of an earlier run.
  archive::IncrementStore* checkpoint = nullptr;
  std::function<void(const RunProgress&)> progress = {}; ///< may be empty
  /// Given the increment under way with all its steps so far, whenever there is a new K in it; may
  /// be empty.
  std::function<void(const results::CrackLengthResult&)> found = {};
  ProfileRecorder* recorder = nullptr; ///< of a profile, where one is asked for
  bool error_bars = true;              ///< false: none, and K is as the mesh has it
  bool stresses = true; ///< those of steps that outputs or the report show; false: nobody sees them
};

} // namespace spricka::analysis
