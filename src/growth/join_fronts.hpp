// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::growth {

/// A front that meets another one: its points in the order of t = m x b, and which of them stay.
/// The others are where the two meet.
struct CoalescingFront {
  std::vector<base::Vec3> points;
  std::vector<std::size_t> tips; ///< [point]
  std::vector<bool> stays;       ///< [point]
  bool closed = false;

  /// The same front in the order for a normal that points the other way.
  void reverse_order();
};

/// The front of both cracks together.
struct CoalescedFront {
  std::vector<base::Vec3> points; ///< those that stay
  std::vector<std::size_t> tips;  ///< all of both, in the order along it
  bool closed = false;
};

/// From where one front stops the other goes on: two closed ones become one, a closed one opens the
/// middle of one between surfaces, two beside one another on a surface follow each other. Empty:
/// they meet otherwise, and what is left would be several fronts.
std::optional<CoalescedFront> coalesce_fronts(const CoalescingFront& one,
                                              const CoalescingFront& other);

} // namespace spricka::growth
