// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/slave_places.hpp"

#include "contact/segment.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace spricka::contact {

namespace {

using std::numbers::pi;

const ContactSurface& slave_of(const PairConstraints& pair) {
  return pair.swapped ? pair.target : pair.contact;
}

double length_of(std::span<const Edge> edges) {
  double length = 0.0;
  for (const Edge& edge : edges) {
    length += edge.length;
  }
  return length;
}

/// Length of an edge from its first node to xi.
double length_to(const Edge& edge, double xi) {
  double length = 0.0;
  for (const auto& [r, weight] : shape::line_rule(5)) {
    const double at = -1.0 + 0.5 * (xi + 1.0) * (r[0] + 1.0);
    length += 0.5 * (xi + 1.0) * weight * edge_tangent(edge, at).norm();
  }
  return length;
}

/// The point of an edge nearest to x, by Newton's method from the best of some.
double nearest_xi(const Edge& edge, const Vec2& x) {
  constexpr int tried = 8;
  constexpr int steps = 12;
  double best = -1.0;
  for (int i = 1; i <= tried; ++i) {
    const double xi = -1.0 + 2.0 * i / tried;
    if ((point_on_edge(edge, xi) - x).norm() < (point_on_edge(edge, best) - x).norm()) {
      best = xi;
    }
  }
  for (int i = 0; i < steps; ++i) {
    const Vec2 t = edge_tangent(edge, best);
    best = std::clamp(best + t.dot(x - point_on_edge(edge, best)) / t.squaredNorm(), -1.0, 1.0);
  }
  return best;
}

double length_of(const ContactSurface& surface) {
  double length = 0.0;
  for (const EdgeChain& chain : surface.plane.chains) {
    length += length_of(surface.plane.edges_of_chain(chain));
  }
  return length;
}

/// Length along a surface at its point nearest to x.
double place_on(const ContactSurface& surface, const std::vector<double>& starts, const Vec2& x) {
  const double whole = (1.0 - 1e-12) * length_of(surface); // summed in another order
  double least = std::numeric_limits<double>::infinity();
  double place = 0.0;
  for (std::size_t c = 0; c < surface.plane.chains.size(); ++c) {
    const EdgeChain& chain = surface.plane.chains[c];
    double before = starts[c];
    for (const Edge& edge : surface.plane.edges_of_chain(chain)) {
      const EdgeBoundingCircle circle = bounding_circle(edge);
      if ((x - circle.centre).norm() > circle.radius + least) {
        before += edge.length;
        continue;
      }
      const double xi = nearest_xi(edge, x);
      const Vec2 off = x - point_on_edge(edge, xi);
      if (off.norm() < least) {
        least = off.norm();
        // pieces follow one another: only the first and the last of all go on beyond their ends
        const bool first = xi == -1.0 && before == 0.0 && !chain.closed;
        const bool last = xi == 1.0 && !chain.closed && before + edge.length >= whole;
        const double beyond = first || last ? off.dot(edge_tangent(edge, xi).normalized()) : 0.0;
        place = before + length_to(edge, xi) + beyond;
      }
      before += edge.length;
    }
  }
  return place;
}

/// Angle nearest to another one.
double near_to(double angle, double other) {
  return other + std::remainder(angle - other, 2.0 * pi);
}

/// Carries places over, linearly between nodes.
class Carry {
public:
  Carry(std::vector<std::pair<double, double>> knots, bool from_angles, bool to_angles)
      : knots_(std::move(knots)), from_angles_(from_angles), to_angles_(to_angles) {
    std::ranges::stable_sort(knots_, {}, &std::pair<double, double>::first);
    if (from_angles_) { // once round
      knots_.emplace_back(knots_.front().first + 2.0 * pi, knots_.front().second);
    }
  }

