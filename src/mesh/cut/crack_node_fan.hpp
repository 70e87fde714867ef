// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/disjoint_sets.hpp"

#include <cstddef>
#include <vector>

namespace spricka::mesh {

/// The face of a crack that an element lies at, left of it in the plane or above it in space.
enum class CrackSide { unknown, left, right, both };

/// Elements round one node of a crack, told apart by the crack: those that share a side which is
/// not on it lie at the same of its faces. Elements are known by their number, from 0.
class CrackNodeFan {
public:
  explicit CrackNodeFan(std::size_t elements)
      : together_(elements), side_(elements, CrackSide::unknown) {}

  /// An element has a side on the crack, at that face.
  void mark(std::size_t element, CrackSide side) { side_[element] = merge(side_[element], side); }
  /// Two elements share a side that is not on the crack.
  void join(std::size_t a, std::size_t b) { together_.join_sets(a, b); }

  /// The face that each lies at [element]: `both` where elements at either face hang together,
  /// which the crack then does not part; `unknown` where it has no side on what hangs together.
  [[nodiscard]] std::vector<CrackSide> sides() {
    std::vector<CrackSide> of_root(side_.size(), CrackSide::unknown);
    for (std::size_t i = 0; i < side_.size(); ++i) {
      CrackSide& side = of_root[together_.root(i)];
      side = merge(side, side_[i]);
    }
    std::vector<CrackSide> result;
    for (std::size_t i = 0; i < side_.size(); ++i) {
      result.push_back(of_root[together_.root(i)]);
    }
    return result;
  }

private:
  static CrackSide merge(CrackSide a, CrackSide b) {
    if (a == CrackSide::unknown || a == b) {
      return b;
    }
    return b == CrackSide::unknown ? a : CrackSide::both;
  }

  base::DisjointSets together_;
  std::vector<CrackSide> side_; ///< [element] of its own sides
};

} // namespace spricka::mesh
