// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"

#include <cstddef>
#include <functional>

namespace spricka::archive {
class Checkpoint;
}

namespace spricka::analysis {

class Recorder;

struct SolveOptions {
  int threads = 1;
  Condensing condensing = Condensing::automatic;
  /// Keeps increments, and gives back those of an earlier run.
  archive::Checkpoint* checkpoint = nullptr;
  std::function<void(std::size_t done, std::size_t all)> progress; ///< may be empty
  Recorder* recorder = nullptr; ///< of a profile, where one is asked for
};

} // namespace spricka::analysis
