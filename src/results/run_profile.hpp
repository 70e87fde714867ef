// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What a run cost, as it went along: kept only where a profile is asked for. Moments are those of
/// base::moment(); what is not known is left empty.
namespace spricka::results {

/// From one moment to another on the main thread, in one processor of the listing.
struct ProcessorInterval {
  std::string processor; ///< TOPOLOGY, CONTACT, ...
  std::string text;
  double begin = 0.0, end = 0.0;            ///< moments [s]
  double cpu = 0.0;                         ///< [s] of the process, all of its threads
  std::optional<double> flops = {};         ///< those that were counted, of what was solved
  std::optional<std::size_t> length = {};   ///< of RunProfile::lengths
  std::optional<std::size_t> resident = {}; ///< [bytes] at its end
  std::optional<std::size_t> peak = {};     ///< [bytes] of the process until its end
};

/// A net, condensed or found again.
struct NetCost {
  std::string name; ///< the body's; of its nets "LUG: rest" and "LUG: region", "A+B: A"
  std::int64_t freedoms = 0, externals = 0;
  std::optional<double> entries = {}; ///< nonzeros of its factor
  std::optional<double> flops = {};   ///< of its condensation
  std::string engine = {};            ///< other than Cholesky in core: which, and why; empty: that
  bool reused = false;                ///< found again: what follows is 0
  bool beside = false;                ///< condensed on another thread than the main one
  double begin = 0.0, assembled = 0.0, end = 0.0; ///< moments [s]: stiffness, then condensation
  double stiffness_cpu = 0.0, analysis_cpu = 0.0, numeric_cpu = 0.0; ///< [s] of its thread
  std::optional<std::size_t> length = {};                            ///< of RunProfile::lengths
};

/// All that was done for one crack length.
struct CrackLengthCost {
  std::optional<double> a = {};  ///< crack length; empty: it came to no solution
  bool counts = false;           ///< an increment of the run; else one that was tried
  int round = 1;                 ///< with a tolerance of K: which of the rounds it belongs to
  double begin = 0.0, end = 0.0; ///< moments [s]
  double cpu = 0.0;              ///< [s] of the process
};

/// A request to the mesher, which is a process of its own.
struct MesherCost {
  double begin = 0.0, end = 0.0;        ///< moments [s]
  std::optional<double> cpu = {};       ///< [s] of the mesher
  std::optional<std::size_t> peak = {}; ///< [bytes] of the mesher until then
};

struct RunProfile {
  double begin = 0.0, end = 0.0; ///< moments [s]
  double cpu = 0.0;              ///< [s] of the process, in all
  std::vector<ProcessorInterval> intervals;
  std::vector<NetCost> nets;
  std::vector<CrackLengthCost> lengths;
  std::vector<MesherCost> mesher;
  std::optional<std::size_t> peak = {}; ///< [bytes] of the process
};

} // namespace spricka::results
