// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace spricka::base {

/// CPU time of the whole process, all threads [s].
double cpu_seconds();

/// Makes the allocator give large freed blocks back to the system at once: matrices come and go,
/// and the peak should not remember them all. Call once, at the start of the program.
void return_large_blocks_on_free();

/// Gives freed memory back to the system; worth its milliseconds after a stage that took many small
/// blocks (meshing).
void return_free_memory_to_system();

/// Largest resident set of the process so far [bytes]: of what it is itself, without the peak of
/// the process that started it.
std::size_t peak_memory();

/// The same of another process, by its number, or of this one, "self"; empty where the system does
/// not tell: it may have ended.
std::optional<std::size_t> peak_memory_of_process(const std::string& process);

/// Resident set of the process now [bytes]; 0 where the system does not tell.
std::size_t resident_memory();

/// The steady clock [s]; its origin is the same throughout the process.
double steady_clock_seconds();

/// Measures a stretch of the run; both times start at construction.
class Stopwatch {
public:
  [[nodiscard]] double cpu_time() const { return cpu_seconds() - cpu_; }
  [[nodiscard]] double wall_time() const { return steady_clock_seconds() - begun_; }
  /// When it was started, as steady_clock_seconds() has it [s].
  [[nodiscard]] double start_time() const { return begun_; }

private:
  double cpu_ = cpu_seconds();
  double begun_ = steady_clock_seconds();
};

} // namespace spricka::base
