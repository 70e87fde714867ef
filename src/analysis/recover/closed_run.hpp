// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace spricka::analysis {

/// The longest run of closed pairs in their order along a surface.
class LongestClosedContactRange {
public:
  /// place [pair]: angles [rad] where `round`, else lengths along the surface.
  LongestClosedContactRange(std::vector<double> place, bool round);

  /// Places of its first and last pair; on a circle the last may lie behind pi, a full circle is
  /// -pi .. pi. Zeros when nothing is closed.
  [[nodiscard]] std::pair<double, double> find(const std::vector<bool>& closed) const;

private:
  [[nodiscard]] double at(std::size_t i) const;

  std::vector<double> place_;
  std::vector<std::size_t> order_;
  bool round_;
};

} // namespace spricka::analysis
