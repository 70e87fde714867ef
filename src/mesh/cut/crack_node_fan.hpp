// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/disjoint_sets.hpp"

#include <cstddef>
#include <vector>

namespace spricka::mesh {

/// The face of a crack that an element lies at, left of it in the plane or above it in space.
enum class CrackFaceOfElement { unknown, left, right, both };

/// Elements round one node of a crack, told apart by the crack: those that share a side which is
/// not on it lie at the same of its faces. Elements are known by their number, from 0.
class CrackNodeFan {
public:
  explicit CrackNodeFan(std::size_t elements)
      : together_(elements), side_(elements, CrackFaceOfElement::unknown) {}

  /// An element has a side on the crack, at that face.
  void add_side_on_crack(std::size_t element, CrackFaceOfElement side) {
    side_[element] = merge(side_[element], side);
  }
  /// Two elements share a side that is not on the crack.
  void join_elements(std::size_t a, std::size_t b) { together_.join_sets(a, b); }

  /// The face that each lies at [element]: `both` where elements at either face hang together,
  /// which the crack then does not part; `unknown` where it has no side on what hangs together.
  [[nodiscard]] std::vector<CrackFaceOfElement> crack_face_of_each_element() {
    std::vector<CrackFaceOfElement> of_root(side_.size(), CrackFaceOfElement::unknown);
    for (std::size_t i = 0; i < side_.size(); ++i) {
      CrackFaceOfElement& side = of_root[together_.root(i)];
      side = merge(side, side_[i]);
    }
    std::vector<CrackFaceOfElement> result;
    for (std::size_t i = 0; i < side_.size(); ++i) {
      result.push_back(of_root[together_.root(i)]);
    }
    return result;
  }

private:
  static CrackFaceOfElement merge(CrackFaceOfElement a, CrackFaceOfElement b) {
    if (a == CrackFaceOfElement::unknown || a == b) {
      return b;
    }
    return b == CrackFaceOfElement::unknown ? a : CrackFaceOfElement::both;
  }

  base::DisjointSets together_;
  std::vector<CrackFaceOfElement> side_; ///< [element] of its own sides
};

} // namespace spricka::mesh
