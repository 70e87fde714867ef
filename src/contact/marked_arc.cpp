// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/marked_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::contact {

namespace {

// End of contact between a closed and an open neighbour: p^2 falls linearly (square-root law).
double contact_end(double s_inner, double p_inner, double s_last, double p_last, double s_open) {
  const double fall = p_inner * p_inner - p_last * p_last;
  if (fall <= 0.0) {
    return 0.5 * (s_last + s_open);
  }
  const double end = s_last + (s_last - s_inner) * p_last * p_last / fall;
  return std::clamp(end, std::min(s_last, s_open), std::max(s_last, s_open));
}

} // namespace

Arc marked_arc(std::vector<ArcNode> p, bool round) {
  std::stable_sort(p.begin(), p.end(),
                   [](const ArcNode& a, const ArcNode& b) { return a.s < b.s; });
  const std::size_t n = p.size();
  const auto closed = static_cast<std::size_t>(
      std::count_if(p.begin(), p.end(), [](const ArcNode& q) { return q.in; }));
  constexpr double pi = std::numbers::pi;
  if (closed == n && n > 0) {
    return round && n > 2 && p[n - 1].s - p[0].s > 1.5 * pi ? Arc{-pi, pi}
                                                            : Arc{p[0].s, p[n - 1].s};
  }
  const auto coordinate = [&](std::size_t i) {
    return p[i % n].s + 2.0 * pi * static_cast<double>(round ? i / n : 0);
  };
  Arc best;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool begins = p[i].in && (i > 0 ? !p[i - 1].in : !(round && p[n - 1].in));
    if (!begins) {
      continue;
    }
    std::size_t j = i;
    while ((round || j + 1 < n) && p[(j + 1) % n].in) {
      ++j;
    }
    if (j - i + 1 <= longest) {
      continue;
    }
    longest = j - i + 1;
    best = {coordinate(i), coordinate(j)};
    if (j > i && (round || i > 0)) {
      const double open = i > 0 ? coordinate(i - 1) : p[n - 1].s - 2.0 * pi;
      best.from = contact_end(coordinate(i + 1), p[(i + 1) % n].strength, coordinate(i),
                              p[i].strength, open);
    }
    if (j > i && (round || j + 1 < n)) {
      best.to = contact_end(coordinate(j - 1), p[(j - 1) % n].strength, coordinate(j),
                            p[j % n].strength, coordinate(j + 1));
    }
  }
  if (round && best.to > pi && best.from > 0.0 && best.from >= pi) {
    best = {best.from - 2.0 * pi, best.to - 2.0 * pi};
  }
  return best;
}

} // namespace spricka::contact
