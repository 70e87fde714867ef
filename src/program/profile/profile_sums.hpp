// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/run_profile.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What a profile adds up to.
namespace spricka::program {

/// All intervals of a processor. STIFFNESS is what nets took of CONDENSE; MESHER is a process of
/// its own, and the time that the program waits for it is not that of who asked.
struct ProcessorCostSum {
  std::string processor;
  std::size_t calls = 0;
  std::optional<double> cpu = 0.0;     ///< [s]
  double wall = 0.0;                   ///< [s]
  std::optional<double> flops = {};    ///< those that were counted; empty: none was
  bool all_counted = true;             ///< of all calls
  double counted_cpu = 0.0;            ///< [s] of the calls whose flops were counted
  std::optional<std::size_t> resident; ///< [bytes] the largest at the end of a call
  std::optional<std::size_t> peak;     ///< [bytes] of the process until the last call's end
  std::optional<std::size_t> raised;   ///< [bytes] by which its calls have raised that peak
};

struct ProcessorCostTable {
  std::vector<ProcessorCostSum> rows; ///< in the order of the listing
  double program_cpu = 0.0;           ///< [s] of the program in all
  std::optional<double> mesher_cpu = 0.0;
  double wall = 0.0;     ///< [s] from begin to end
  double cpu_rest = 0.0; ///< [s] of the program that no row accounts for
  double wall_rest = 0.0;
  std::optional<std::size_t> peak;

  /// Program and mesher, as far as it is known [s].
  [[nodiscard]] double total_cpu() const { return program_cpu + mesher_cpu.value_or(0.0); }
};
/// Sums of the profile by processor, with what no processor accounts for.
ProcessorCostTable processor_costs(const results::RunProfile& profile);

/// All that was done for the net of one name.
struct NetCostSum {
  std::string name;
  std::int64_t freedoms = 0, externals = 0; ///< the most
  std::optional<double> entries;            ///< the most
  std::size_t condensed = 0, reused = 0;
  std::optional<double> flops; ///< empty: those of one were not counted
  double stiffness_cpu = 0.0, analysis_cpu = 0.0, numeric_cpu = 0.0; ///< [s]
};
/// In the order in which they came first.
std::vector<NetCostSum> net_costs(const results::RunProfile& profile);

/// What was done for one crack length.
struct CrackLengthCostSum {
  std::string label; ///< "increment 2", "tried"; with a tolerance of K "round 2: increment 1"
  const results::CrackLengthCost* work = nullptr;
  std::optional<double> mesher_cpu = 0.0;     ///< [s]
  std::optional<double> flops = 0.0;          ///< of its nets
  std::vector<std::string> condensed, reused; ///< nets
};
/// Sums for each crack length in their order; lengths that became no increment are "tried".
std::vector<CrackLengthCostSum> crack_length_costs(const results::RunProfile& profile);

} // namespace spricka::program
