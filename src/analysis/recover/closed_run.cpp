// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/closed_run.hpp"

#include "contact/contiguous_ranges.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace spricka::analysis {

LongestClosedContactRange::LongestClosedContactRange(std::vector<double> place, bool round)
    : place_(std::move(place)), round_(round) {
  order_.resize(place_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return place_[i]; });
}

std::pair<double, double> LongestClosedContactRange::find(const std::vector<bool>& closed) const {
  const std::size_t n = order_.size();
  const auto is_closed = [&](std::size_t i) { return closed[order_[i % n]]; };
  std::size_t open = 0;
  while (open < n && is_closed(open)) {
    ++open;
  }
  if (n == 0) {
    return {0.0, 0.0};
  }
  if (open == n) {
    return round_ ? std::pair(-std::numbers::pi, std::numbers::pi)
                  : std::pair(place_[order_[0]], place_[order_[n - 1]]);
  }
  // begin behind an open pair of a circle, at the end of a line
  const std::size_t first = round_ ? open + 1 : 0;
  std::vector<bool> in_order;
  for (std::size_t i = 0; i < n; ++i) {
    in_order.push_back(is_closed(i));
  }
  std::size_t best = 0;
  std::size_t length = 0;
  for (const std::vector<std::size_t>& places : contact::contiguous_marked_ranges(
           contact::SequenceLinks::link_consecutive(n, round_), in_order, first)) {
    if (places.size() > length) {
      length = places.size();
      best = places.front() < first ? places.front() + n : places.front();
    }
  }
  if (length == 0) {
    return {0.0, 0.0};
  }
  const double from = at(best);
  const double to = at(best + length - 1);
  // Angles begin within one turn from -pi, as those of nodes do.
  const double turn = from >= std::numbers::pi ? 2.0 * std::numbers::pi : 0.0;
  return {from - turn, to - turn};
}

double LongestClosedContactRange::at(std::size_t i) const {
  const std::size_t n = order_.size();
  const std::size_t turns = round_ ? i / n : 0;
  return place_[order_[i % n]] + 2.0 * std::numbers::pi * static_cast<double>(turns);
}

} // namespace spricka::analysis
