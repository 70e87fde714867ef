// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/arc.hpp"

#include "contact/contiguous_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spricka::contact {

namespace {

using std::numbers::pi;

// Over closed chains' seams and crack mouths.
SequenceLinks links_of(const ContactSurface& surface, const std::vector<NodePressure>& nodes) {
  SequenceLinks links(nodes.size());
  std::vector<std::pair<std::size_t, std::size_t>> open; // first and last node of open chains
  std::size_t first = 0;
  for (const EdgeChain& chain : surface.plane.chains) {
    std::size_t count = chain.closed ? 0 : 1;
    for (const Edge& edge : surface.plane.edges_of_chain(chain)) {
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
      if (nodes[end].crack_face == -1 && nodes[other].crack_face == 1 &&
          (nodes[end].x - nodes[other].x).norm() < 1e-9 * surface.extent) {
        links.join(end, other);
      }
    }
  }
  return links;
}

// Way from a to its neighbour b: angle about the centre, or length.
double way(const ContactSurface& surface, const NodePressure& a, const NodePressure& b) {
  return surface.circle ? std::remainder(b.theta - a.theta, 2.0 * pi) : (b.x - a.x).norm();
}

// The end of contact behind the closed nodes `last`, running to the first open one: the place where
// c sqrt(L - t) with the force and the moment of the last pressures ends, L = 5/2 M1/M0
// (contact.11). The way from the last closed node.
double beyond(const ContactSurface& surface, const std::vector<NodePressure>& nodes,
              bool multipliers, const std::vector<std::size_t>& last) {
  const auto pressure = [&](std::size_t i) {
    return std::max(0.0, multipliers ? nodes[i].p_consistent : nodes[i].p_lumped);
  };
  double t = 0.0;
  double force = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i + 1 < last.size(); ++i) {
    const double h = way(surface, nodes[last[i]], nodes[last[i + 1]]);
    const double p = pressure(last[i]);
    const double q = i + 2 < last.size() ? pressure(last[i + 1]) : 0.0;
    force += 0.5 * h * (p + q);
    moment += h * (0.5 * t * (p + q) + h * (p + 2.0 * q) / 6.0);
    t += h;
  }
  const double gap = way(surface, nodes[last[last.size() - 2]], nodes[last.back()]);
  if (force == 0.0) {
    return 0.5 * gap;
  }
  const double on = 2.5 * moment / force - (t - gap);
  return std::clamp(on, std::min(0.0, 1.5 * gap), std::max(0.0, 1.5 * gap));
}

// Where a stretch of closed nodes begins and how far it runs.
struct ClosedContactInterval {
  double begin = 0.0;
  double run = 0.0; // negative where the chain goes round clockwise
};

ClosedContactInterval measure(const ContactSurface& surface, const std::vector<NodePressure>& nodes,
                              bool multipliers, const SequenceLinks& links,
                              const std::vector<std::size_t>& closed) {
  const std::size_t start = closed.front();
  ClosedContactInterval s;
  s.begin = surface.circle ? nodes[start].theta : nodes[start].arc;
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
    s.run += way(surface, nodes[closed[i]], nodes[closed[i + 1]]);
  }
  if (closed.size() == 1) {
    return s;
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(closed.size(), 3));
  const std::optional<std::size_t> behind = links.next[closed.back()];
  const std::optional<std::size_t> before = links.last[start];
  if (behind) {
    std::vector<std::size_t> last(closed.end() - count, closed.end());
    last.push_back(*behind);
    s.run += beyond(surface, nodes, multipliers, last);
  }
  if (before) {
    std::vector<std::size_t> first(closed.begin(), closed.begin() + count);
    std::reverse(first.begin(), first.end());
    first.push_back(*before);
    const double back = beyond(surface, nodes, multipliers, first);
    s.begin += surface.circle ? back : -back; // lengths have no sign, angles turn with the chain
    s.run += surface.circle ? -back : back;
  }
  return s;
}

} // namespace

SurfaceInterval find_longest_closed_arc(const ContactSurface& surface,
                                        const std::vector<NodePressure>& nodes, bool multipliers) {
  const SequenceLinks links = links_of(surface, nodes);
  const bool round = surface.circle.has_value();
  std::vector<bool> closed;
  closed.reserve(nodes.size());
  for (const NodePressure& node : nodes) {
    closed.push_back(node.closed);
  }
  std::optional<ClosedContactInterval> longest;
  for (const std::vector<std::size_t>& places : contiguous_marked_ranges(links, closed)) {
    const ClosedContactInterval s = measure(surface, nodes, multipliers, links, places);
    if (!longest || std::abs(s.run) > std::abs(longest->run)) {
      longest = s;
    }
  }
  if (!longest) {
    if (std::ranges::find(closed, true) == closed.end()) {
      return {};
    }
    double length = 0.0; // closed all round
    for (const Edge& edge : surface.plane.edges_of_chain(surface.plane.chains.front())) {
      length += edge.length;
    }
    return round ? SurfaceInterval{-pi, pi} : SurfaceInterval{0.0, length};
  }
  SurfaceInterval arc{std::min(longest->begin, longest->begin + longest->run),
                      std::max(longest->begin, longest->begin + longest->run)};
  if (round) {
    // Angles start from -pi up to below pi: one that round-off keeps just below pi starts at -pi.
    const double turns = std::floor((arc.from + pi) / (2.0 * pi) + 1e-9);
    arc.from -= 2.0 * pi * turns;
    arc.to -= 2.0 * pi * turns;
  }
  return arc;
}

} // namespace spricka::contact
