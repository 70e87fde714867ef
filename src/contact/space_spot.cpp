// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_spot.hpp"

#include "base/index.hpp"
#include "contact/make_rows.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace spricka::contact {

namespace {

constexpr double no_edge = std::numeric_limits<double>::infinity();

// Whether nodes in the middle of edges have pressures of their own.
bool has_middle_rows(const PairConstraints& pair) {
  const std::vector<std::vector<std::size_t>> faces = functions_by_facet(pair);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = static_cast<std::size_t>(pair.contact.facets[f].corner_count());
    if (faces[f].size() > corners) {
      return true;
    }
  }
  return false;
}

bool is_at_sharp_edge(const PairConstraints& pair, base::NodeId node) {
  return std::ranges::any_of(pair.sharp_ends, [&](const SingularContactEdge& end) {
    return std::ranges::find(end.nodes, node) != end.nodes.end();
  });
}

// Steps over elements from the nearest of some rows to each row; -1 where none leads to it.
std::vector<int> count_steps(const std::vector<std::set<std::size_t>>& next,
                             const std::vector<bool>& from) {
  std::vector<int> steps(from.size(), -1);
  std::vector<std::size_t> reached;
  for (std::size_t row = 0; row < from.size(); ++row) {
    if (from[row]) {
      steps[row] = 0;
      reached.push_back(row);
    }
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const std::size_t row : next[reached[i]]) {
      if (steps[row] < 0) {
        steps[row] = steps[reached[i]] + 1;
        reached.push_back(row);
      }
    }
  }
  return steps;
}

// Radius, in steps, of the largest disc of closed rows that a row lies in: a peak beside the border
// of a wide spot is in a large one. 0: no open row ends the spot.
int largest_disc(const std::vector<std::set<std::size_t>>& next, std::size_t row,
                 const std::vector<bool>& closed) {
  std::vector<bool> open(closed.size());
  std::transform(closed.begin(), closed.end(), open.begin(), std::logical_not<>());
  std::vector<bool> peak(closed.size(), false);
  peak[row] = true;
  const std::vector<int> to_open = count_steps(next, open);
  const std::vector<int> to_peak = count_steps(next, peak);
  int radius = 0;
  for (std::size_t center = 0; center < closed.size(); ++center) {
    if (to_peak[center] >= 0 && to_peak[center] < to_open[center]) {
      radius = std::max(radius, to_open[center]);
    }
  }
  return radius;
}

} // namespace

std::vector<std::set<std::size_t>> neighbouring_normal_rows(const PairConstraints& pair) {
  std::vector<std::set<std::size_t>> next(pair.normal.size());
  const std::vector<std::vector<std::size_t>> faces = functions_by_facet(pair);
  const auto row_of = [&](const HatElement& t, int i) {
    return pair.functions[faces[t.facet][static_cast<std::size_t>(i)]].row;
  };
  for (const HatElement& t : pair.contact.elements) {
    for (const int i : t.node) {
      for (const int k : t.node) {
        const int a = row_of(t, i);
        const int b = row_of(t, k);
        if (a >= 0 && b >= 0 && a != b) {
          next[static_cast<std::size_t>(a)].insert(static_cast<std::size_t>(b));
        }
      }
    }
  }
  return next;
}

double count_elements_across_peak(const PairConstraints& pair, const base::Vector& lambda,
                                  const std::vector<bool>& closed) {
  if (!pair.segments || pair.normal.empty()) {
    return no_edge;
  }
  Eigen::Index peak = 0;
  const double most = lambda.head(base::index(pair.normal.size())).maxCoeff(&peak);
  const std::size_t at = base::at(peak);
  if (!(most > 0.0) || !closed[at] || is_at_sharp_edge(pair, pair.normal[at].node)) {
    return no_edge;
  }
  const int steps = largest_disc(neighbouring_normal_rows(pair), at, closed);
  if (steps == 0) {
    return no_edge;
  }
  // Contact ends somewhere between the last closed node and the first open one.
  return (2.0 * steps - 1.0) / (has_middle_rows(pair) ? 2.0 : 1.0);
}

} // namespace spricka::contact
