// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/join_fronts.hpp"

#include <algorithm>

namespace spricka::growth {

namespace {

enum class Meets { nowhere, at_first, at_last, inside, in_several };

// The one run of points that do not stay: the number of its first and how many.
struct MeetingPointRange {
  Meets where = Meets::nowhere;
  std::size_t begin = 0, count = 0;
  [[nodiscard]] std::size_t middle() const { return begin + count / 2; }
};

MeetingPointRange gap_of(const CoalescingFront& front) {
  const std::size_t n = front.stays.size();
  MeetingPointRange gap;
  std::size_t runs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool before = i > 0 ? front.stays[i - 1] : !front.closed || front.stays[n - 1];
    if (!front.stays[i] && before) {
      ++runs;
      gap.begin = i;
    }
    gap.count += front.stays[i] ? 0U : 1U;
  }
  if (runs == 0 || gap.count == n) {
    return {};
  }
  gap.where = runs > 1                     ? Meets::in_several
              : front.closed               ? Meets::inside
              : gap.begin == 0             ? Meets::at_first
              : gap.begin + gap.count == n ? Meets::at_last
                                           : Meets::inside;
  return gap;
}

// Points `from` to before `to`, of a closed front over its end, behind what is joined so far.
void append(const CoalescingFront& front, std::size_t from, std::size_t to,
            CoalescedFront& joined) {
  const std::size_t n = front.points.size();
  for (std::size_t i = from; i < to; ++i) {
    joined.tips.push_back(front.tips[i % n]);
    if (front.stays[i % n]) {
      joined.points.push_back(front.points[i % n]);
    }
  }
}

void append_all(const CoalescingFront& front, std::size_t from, CoalescedFront& joined) {
  append(front, from, from + front.points.size(), joined);
}

} // namespace

void CoalescingFront::reverse_order() {
  std::ranges::reverse(points);
  std::ranges::reverse(tips);
  std::reverse(stays.begin(), stays.end());
}

std::optional<CoalescedFront> coalesce_fronts(const CoalescingFront& one,
                                              const CoalescingFront& other) {
  const MeetingPointRange a = gap_of(one);
  const MeetingPointRange b = gap_of(other);
  const bool open = !one.closed && !other.closed;
  if ((one.closed && !other.closed) ||
      (open && a.where == Meets::at_first && b.where == Meets::at_last)) {
    return coalesce_fronts(other, one);
  }
  CoalescedFront joined;
  if (one.closed && other.closed && a.where == Meets::inside && b.where == Meets::inside) {
    joined.closed = true;
    append_all(one, a.middle(), joined);
    append_all(other, b.middle(), joined);
  } else if (!one.closed && other.closed && a.where == Meets::inside && b.where == Meets::inside) {
    append(one, 0, a.middle(), joined);
    append_all(other, b.middle(), joined);
    append(one, a.middle(), one.points.size(), joined);
  } else if (open && a.where == Meets::at_last && b.where == Meets::at_first) {
    append_all(one, 0, joined);
    append_all(other, 0, joined);
  } else {
    return std::nullopt;
  }
  return joined;
}

} // namespace spricka::growth
