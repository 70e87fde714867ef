// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::solve {

/// Speed of one core in dense algebra on this machine now, measured with products of two sizes.
struct FlopRate {
  double measured = 0.0; ///< [flop/s] of the larger product
  double peak = 0.0;     ///< [flop/s] of large blocks, extrapolated
  double half = 0.0;     ///< block size at which half of it is reached

  /// [flop/s] where blocks have this size.
  [[nodiscard]] double at(double size) const { return peak * size / (size + half); }
};

/// Takes about `seconds`; single-threaded.
FlopRate measure_flop_rate(double seconds);

} // namespace spricka::solve
