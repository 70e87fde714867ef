// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/contact_load.hpp"

#include "contact/segment.hpp"
#include "estimate/mode_kernel.hpp"
#include "shape/quadrature.hpp"

#include <map>

namespace spricka::estimate {

namespace {

constexpr int degree = 9; // of the quadrature along a segment, as the rows have it

} // namespace

std::vector<ModeWeight> target_mode_weights(const EdgeTable& table, const contact::PairRows& pair) {
  if (!pair.segments || pair.rigid) {
    return {};
  }
  const EdgeIndex index = boundary_edges(table);
  const std::map<base::NodeId, std::size_t> row_of = contact::normal_rows(pair);
  const std::vector<contact::Edge>& own = pair.contact.plane.edges;
  const std::vector<contact::Edge>& others = pair.target.plane.edges;
  std::map<std::pair<std::size_t, std::size_t>, double> sums; // by freedom and row
  for (const contact::Segment& s : contact::find_segments(pair.contact, pair.target)) {
    const contact::Edge& edge = own[s.contact_edge];
    const contact::Edge& target = others[s.target_edge];
    const std::optional<std::size_t> at = find_edge(index, target);
    if (!at) {
      continue;
    }
    const double sign = side_sign(target.nodes[0], target.nodes[1]);
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * r[0]);
      const base::Vec2 x = contact::point_on(edge, xi);
      const base::Vec2 n = contact::surface_normal(pair.contact, edge, xi);
      const std::optional<double> eta = contact::hit_on(target, x, n);
      if (!eta) {
        continue;
      }
      const double w = 0.5 * (s.to - s.from) * weight * contact::tangent_on(edge, xi).norm() *
                       contact::depth_at(pair.contact, pair.target, x);
      const double mode = sign * side_mode(*eta) * side_frame(target.x, *eta).axis[0].dot(n);
      const std::array<double, 3> phi = contact::edge_hats(edge, xi);
      for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
        const auto row = row_of.find(edge.nodes[i]);
        if (row != row_of.end() && phi[i] != 0.0) {
          sums[{2 * *at, row->second}] += w * phi[i] * mode;
        }
      }
    }
  }
  std::vector<ModeWeight> weights;
  weights.reserve(sums.size());
  for (const auto& [place, weight] : sums) {
    weights.push_back({place.first, place.second, weight});
  }
  return weights;
}

} // namespace spricka::estimate
