// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/smooth.hpp"

namespace spricka::contact {

namespace {

// Multipliers of a quadratic edge as a line with a kink in the middle.
struct EdgePressure {
  bool sound = false;
  double length = 0.0;
  double first = 0.0, middle = 0.0, second = 0.0;

  [[nodiscard]] double mean() const { return 0.25 * (first + 2.0 * middle + second); }
  // Mean weighted by the function that falls from 1 at this end to 0 at the other.
  [[nodiscard]] double towards_first() const {
    return (5.0 * first + 6.0 * middle + second) / 12.0;
  }
  [[nodiscard]] double towards_second() const {
    return (first + 6.0 * middle + 5.0 * second) / 12.0;
  }
};

double slope(const EdgePressure& a, const EdgePressure& b) {
  return 2.0 * (b.mean() - a.mean()) / (a.length + b.length);
}

// At the corner between two edges; the centre of weight lies off the corner if they differ.
double between(const EdgePressure& a, const EdgePressure& b) {
  const double weighted =
      (a.length * a.towards_second() + b.length * b.towards_first()) / (a.length + b.length);
  return weighted - slope(a, b) * (b.length - a.length) / 3.0;
}

std::vector<EdgePressure> edge_pressures(std::span<const Edge> edges, const Numbering& number,
                                         const std::vector<bool>& sound, std::size_t first,
                                         const base::Vector& lambda) {
  std::vector<EdgePressure> all;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Edge& edge = edges[e];
    EdgePressure p;
    p.sound = edge.count == 3 && sound[first + e];
    p.length = edge.length;
    p.first = lambda[number.at(edge.nodes[0])];
    p.second = lambda[number.at(edge.nodes[1])];
    p.middle = edge.count == 3 ? lambda[number.at(edge.nodes[2])] : 0.0;
    all.push_back(p);
  }
  return all;
}

} // namespace

void filter_alternating_pressure(const ContactSurface& surface, const Numbering& number,
                                 const std::vector<bool>& sound, const base::Vector& lambda,
                                 base::Vector& pressure) {
  std::size_t first = 0;
  for (const EdgeChain& chain : surface.plane.chains) {
    const std::span<const Edge> edges = surface.plane.edges_of_chain(chain);
    const std::vector<EdgePressure> p = edge_pressures(edges, number, sound, first, lambda);
    const std::size_t n = p.size();
    const auto at = [&](std::size_t e, std::size_t i) -> double& {
      return pressure[number.at(edges[e].nodes[i])];
    };
    for (std::size_t e = 0; e < n; ++e) {
      if (p[e].sound) {
        at(e, 2) = p[e].mean();
      }
      const std::size_t next = (e + 1) % n;
      if ((next > e || (chain.closed && n > 1)) && p[e].sound && p[next].sound) {
        at(e, 1) = between(p[e], p[next]);
      }
    }
    if (!chain.closed && n > 1 && p[0].sound && p[1].sound) {
      at(0, 0) = p[0].towards_first() - slope(p[0], p[1]) * p[0].length / 3.0;
    }
    if (!chain.closed && n > 1 && p[n - 1].sound && p[n - 2].sound) {
      at(n - 1, 1) = p[n - 1].towards_second() + slope(p[n - 2], p[n - 1]) * p[n - 1].length / 3.0;
    }
    first += n;
  }
}

} // namespace spricka::contact
