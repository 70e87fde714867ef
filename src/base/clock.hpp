// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <cstddef>

namespace spricka::base {

/// CPU time of the whole process, all threads [s].
double cpu_seconds();

/// Makes the allocator give large freed blocks back to the system at once: matrices come and go,
/// and the peak should not remember them all. Call once, at the start of the program.
void return_large_blocks();

/// Gives freed memory back to the system; worth its milliseconds after a stage that took many small
/// blocks (meshing).
void return_free_memory();

/// Largest resident set of the process so far [bytes].
std::size_t peak_memory();

/// Resident set of the process now [bytes]; 0 where the system does not tell.
std::size_t resident_memory();

/// Measures a stretch of the run; both times start at construction.
class Stopwatch {
public:
  [[nodiscard]] double cpu() const { return cpu_seconds() - cpu_; }
  [[nodiscard]] double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }

private:
  double cpu_ = cpu_seconds();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

} // namespace spricka::base
