// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <numeric>
#include <vector>

namespace spricka::base {

/// Disjoint sets of things counted from 0, with path halving; the root of a set is its smallest.
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// The smallest thing of the set that holds n; shortens the path to it for later calls.
  std::size_t root(std::size_t n) {
    while (parent_[n] != n) {
      parent_[n] = parent_[parent_[n]];
      n = parent_[n];
    }
    return n;
  }
  /// Makes one set of those that hold a and b; nothing where that is one set already.
  void join_sets(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    (a < b ? parent_[b] : parent_[a]) = a < b ? a : b;
  }
  struct SetNumbers {
    std::vector<std::size_t> of; ///< [thing] its set
    std::size_t count = 0;       ///< of sets
  };
  /// The sets numbered from 0 in the order of their smallest things.
  SetNumbers set_numbers() {
    SetNumbers numbers{std::vector<std::size_t>(parent_.size()), 0};
    for (std::size_t n = 0; n < parent_.size(); ++n) {
      const std::size_t smallest = root(n);
      numbers.of[n] = smallest == n ? numbers.count++ : numbers.of[smallest];
    }
    return numbers;
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace spricka::base
