// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_recovery.hpp"

#include "base/index.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace spricka::contact {

using base::index;

namespace {

constexpr double all_covered = 1e-4; // of a function's area: what integration may miss

// What the node k of a face gives to its corner c: all of its own, half of the middle of a side
// that ends there, a quarter of the centre.
double share_of(std::size_t c, std::size_t k, std::size_t corners) {
  if (k < corners) {
    return k == c ? 1.0 : 0.0;
  }
  const std::size_t side = k - corners; // from corner `side` to the next
  return k == 2 * corners ? 0.25 : side == c || (side + 1) % corners == c ? 0.5 : 0.0;
}

// The functions of each face, by its nodes.
std::vector<std::vector<std::size_t>> functions_by_face(const PairRows& pair) {
  const SpaceSurface& surface = pair.contact.space;
  std::map<std::pair<std::size_t, base::NodeId>, std::size_t> place;
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    place[{pair.functions[i].part, pair.functions[i].node}] = i;
  }
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::vector<std::size_t>& at = all.emplace_back();
    for (const base::NodeId n : surface.faces[f].nodes) {
      at.push_back(place.at({surface.part[f], n}));
    }
  }
  return all;
}

// Averages to corners, P_c = sum share w p / sum share w over the faces round a corner
// (contact_space.6), and what is linear between these; as p itself where a face round the corner is
// not all covered and closed.
base::Vector averaged(const PairRows& pair, const base::Vector& p,
                      const std::vector<bool>& closed) {
  const std::vector<std::vector<std::size_t>> faces = functions_by_face(pair);
  std::vector<std::map<std::size_t, double>> given(pair.functions.size()); // to corners, by giver
  std::vector<bool> sound(pair.functions.size(), true);
  const auto corners_of = [&](std::size_t f) {
    return static_cast<std::size_t>(base::info(pair.contact.space.faces[f].shape).corners);
  };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool all = std::ranges::all_of(faces[f], [&](std::size_t i) {
      const SpaceFunction& own = pair.functions[i];
      return closed[i] && !own.joined && own.area >= (1.0 - all_covered) * own.whole;
    });
    for (std::size_t c = 0; c < corners_of(f); ++c) {
      sound[faces[f][c]] = sound[faces[f][c]] && all;
      for (std::size_t k = 0; k < faces[f].size(); ++k) {
        if (const double share = share_of(c, k, corners_of(f)); share > 0.0) {
          given[faces[f][c]][faces[f][k]] = share;
        }
      }
    }
  }
  const auto corner = [&](std::size_t i) {
    double force = 0.0;
    double area = 0.0;
    for (const auto& [giver, share] : given[i]) {
      force += share * pair.functions[giver].area * p[index(giver)];
      area += share * pair.functions[giver].area;
    }
    return force / area;
  };
  base::Vector out = p;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      double mean = 0.0;
      bool known = true;
      for (std::size_t c = 0; c < corners_of(f); ++c) {
        if (const double share = share_of(c, k, corners_of(f)); share > 0.0) {
          known = known && sound[faces[f][c]];
          mean += known ? share * corner(faces[f][c]) : 0.0;
        }
      }
      if (known) {
        out[index(faces[f][k])] = mean;
      }
    }
  }
  return out;
}

// Node by node: the function's part of the surface says where it stands about an axis.
NodePressure place_of(const PairRows& pair, const SpaceFunction& function, const base::Vec3& x) {
  NodePressure at;
  at.node = function.node;
  at.x = x;
  if (const std::optional<Round>& round = pair.contact.space.rounds[function.part]) {
    const RoundPlace place = place_on(*round, x);
    at.theta = place.angle;
    at.arc = place.along;
  }
  at.row = function.row;
  return at;
}

base::Vec3 force_on_contact_side(const PairRows& pair, const base::Vector& lambda) {
  std::vector<base::NodeId> own;
  for (const SpaceFunction& function : pair.functions) {
    own.push_back(function.node);
  }
  std::ranges::sort(own);
  base::Vec3 total = base::Vec3::Zero();
  const auto add = [&](const ConstraintRow& row, double value) {
    for (const RowEntry& entry : row.entries) {
      if (std::ranges::binary_search(own, entry.node)) {
        total += value * entry.weight;
      }
    }
  };
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    add(pair.normal[i], lambda[index(i)]);
  }
  for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
    add(pair.tangent[i], lambda[index(pair.normal.size() + i)]);
  }
  return total;
}

std::map<base::NodeId, base::Vec3> places_of_nodes(const SpaceSurface& surface) {
  std::map<base::NodeId, base::Vec3> x;
  for (const SolidFace& face : surface.faces) {
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      x[face.nodes[i]] = face.X.col(index(i));
    }
  }
  return x;
}

} // namespace

PairPressure recover_space_pressure(const PairRows& pair, const base::Vector& lambda,
                                    const base::Vector& gap, const std::vector<bool>& closed) {
  const auto n = index(pair.functions.size());
  base::Vector p = base::Vector::Zero(n);
  std::vector<bool> touches(pair.functions.size(), false);
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    if (const int row = pair.functions[i].row; row >= 0) {
      p[index(i)] = lambda[row];
      touches[i] = closed[static_cast<std::size_t>(row)];
    }
  }
  const base::Vector smooth = averaged(pair, p, touches);
  const std::map<base::NodeId, base::Vec3> x = places_of_nodes(pair.contact.space);

  PairPressure result;
  const base::Vec3 total = force_on_contact_side(pair, lambda);
  result.force_on_slave = pair.swapped ? base::Vec3(-total) : total;
  double thrust = 0.0;
  double area = 0.0;
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    const auto i = index(r);
    const double own = pair.normal[r].area;
    thrust += lambda[i] * own;
    area += closed[r] ? own : 0.0;
    result.min_pressure = r == 0 ? lambda[i] : std::min(result.min_pressure, lambda[i]);
    result.max_pressure = std::max(result.max_pressure, lambda[i]);
    result.closed += closed[r] ? 1 : 0;
    result.max_penetration = std::max(result.max_penetration, -gap[i] / own);
  }
  result.area = area;
  result.mean_pressure = area > 0.0 ? thrust / area : 0.0;
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    const SpaceFunction& function = pair.functions[i];
    NodePressure at = place_of(pair, function, x.at(function.node));
    at.p_consistent = p[index(i)];
    at.p_lumped = smooth[index(i)];
    at.closed = touches[i];
    if (function.row >= 0) {
      at.gap = gap[function.row] / pair.normal[static_cast<std::size_t>(function.row)].area;
    }
    result.nodes.push_back(at);
  }
  const SpaceSurface& surface = pair.contact.space;
  const std::vector<std::vector<std::size_t>> faces = functions_by_face(pair);
  for (const SurfaceTriangle& t : surface.triangles) {
    const std::vector<std::size_t>& at = faces[t.face];
    const auto place = [&](int i) { return at[static_cast<std::size_t>(i)]; };
    result.triangles.push_back({place(t.node[0]), place(t.node[1]), place(t.node[2])});
  }
  if (surface.rounds.size() == 1 && surface.rounds[0] && has_axis(*surface.rounds[0])) {
    for (const NodePressure& at : result.nodes) {
      const double here = surface.rounds[0]->radius + surface.rounds[0]->slope * at.arc;
      result.radius += here / static_cast<double>(result.nodes.size());
    }
  }
  return result;
}

} // namespace spricka::contact
