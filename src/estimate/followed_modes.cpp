// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/followed_modes.hpp"

#include "contact/segment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace spricka::estimate {

namespace {

constexpr double as_long = 0.05; // lengths that differ by less count as equal

// What the mode of an edge moves at points of the other surface.
class Leader {
public:
  Leader(const contact::Surface& surface, const contact::Edge& edge)
      : surface_(surface), edge_(edge), sign_(side_sign(edge.nodes[0], edge.nodes[1])) {}

  [[nodiscard]] base::Vec2 motion(const base::Vec2& x) const {
    const std::optional<double> xi = contact::foot_on(surface_, edge_, x);
    if (!xi || std::abs(*xi) >= 1.0) {
      return base::Vec2::Zero();
    }
    return sign_ * side_mode(*xi) * side_frame(edge_.x, *xi).axis[0];
  }

private:
  const contact::Surface& surface_;
  const contact::Edge& edge_;
  double sign_;
};

// The odd cubic part of a motion along the normal of an edge.
double cubic_part(const Leader& leader, const contact::Edge& edge) {
  const auto normal = [&](double t) {
    return leader.motion(contact::point_on(edge, t)).dot(side_frame(edge.x, t).axis[0]);
  };
  const double a = normal(-1.0);
  const double b = normal(1.0);
  const double difference = normal(0.5) - normal(-0.5) - 0.5 * (b - a);
  return side_sign(edge.nodes[0], edge.nodes[1]) * 0.5 * difference / side_mode(0.5);
}

FollowedMode follow(const ContactEdge& lead, const std::vector<const ContactEdge*>& facing,
                    const contact::Surface& surface) {
  FollowedMode mode;
  mode.edge = lead.edge;
  mode.rows = lead.rows;
  const Leader leader(surface, *lead.shape);
  std::set<base::NodeId> seen;
  for (const ContactEdge* f : facing) {
    for (std::size_t i = 0; i < 3; ++i) {
      const base::Vec2 motion = leader.motion(f->shape->x[i]);
      if (motion.squaredNorm() > 0.0 && seen.insert(f->shape->nodes[i]).second) {
        mode.nodes.push_back({f->shape->nodes[i], motion});
      }
    }
    mode.modes.push_back({f->edge, cubic_part(leader, *f->shape)});
  }
  return mode;
}

} // namespace

std::vector<FollowedMode> followed_modes(const Enrichment& enrichment,
                                         const std::vector<ContactEdge>& edges,
                                         const contact::PairRows& pair) {
  std::vector<FollowedMode> found;
  if (pair.rigid) {
    return found;
  }
  std::vector<bool> matched(enrichment.edges().edges.size(), false);
  for (const ContactEdge& edge : edges) {
    if (edge.opposite) {
      matched[edge.edge] = matched[*edge.opposite] = true;
    }
  }
  // Which edges face which, by their places in the pair's chains.
  std::map<const contact::Edge*, const ContactEdge*> known;
  for (const ContactEdge& edge : edges) {
    known.emplace(edge.shape, &edge);
  }
  const std::vector<const contact::Edge*> own = edges_of(pair.contact);
  const std::vector<const contact::Edge*> others = edges_of(pair.target);
  std::map<const contact::Edge*, std::set<std::size_t>> facing;
  for (const contact::Segment& s : contact::find_segments(pair.contact, pair.target)) {
    facing[own[s.contact_edge]].insert(s.target_edge);
    facing[others[s.target_edge]].insert(s.contact_edge);
  }
  const std::vector<base::Vec3>& diagonal = enrichment.diagonal();
  for (const ContactEdge& lead : edges) {
    if (matched[lead.edge] || !lead.covered) {
      continue;
    }
    const std::vector<const contact::Edge*>& across = lead.target_side ? own : others;
    std::vector<const ContactEdge*> followers;
    double length = 0.0;
    bool complete = true;
    for (const std::size_t i : facing[lead.shape]) {
      const auto at = known.find(across[i]);
      complete = complete && at != known.end();
      if (at != known.end()) {
        followers.push_back(at->second);
        length += at->second->shape->length;
      }
    }
    if (!complete || followers.empty()) {
      continue;
    }
    length /= static_cast<double>(followers.size());
    const double least = lead.target_side ? 1.0 + as_long : 1.0 - as_long;
    if (lead.shape->length < least * length) {
      continue; // the other side leads
    }
    const contact::Surface& surface = lead.target_side ? pair.target : pair.contact;
    const contact::Surface& other = lead.target_side ? pair.contact : pair.target;
    FollowedMode mode = follow(lead, followers, surface);
    const double ratio =
        other.stiffness * other.thickness / (surface.stiffness * surface.thickness);
    mode.stiffness = diagonal[lead.edge][0] * (1.0 + ratio);
    found.push_back(std::move(mode));
  }
  return found;
}

base::Matrix followed_parts(const std::vector<FollowedMode>& modes, const std::vector<bool>& closed,
                            const FollowedResiduals& residuals) {
  base::Matrix parts =
      base::Matrix::Zero(static_cast<Eigen::Index>(modes.size()), residuals.r_z.cols());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const FollowedMode& mode = modes[m];
    if (!std::ranges::all_of(mode.rows, [&](std::size_t r) { return closed[r]; })) {
      continue;
    }
    // Forces of closed rows act on the nodes; the modes feel them through the stresses.
    const auto normal = static_cast<Eigen::Index>(2 * mode.edge);
    double r_u = residuals.r_u[normal];
    Eigen::RowVectorXd r_z = residuals.r_z.row(normal);
    for (const FollowedMode::Mode& f : mode.modes) {
      const auto at = static_cast<Eigen::Index>(2 * f.edge);
      r_u += f.factor * residuals.r_u[at];
      r_z += f.factor * residuals.r_z.row(at);
    }
    for (const FollowedMode::Node& n : mode.nodes) {
      const auto at = static_cast<Eigen::Index>(2 * n.node.index());
      r_u -= n.motion.dot(residuals.force_u.segment<2>(at));
      r_z -= n.motion.transpose() * residuals.force_z.middleRows<2>(at);
    }
    parts.row(static_cast<Eigen::Index>(m)) = r_u / mode.stiffness * r_z;
  }
  return parts;
}

} // namespace spricka::estimate
