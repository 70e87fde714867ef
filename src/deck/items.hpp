// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "deck/set_finder.hpp"

#include <vector>

namespace spricka::deck {

/// Indices, each at most once, in the order they came.
class OrderedIndexSet {
public:
  explicit OrderedIndexSet(std::size_t count) : place_(count, 0) {}

  /// Puts an index at the end; one that is in the collection already stays where it is.
  void add(std::size_t i) {
    if (place_[i] == 0) {
      listed_.push_back(i);
      place_[i] = listed_.size();
    }
  }
  /// Takes an index out; it may be added again, then at the end.
  void remove(std::size_t i) { place_[i] = 0; }

  /// The indices that are in, in the order in which they were added last.
  [[nodiscard]] std::vector<std::size_t> collected_indices() const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < listed_.size(); ++k) {
      if (place_[listed_[k]] == k + 1) { // else it was removed, and perhaps added again later
        result.push_back(listed_[k]);
      }
    }
    return result;
  }

private:
  std::vector<std::size_t> place_; ///< in `listed_`, counted from 1; 0: not in
  std::vector<std::size_t> listed_;
};

/// Adds what the data lines of a card name, numbers, ranges and sets of nodes or elements, and
/// removes what -SET takes away. False if an item is not understood; the others are collected all
/// the same.
bool read_listed_members(DeckContext& context, const CheckedCard& card, EntityKind kind,
                         const SetFinder& sets, OrderedIndexSet& collection);

} // namespace spricka::deck
