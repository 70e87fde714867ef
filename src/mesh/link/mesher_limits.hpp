// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace spricka::mesh {

/// What the meshing of one file may take.
struct MesherLimits {
  double seconds = 12.0;  ///< of processor time; a quarter of it for reading a script
  std::size_t memory = 0; ///< [bytes] beyond what the mesher has at its start

  [[nodiscard]] double script_reading_seconds() const { return 0.25 * seconds; }
  /// Of waiting without a wish for a processor [s]: it has nothing to wait for.
  double waiting = 60.0;
};

/// Those of this process. From the start: 12 s, and a quarter of the machine's memory, at least
/// 2 GiB. Set before anything is meshed.
MesherLimits& mesher_limits();

} // namespace spricka::mesh
