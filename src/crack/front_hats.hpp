// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <cstddef>
#include <vector>

namespace spricka::crack {

/// Which points a place of the front belongs to, and how much.
struct FrontHatWeights {
  std::size_t low = 0, high = 0; ///< points on both sides of it
  double part = 0.0;             ///< of `high`; the rest is that of `low`
};

/// The hat functions of the points of a front, linear between them along its curve.
class FrontHats {
public:
  /// `closed`: the last point joins the first. The front's curve must outlive it.
  FrontHats(const mesh::CrackFront& front, bool closed);

  /// Places of the points on the curve, from the first point on [point] [length].
  [[nodiscard]] const std::vector<double>& stations() const { return stations_; }
  /// Between which points a place of the curve is [length]; round-off takes no node of one point's
  /// section to the next.
  [[nodiscard]] FrontHatWeights hat_weights_at(double s) const;

private:
  [[nodiscard]] double along_front(double s) const;

  const mesh::FrontCurve& curve_;
  bool closed_;
  double origin_; ///< of the stations, on the curve
  std::vector<double> stations_;
};

} // namespace spricka::crack
