// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/marked_arc.hpp"

#include "contact/contiguous_ranges.hpp"

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

SurfaceInterval longest_marked_arc(std::vector<ContactArcNode> nodes, bool round) {
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const ContactArcNode& a, const ContactArcNode& b) { return a.s < b.s; });
  const std::size_t n = nodes.size();
  std::vector<bool> in;
  in.reserve(n);
  for (const ContactArcNode& node : nodes) {
    in.push_back(node.in);
  }
  constexpr double pi = std::numbers::pi;
  // All of them: no end to be found. On a circle nodes over more than three quarters of it are all
  // round, fewer end where they end.
  if (n > 0 && std::ranges::find(in, false) == in.end()) {
    return round && n > 2 && nodes[n - 1].s - nodes[0].s > 1.5 * pi
               ? SurfaceInterval{-pi, pi}
               : SurfaceInterval{nodes[0].s, nodes[n - 1].s};
  }
  // Places of a stretch across the seam go on beyond pi, so that they ascend along it.
  const auto coordinate = [&](std::size_t i) {
    return nodes[i % n].s + 2.0 * pi * static_cast<double>(round ? i / n : 0);
  };
  SurfaceInterval best;
  std::size_t longest = 0;
  for (const std::vector<std::size_t>& places :
       contiguous_marked_ranges(SequenceLinks::link_consecutive(n, round), in)) {
    if (places.size() <= longest) {
      continue;
    }
    longest = places.size();
    const std::size_t i = places.front();
    const std::size_t j = i + longest - 1;
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
  // An arc that begins beyond the seam is named by angles of one turn.
  if (round && best.to > pi && best.from > 0.0 && best.from >= pi) {
    best = {best.from - 2.0 * pi, best.to - 2.0 * pi};
  }
  return best;
}

} // namespace spricka::contact
