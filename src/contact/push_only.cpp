// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/push_only.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace spricka::contact {

namespace {

using Index = Eigen::Index;

// Of a chain: the node `away` steps before or behind another one.
std::optional<std::size_t> neighbour(const ChainRange& chain, std::size_t i, std::size_t away,
                                     bool ahead) {
  if (chain.closed) {
    const std::size_t step = away % chain.count;
    return (i + (ahead ? step : chain.count - step)) % chain.count;
  }
  if (ahead) {
    return i + away < chain.count ? std::optional(i + away) : std::nullopt;
  }
  return away <= i ? std::optional(i - away) : std::nullopt;
}

// One chain of keep_pushing.
class ChainTensionRedistribution {
public:
  ChainTensionRedistribution(const ChainRange& range, std::vector<Index> order,
                             const base::Vector& area, NodalPressuresAndShears traction)
      : range_(range), order_(std::move(order)), area_(area), at_(traction) {}

  void push() {
    for (std::size_t i = 0; i < range_.count; ++i) {
      if (at_.p[order_[i]] < 0.0) {
        hand_on(i);
      }
    }
  }

private:
  [[nodiscard]] double force(Index k) const { return std::max(0.0, area_[k] * at_.p[k]); }

  void hand_on(std::size_t i) {
    const Index own = order_[i];
    const double pull = -area_[own] * at_.p[own];
    const double shear = at_.q.size() > 0 ? area_[own] * at_.q[own] : 0.0;
    at_.p[own] = 0.0;
    double left = pull;
    for (std::size_t away = 1; away < range_.count && left > 0.0; ++away) {
      std::array<Index, 2> donor{-1, -1};
      for (const bool ahead : {false, true}) {
        const std::optional<std::size_t> j = neighbour(range_, i, away, ahead);
        donor[ahead ? 1 : 0] = j && force(order_[*j]) > 0.0 ? order_[*j] : -1;
      }
      if (donor[0] == donor[1]) { // opposite ends of a closed chain, or none
        donor[1] = -1;
      }
      left -= take(donor, left, shear / pull);
    }
    if (at_.q.size() > 0 && pull > 0.0) {
      at_.q[own] = 0.0;
    }
  }

  // Takes so much from two nodes in the ratio of their forces, and gives `shear` for each of it.
  double take(const std::array<Index, 2>& donor, double wanted, double shear) {
    double there = 0.0;
    for (const Index j : donor) {
      there += j >= 0 ? force(j) : 0.0;
    }
    const double taken = std::min(wanted, there);
    for (const Index j : donor) {
      if (j < 0) {
        continue;
      }
      const double part = force(j) / there;
      // A donor that gives all has no round-off left, which might be negative.
      at_.p[j] = taken < there ? at_.p[j] * (1.0 - taken / there) : 0.0;
      if (at_.q.size() > 0) {
        at_.q[j] += shear * taken * part / area_[j];
      }
    }
    return taken;
  }

  const ChainRange& range_;
  std::vector<Index> order_;
  const base::Vector& area_;
  NodalPressuresAndShears at_;
};

// Part of the way to its neighbour that a node's row stands for.
double own_part(const PairConstraints& pair, const ChainRange& chain, std::size_t i) {
  const bool quadratic = chain.count > 1 && pair.contact.plane.edges.front().count == 3;
  if (pair.segments || !quadratic) {
    return 0.5;
  }
  return i % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0; // of half an edge: its shape functions' areas
}

// Beyond the last of up to three closed nodes, way t and pressure p from the first on: the end L of
// c sqrt(L - t) with their force and moment (contact.11), at most half a spacing beyond `open`.
double end_of_contact(const std::vector<std::array<double, 2>>& last, double open) {
  double force = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const auto [t, p] = last[i];
    const bool final = i + 1 == last.size();
    const double h = (final ? open : last[i + 1][0]) - t;
    const double q = final ? 0.0 : last[i + 1][1];
    force += 0.5 * h * (p + q);
    moment += h * (0.5 * t * (p + q) + h * (p + 2.0 * q) / 6.0);
  }
  const double from = last.back()[0];
  const double way = open - from;
  return force > 0.0 ? std::clamp(2.5 * moment / force - from, 0.0, 1.5 * way) : 0.5 * way;
}

} // namespace

std::vector<ChainRange> node_ranges_of_chains(const ContactSurface& surface) {
  std::vector<ChainRange> all;
  std::size_t first = 0;
  for (const EdgeChain& chain : surface.plane.chains) {
    std::size_t count = chain.closed ? 0 : 1;
    for (const Edge& edge : surface.plane.edges_of_chain(chain)) {
      count += static_cast<std::size_t>(edge.count) - 1;
    }
    all.push_back({first, count, chain.closed});
    first += count;
  }
  return all;
}

void redistribute_tension(const ContactSurface& surface, const std::vector<Index>& order,
                          const base::Vector& area, NodalPressuresAndShears traction) {
  for (const ChainRange& range : node_ranges_of_chains(surface)) {
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(range.first);
    ChainTensionRedistribution(range, {begin, begin + static_cast<std::ptrdiff_t>(range.count)},
                               area, traction)
        .push();
  }
}

double contact_area(const PairConstraints& pair, const std::vector<NodePressure>& nodes) {
  double area = 0.0;
  for (const NodePressure& node : nodes) {
    if (node.row >= 0 && node.closed) {
      area += pair.normal[static_cast<std::size_t>(node.row)].area;
    }
  }
  for (const ChainRange& chain : node_ranges_of_chains(pair.contact)) {
    const auto at = [&](std::size_t i) -> const NodePressure& { return nodes[chain.first + i]; };
    for (std::size_t i = 0; i < chain.count; ++i) {
      for (const bool ahead : {false, true}) {
        const std::optional<std::size_t> next = neighbour(chain, i, 1, ahead);
        const std::optional<std::size_t> behind = neighbour(chain, i, 1, !ahead);
        if (!at(i).closed || at(i).row < 0 || !next || at(*next).closed || at(*next).row < 0 ||
            !behind || !at(*behind).closed) {
          continue; // no end of contact, or that of a single node
        }
        std::vector<std::array<double, 2>> last;
        const std::optional<std::size_t> third = neighbour(chain, i, 2, !ahead);
        // From the third last closed node on; t ends at the open one.
        double t = 0.0;
        for (const std::optional<std::size_t>& k : {third, behind, std::optional(i)}) {
          if (!k || !at(*k).closed) {
            continue;
          }
          const std::size_t on = *neighbour(chain, *k, 1, ahead);
          const double p = pair.segments ? at(*k).p_consistent : at(*k).p_lumped;
          last.push_back({t, std::max(0.0, p)});
          t += (at(on).x - at(*k).x).norm();
        }
        const double way = (at(*next).x - at(i).x).norm();
        // The way that the closed row's area covers is taken off (contact.10): below zero where
        // contact ends before that.
        const double beyond = end_of_contact(last, t) - own_part(pair, chain, i) * way;
        area += beyond * out_of_plane_depth(pair.contact, pair.target, at(i).x.head<2>());
      }
    }
  }
  return area;
}

} // namespace spricka::contact
