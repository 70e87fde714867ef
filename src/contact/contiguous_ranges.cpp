// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contiguous_ranges.hpp"

namespace spricka::contact {

SequenceLinks SequenceLinks::link_consecutive(std::size_t count, bool ring) {
  SequenceLinks links(count);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    links.join(i, i + 1);
  }
  if (ring && count > 0) {
    links.join(count - 1, 0);
  }
  return links;
}

std::vector<std::vector<std::size_t>> contiguous_marked_ranges(const SequenceLinks& links,
                                                               const std::vector<bool>& marked,
                                                               std::size_t from) {
  const std::size_t n = marked.size();
  const auto is_marked = [&](const std::optional<std::size_t>& i) { return i && marked[*i]; };
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t first = (from + k) % n;
    if (!marked[first] || is_marked(links.last[first])) {
      continue;
    }
    std::vector<std::size_t>& places = all.emplace_back();
    places.push_back(first);
    while (is_marked(links.next[places.back()])) {
      places.push_back(*links.next[places.back()]);
    }
  }
  return all;
}

} // namespace spricka::contact
