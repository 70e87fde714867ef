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

Arc marked_arc(std::vector<ArcNode> nodes, bool round) {
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const ArcNode& a, const ArcNode& b) { return a.s < b.s; });
  const std::size_t n = nodes.size();
  const auto closed = static_cast<std::size_t>(
      std::count_if(nodes.begin(), nodes.end(), [](const ArcNode& q) { return q.in; }));
  constexpr double pi = std::numbers::pi;
  if (closed == n && n > 0) {
    return round && n > 2 && nodes[n - 1].s - nodes[0].s > 1.5 * pi
               ? Arc{-pi, pi}
               : Arc{nodes[0].s, nodes[n - 1].s};
  }
  const auto coordinate = [&](std::size_t i) {
    return nodes[i % n].s + 2.0 * pi * static_cast<double>(round ? i / n : 0);
  };
  Arc best;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool begins = nodes[i].in && (i > 0 ? !nodes[i - 1].in : !(round && nodes[n - 1].in));
    if (!begins) {
      continue;
    }
    std::size_t j = i;
    while ((round || j + 1 < n) && nodes[(j + 1) % n].in) {
      ++j;
    }
    if (j - i + 1 <= longest) {
      continue;
    }
    longest = j - i + 1;
    best = {coordinate(i), coordinate(j)};
    if (j > i && (round || i > 0)) {
      const double open = i > 0 ? coordinate(i - 1) : nodes[n - 1].s - 2.0 * pi;
      best.from = contact_end(coordinate(i + 1), nodes[(i + 1) % n].strength, coordinate(i),
                              nodes[i].strength, open);
    }
    if (j > i && (round || j + 1 < n)) {
      best.to = contact_end(coordinate(j - 1), nodes[(j - 1) % n].strength, coordinate(j),
                            nodes[j % n].strength, coordinate(j + 1));
    }
  }
  if (round && best.to > pi && best.from > 0.0 && best.from >= pi) {
    best = {best.from - 2.0 * pi, best.to - 2.0 * pi};
  }
  return best;
}

} // namespace spricka::contact