  /// Where pieces follow one another their ends share a place: the first end of an arc belongs to
  /// the piece behind it, `inward` 1, the last to the one before, -1.
  [[nodiscard]] double operator()(double place, double inward) const {
    constexpr double little = 1e-12;
    double at = place + inward * little * (knots_.back().first - knots_.front().first);
    if (from_angles_) {
      at = knots_.front().first +
           std::fmod(std::fmod(at - knots_.front().first, 2.0 * pi) + 2.0 * pi, 2.0 * pi);
    }
    auto above = std::ranges::upper_bound(knots_, at, {}, &std::pair<double, double>::first);
    above = std::clamp(above, knots_.begin() + 1, knots_.end() - 1);
    const auto& [a, from] = *(above - 1);
    const auto& [b, end] = *above;
    const double to = to_angles_ ? near_to(end, from) : end;
    return b > a ? from + (at - a) / (b - a) * (to - from) : from;
  }

private:
  std::vector<std::pair<double, double>> knots_; ///< ascending by the first
  bool from_angles_, to_angles_;
};

SurfaceInterval ordered(SurfaceInterval arc, bool angles) {
  if (!angles) {
    return {std::min(arc.from, arc.to), std::max(arc.from, arc.to)};
  }
  const double run = arc.to - arc.from;
  double from = std::min(arc.from, arc.from + run);
  from -= 2.0 * pi * std::floor((from + pi) / (2.0 * pi) + 1e-9);
  return {from, from + std::abs(run)};
}

} // namespace

bool uses_angular_coordinate(const PairConstraints& pair) {
  return slave_of(pair).circle.has_value();
}

std::vector<double> chain_start_lengths(const ContactSurface& surface) {
  const std::size_t count = surface.plane.chains.size();
  std::vector<std::optional<std::size_t>> next(count);
  std::vector<std::optional<std::size_t>> last(count);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      const EdgeChain& one = surface.plane.chains[a];
      const EdgeChain& other = surface.plane.chains[b];
      if (a != b && !one.closed && !other.closed && !next[a] && !last[b] &&
          (surface.plane.edges_of_chain(one).back().x[1] -
           surface.plane.edges_of_chain(other).front().x[0])
                  .norm() < 1e-9 * surface.extent) {
        next[a] = b;
        last[b] = a;
      }
    }
  }
  std::vector<double> starts(count, 0.0);
  std::vector<bool> done(count, false);
  double length = 0.0;
  for (std::size_t c = 0; c < count; ++c) {
    if (done[c]) {
      continue;
    }
    std::size_t first = c;
    // Back to where a string of chains begins; a ring of them begins with c.
    while (last[first] && *last[first] != c) {
      first = *last[first];
    }
    for (std::optional<std::size_t> at = first; at && !done[*at]; at = next[*at]) {
      done[*at] = true;
      starts[*at] = length;
      length += length_of(surface.plane.edges_of_chain(surface.plane.chains[*at]));
    }
  }
  return starts;
}

void convert_to_slave_coordinates(const PairConstraints& pair, std::vector<NodePressure>& nodes,
                                  SurfaceInterval& arc) {
  if (!pair.swapped || nodes.size() < 2) {
    return;
  }
  const ContactSurface& slave = pair.target;
  const bool from_angles = pair.contact.circle.has_value();
  const bool to_angles = slave.circle.has_value();
  const std::vector<double> starts = chain_start_lengths(slave);
  std::vector<std::pair<double, double>> knots;
  for (NodePressure& node : nodes) {
    const double own = from_angles ? node.theta : node.arc;
    node.arc = place_on(slave, starts, node.x.head<2>());
    node.theta = 0.0;
    if (to_angles) {
      const Vec2 d = node.x.head<2>() - slave.circle->centre;
      node.theta = std::atan2(d.y(), d.x());
    }
    knots.emplace_back(own, to_angles ? node.theta : node.arc);
  }
  const Carry carry(std::move(knots), from_angles, to_angles);
  if (from_angles && to_angles && arc.to - arc.from >= 2.0 * pi - 1e-12) {
    return; // all round
  }
  SurfaceInterval found{carry(arc.from, 1.0), carry(arc.to, -1.0)};
  if (to_angles) { // the way from end to end goes through its middle
    const double middle = near_to(carry(0.5 * (arc.from + arc.to), 0.0), found.from);
    found.to = near_to(found.to, middle);
  }
  arc = ordered(found, to_angles);
  if (!to_angles) { // contact ends with the slave
    arc = {std::clamp(arc.from, 0.0, length_of(slave)), std::clamp(arc.to, 0.0, length_of(slave))};
  }
}

} // namespace spricka::contact
