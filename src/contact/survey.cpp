// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/survey.hpp"

#include "contact/segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace spricka::contact {

namespace {

// Both ends without weight, then Gauss points of degree 5.
constexpr std::array<double, 5> sample_r{-1.0, 1.0, -0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 5> sample_w{0.0, 0.0, 5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

std::vector<const Edge*> all_edges(const Surface& surface) {
  std::vector<const Edge*> edges;
  for (const EdgeChain& chain : surface.chains) {
    for (const Edge& edge : chain.edges) {
      edges.push_back(&edge);
    }
  }
  return edges;
}

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

} // namespace

Survey survey(const Surface& from, const Surface& to) {
  const std::vector<const Edge*> edges = all_edges(from);
  const std::vector<const Edge*> targets = all_edges(to);
  Survey found;
  found.edges = edges.size();
  for (const Edge* edge : edges) {
    found.length += edge->length;
  }
  std::vector<bool> faces(edges.size(), false);
  bool first = true;
  for (const Segment& s : find_segments(from, to)) {
    const Edge& edge = *edges[s.contact_edge];
    const Edge& target = *targets[s.target_edge];
    for (std::size_t i = 0; i < sample_r.size(); ++i) {
      const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * sample_r[i]);
      const Vec2 n = surface_normal(from, edge, xi);
      const Vec2 x = point_on(edge, xi);
      const std::optional<double> eta = hit_on(target, x, n);
      if (!eta) {
        continue;
      }
      faces[s.contact_edge] = true;
      const double gap = (point_on(target, *eta) - x).dot(n);
      const double w = 0.5 * (s.to - s.from) * sample_w[i] * tangent_on(edge, xi).norm();
      found.seen += w;
      found.gap_mean += w * gap;
      found.gap_low = first ? gap : std::min(found.gap_low, gap);
      found.gap_high = first ? gap : std::max(found.gap_high, gap);
      found.angle_high =
          std::max(found.angle_high,
                   angle_between(n, -surface_normal(to, target, std::clamp(*eta, -1.0, 1.0))));
      first = false;
    }
  }
  found.facing = static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
  found.gap_mean = found.seen > 0.0 ? found.gap_mean / found.seen : 0.0;
  found.seen = std::min(found.seen, found.length); // round-off
  return found;
}

} // namespace spricka::contact
