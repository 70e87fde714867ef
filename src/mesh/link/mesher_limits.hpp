// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace spricka::mesh {

/// What the meshing of one file may take.
struct MesherLimits {
  double seconds = 12.0;  ///< of processor time; a quarter of it for reading a script
  std::size_t memory = 0; ///< [bytes] beyond what the mesher has at its start

  [[nodiscard]] double reading() const { return 0.25 * seconds; }
  /// Of the clock on the wall: on a machine with other work processor time takes longer.
  [[nodiscard]] double wall() const { return 10.0 * seconds + 10.0; }
  [[nodiscard]] double wall_of_reading() const { return seconds > 10.0 ? seconds : 10.0; }
};

/// Those of this process. From the start: 12 s, and a quarter of the machine's memory, at least
/// 2 GiB. Set before anything is meshed.
MesherLimits& mesher_limits();

} // namespace spricka::mesh
