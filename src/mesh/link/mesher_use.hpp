// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>

namespace spricka::mesh {

/// What one request to the mesher took.
struct MesherUsage {
  double begin = 0.0, end = 0.0;   ///< base::moment() [s], its start by this request included
  std::optional<double> cpu;       ///< [s] of processor time; empty: it is gone
  std::optional<std::size_t> peak; ///< [bytes] its largest resident set so far; empty: not told
};

/// Is told of every request to the mesher, when it is answered, from the thread that asked; empty,
/// as from the start: nobody is. Set it while nothing is meshed.
std::function<void(const MesherUsage&)>& mesher_listener();

} // namespace spricka::mesh
