// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spricka::contact {

namespace {

constexpr double pi = std::numbers::pi;

// The node that follows each one and the one before, over closed chains' seams and crack mouths.
struct Links {
  std::vector<std::optional<std::size_t>> next, last;

  void join(std::size_t a, std::size_t b) {
    next[a] = b;
    last[b] = a;
  }
};

Links links_of(const Surface& surface, const std::vector<NodePressure>& nodes) {
  Links links{.next = std::vector<std::optional<std::size_t>>(nodes.size()),
              .last = std::vector<std::optional<std::size_t>>(nodes.size())};
  std::vector<std::pair<std::size_t, std::size_t>> open; // first and last node of open chains
  std::size_t first = 0;
  for (const EdgeChain& chain : surface.chains) {
    std::size_t count = chain.closed ? 0 : 1;
    for (const Edge& edge : chain.edges) {
      count += static_cast<std::size_t>(edge.count) - 1;
    }
    for (std::size_t i = first; i + 1 < first + count; ++i) {
      links.join(i, i + 1);
    }
    if (chain.closed) {
      links.join(first + count - 1, first);
    } else {
      open.emplace_back(first, first + count - 1);
    }
    first += count;
  }
  for (const auto& [start, end] : open) {
    for (const auto& [other, behind] : open) {
      if (nodes[end].lip == -1 && nodes[other].lip == 1 &&
          (nodes[end].x - nodes[other].x).norm() < 1e-9 * surface.extent) {
        links.join(end, other);
      }
    }
  }
  return links;
}

// Way from a to its neighbour b: angle about the centre, or length.
double way(const Surface& surface, const NodePressure& a, const NodePressure& b) {
  return surface.circle ? std::remainder(b.theta - a.theta, 2.0 * pi) : (b.x - a.x).norm();
}

// How far contact reaches beyond its last closed node, `inner` the one before it and `open` the
// first open one: p^2 falls linearly (square-root law).
double beyond(const Surface& surface, const NodePressure& inner, const NodePressure& last,
              const NodePressure& open) {
  const double gap = way(surface, last, open);
  const double fall = inner.p_lumped * inner.p_lumped - last.p_lumped * last.p_lumped;
  if (fall <= 0.0) {
    return 0.5 * gap;
  }
  const double on = way(surface, inner, last) * last.p_lumped * last.p_lumped / fall;
  return std::clamp(on, std::min(0.0, gap), std::max(0.0, gap));
}

// The stretch of closed nodes that begins at `start`; where it begins and how far it runs.
struct Stretch {
  double begin = 0.0;
  double run = 0.0; // negative where the chain goes round clockwise
};

Stretch stretch_from(const Surface& surface, const std::vector<NodePressure>& nodes,
                     const Links& links, std::size_t start) {
  Stretch s;
  s.begin = surface.circle ? nodes[start].theta : nodes[start].arc;
  std::size_t end = start;
  std::size_t inner = start;
  while (links.next[end] && nodes[*links.next[end]].closed) {
    inner = end;
    end = *links.next[end];
    s.run += way(surface, nodes[inner], nodes[end]);
  }
  if (end == start) {
    return s;
  }
  if (links.next[end]) {
    s.run += beyond(surface, nodes[inner], nodes[end], nodes[*links.next[end]]);
  }
  if (links.last[start]) {
    const NodePressure& second = nodes[*links.next[start]];
    const NodePressure& open = nodes[*links.last[start]];
    // along the chain the way from the first closed node back to the open one
    const double back = surface.circle ? beyond(surface, second, nodes[start], open)
                                       : -beyond(surface, second, nodes[start], open);
    s.begin += back;
    s.run -= back;
  }
  return s;
}

} // namespace

Arc longest_arc(const Surface& surface, const std::vector<NodePressure>& nodes) {
  const Links links = links_of(surface, nodes);
  const bool round = surface.circle.has_value();
  std::optional<Stretch> longest;
  bool any = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    any = any || nodes[i].closed;
    if (nodes[i].closed && !(links.last[i] && nodes[*links.last[i]].closed)) {
      const Stretch s = stretch_from(surface, nodes, links, i);
      if (!longest || std::abs(s.run) > std::abs(longest->run)) {
        longest = s;
      }
    }
  }
  if (!longest) {
    if (!any) {
      return {};
    }
    double length = 0.0; // closed all round
    for (const Edge& edge : surface.chains.front().edges) {
      length += edge.length;
    }
    return round ? Arc{-pi, pi} : Arc{0.0, length};
  }
  Arc arc{std::min(longest->begin, longest->begin + longest->run),
          std::max(longest->begin, longest->begin + longest->run)};
  if (round) {
    const double turns = std::floor((arc.from + pi) / (2.0 * pi) + 1e-9);
    arc.from -= 2.0 * pi * turns;
    arc.to -= 2.0 * pi * turns;
  }
  return arc;
}

} // namespace spricka::contact
