// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spricka::contact {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double one_point = 1e-9; // of the surface's extent
constexpr std::size_t none = static_cast<std::size_t>(-1);

// Nodes one after another with a coordinate that ascends.
struct Run {
  std::vector<const NodePressure*> nodes;
  std::vector<double> s;
  bool ring = false;
};

// The node that follows each; `none` at the end of a chain that meets no other.
std::vector<std::size_t> followers(const Surface& surface, const std::vector<NodePressure>& nodes) {
  std::vector<std::size_t> next(nodes.size(), none);
  std::vector<std::pair<std::size_t, std::size_t>> open; // first and last node of open chains
  std::size_t at = 0;
  for (const EdgeChain& chain : surface.chains) {
    std::size_t count = chain.closed ? 0 : 1;
    for (const Edge& edge : chain.edges) {
      count += static_cast<std::size_t>(edge.count) - 1;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      next[at + i] = at + i + 1;
    }
    if (chain.closed) {
      next[at + count - 1] = at;
    } else {
      open.emplace_back(at, at + count - 1);
    }
    at += count;
  }
  for (const auto& [first, last] : open) {
    for (const auto& [other, unused] : open) {
      if (surface.circle && (nodes[last].x - nodes[other].x).norm() < one_point * surface.extent) {
        next[last] = other;
      }
    }
  }
  return next;
}

// Follows the links from a node on, and marks what it passes.
Run follow(const std::vector<NodePressure>& nodes, const std::vector<std::size_t>& next,
           std::size_t start, std::vector<bool>& seen) {
  Run run;
  std::size_t k = start;
  for (; k != none && !seen[k]; k = next[k]) {
    seen[k] = true;
    run.nodes.push_back(&nodes[k]);
  }
  run.ring = k != none && k == start;
  return run;
}

std::vector<Run> runs_of(const Surface& surface, const std::vector<NodePressure>& nodes) {
  const std::vector<std::size_t> next = followers(surface, nodes);
  std::vector<bool> seen(nodes.size(), false);
  std::vector<bool> follows(nodes.size(), false);
  for (const std::size_t k : next) {
    if (k != none) {
      follows[k] = true;
    }
  }
  std::vector<Run> runs;
  for (const bool rings : {false, true}) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (!seen[k] && (rings || !follows[k])) {
        runs.push_back(follow(nodes, next, k, seen));
        runs.back().ring = runs.back().ring && surface.circle; // elsewhere lengths begin anew
      }
    }
  }
  return runs;
}

bool all_closed(const Run& run) {
  return std::all_of(run.nodes.begin(), run.nodes.end(),
                     [](const NodePressure* n) { return n->closed; });
}

// A ring starts at an open node; angles go on beyond pi, in the direction in which they grow.
void set_coordinate(Run& run, bool round) {
  if (run.ring) {
    const auto open = std::find_if(run.nodes.begin(), run.nodes.end(),
                                   [](const NodePressure* n) { return !n->closed; });
    std::rotate(run.nodes.begin(), open, run.nodes.end());
  }
  double s = 0.0;
  for (std::size_t i = 0; i < run.nodes.size(); ++i) {
    if (!round) {
      s = run.nodes[i]->arc;
    } else {
      s = i == 0 ? run.nodes[i]->theta
                 : s + std::remainder(run.nodes[i]->theta - run.nodes[i - 1]->theta, turn);
    }
    run.s.push_back(s);
  }
  if (!run.s.empty() && run.s.back() < run.s.front()) {
    std::reverse(run.nodes.begin(), run.nodes.end());
    std::reverse(run.s.begin(), run.s.end());
    if (run.ring) { // the open node comes first again
      std::rotate(run.nodes.begin(), run.nodes.end() - 1, run.nodes.end());
      std::rotate(run.s.begin(), run.s.end() - 1, run.s.end());
      run.s.front() -= turn;
    }
  }
}

// The closed nodes from i on, and how many they are.
std::size_t closed_from(const Run& run, std::size_t i) {
  std::size_t j = i;
  while (j < run.nodes.size() && run.nodes[j]->closed) {
    ++j;
  }
  return j - i;
}

// End of contact between the closed node k and its open neighbour at s_open: p^2 falls linearly
// (square-root law) through the last closed nodes, `inward` of which follow one another. Four of
// them, two quadratic edges, even out that corners and mid nodes see the end differently.
double contact_end(const Run& run, std::size_t k, std::ptrdiff_t inward, std::size_t count,
                   double s_open) {
  constexpr std::size_t most = 4;
  const double s_last = run.s[k];
  double n = 0.0, s1 = 0.0, s2 = 0.0, q1 = 0.0, sq = 0.0; // sums, s from the closed node
  for (std::size_t i = 0; i < std::min(count, most); ++i) {
    const std::size_t at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) +
                                                    inward * static_cast<std::ptrdiff_t>(i));
    const double s = run.s[at] - s_last;
    const double q = run.nodes[at]->p_lumped * run.nodes[at]->p_lumped;
    n += 1.0;
    s1 += s;
    s2 += s * s;
    q1 += q;
    sq += s * q;
  }
  const double slope = (n * sq - s1 * q1) / (n * s2 - s1 * s1);
  const double fall = (s_open > s_last ? -1.0 : 1.0) * slope;
  if (!(fall > 0.0)) {
    return 0.5 * (s_last + s_open);
  }
  const double zero = s_last + (s1 - q1 / slope) / n;
  return std::clamp(zero, std::min(s_last, s_open), std::max(s_last, s_open));
}

Arc with_ends(const Run& run, std::size_t i, std::size_t j) {
  Arc arc{run.s[i], run.s[j]};
  if (j == i) {
    return arc;
  }
  const std::size_t count = j - i + 1;
  if (i > 0) {
    arc.from = contact_end(run, i, 1, count, run.s[i - 1]);
  }
  if (j + 1 < run.nodes.size()) {
    arc.to = contact_end(run, j, -1, count, run.s[j + 1]);
  } else if (run.ring) {
    arc.to = contact_end(run, j, -1, count, run.s.front() + turn);
  }
  return arc;
}

} // namespace

Arc longest_arc(const Surface& surface, const std::vector<NodePressure>& nodes) {
  const bool round = surface.circle.has_value();
  Arc best;
  std::size_t longest = 0;
  for (Run& run : runs_of(surface, nodes)) {
    if (run.ring && all_closed(run)) {
      if (run.nodes.size() > longest) {
        longest = run.nodes.size();
        best = {-0.5 * turn, 0.5 * turn};
      }
      continue;
    }
    set_coordinate(run, round);
    for (std::size_t i = 0; i < run.nodes.size();) {
      const std::size_t count = closed_from(run, i);
      if (count > longest) {
        longest = count;
        best = with_ends(run, i, i + count - 1);
      }
      i += std::max<std::size_t>(count, 1);
    }
  }
  if (round && best.from >= 0.5 * turn) {
    best = {best.from - turn, best.to - turn};
  } else if (round && best.from < -0.5 * turn) {
    best = {best.from + turn, best.to + turn};
  }
  return best;
}

} // namespace spricka::contact
