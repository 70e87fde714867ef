// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

/// Stretches of marked places along lines and rings: closed parts of contact, sticking ones.
namespace spricka::contact {

/// The place that follows each one and the one before.
struct SequenceLinks {
  std::vector<std::optional<std::size_t>> next, last;

  explicit SequenceLinks(std::size_t count) : next(count), last(count) {}
  /// Places in the order of their numbers; `ring`: the first follows the last.
  static SequenceLinks link_consecutive(std::size_t count, bool ring);
  void join(std::size_t a, std::size_t b) {
    next[a] = b;
    last[b] = a;
  }
};

/// Marked places one behind the other, as long as they go, each by its places. They come in the
/// order in which they begin, places counted from `from` on, round to it. A ring marked all round
/// begins nowhere and is none.
std::vector<std::vector<std::size_t>> contiguous_marked_ranges(const SequenceLinks& links,
                                                               const std::vector<bool>& marked,
                                                               std::size_t from = 0);

} // namespace spricka::contact
