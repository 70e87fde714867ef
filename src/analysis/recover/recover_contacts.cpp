// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/recover_contacts.hpp"

#include "analysis/recover/closed_parts.hpp"
#include "base/tidy.hpp"
#include "contact/marked_arc.hpp"
#include "contact/recovery.hpp"
#include "contact/slave_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double most_unrest = 0.05; // of the pressure, root mean square
constexpr double known_part = 0.25;  // of the distance of nodes where faces part
// Elements across a spot below which its largest pressure is told to be off, and how far it is with
// one, read off spheres on half spaces (manual, contact_limits.md).
constexpr double least_across_peak = 2.0;
constexpr double off_by_one_across = 0.3;

// Stick, slip and shear of a pair with friction. Rows have the slip of the target side along the
// contact side. The slave's along itself is the negative on either side: both run opposite ways.
void gather_friction(const Discretisation& scene, const StepState& state, std::size_t c,
                     const contact::PairPressure& p, results::ContactResult& result) {
  const contact::PairConstraints& pair = scene.pairs[c];
  const PairFrictionState& friction = state.friction[c];
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  base::Vector shear = base::Vector::Zero(normals); // size, of all tangents of a normal row
  for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
    double& sum = shear[pair.tangent[i].normal];
    sum = std::hypot(sum, state.pair_lambda[c][normals + static_cast<Eigen::Index>(i)]);
  }
  const bool round = contact::uses_angular_coordinate(pair);
  std::vector<contact::ContactArcNode> arc;
  std::vector<bool> counted(pair.normal.size(), false); // in space nodes may have one row
  result.rubs = true;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    results::ContactPoint& point = result.points[i];
    contact::ContactArcNode node{round ? point.theta : point.arc, false, 0.0};
    if (p.nodes[i].row >= 0 && point.closed) {
      const auto row = static_cast<Eigen::Index>(p.nodes[i].row);
      const double area = pair.normal[static_cast<std::size_t>(row)].area;
      const double limit = friction.mu * state.pair_lambda[c][row];
      point.state = friction.touch[static_cast<std::size_t>(row)] == solve::SlipState::stick
                        ? results::ContactState::stick
                        : results::ContactState::slip;
      point.slip = (result.space ? 1.0 : -1.0) * friction.slip[row] / area; // in space a size
      point.slip_path = friction.path[row] / area;
      node = {node.s, point.state == results::ContactState::stick, limit - shear[row]};
      if (!counted[static_cast<std::size_t>(row)]) {
        counted[static_cast<std::size_t>(row)] = true;
        (node.in ? result.sticking : result.slipping) += 1;
        result.stick_area += result.space && node.in ? area : 0.0;
      }
      result.shear_ratio = std::max(result.shear_ratio, limit > 0.0 ? shear[row] / limit : 0.0);
      result.max_slip = std::max(result.max_slip, point.slip_path);
    }
    arc.push_back(node);
  }
  if (!result.space) {
    const contact::SurfaceInterval stick = contact::longest_marked_arc(std::move(arc), round);
    result.stick_from = stick.from;
    result.stick_to = stick.to;
  }
  result.friction_work = friction.work;
}

// Edges of one surface against the other that are pressed. A place in space is that of the node
// which is pressed most.
std::vector<base::Vec3> pressed_edges(const contact::PairConstraints& pair,
                                      const std::vector<contact::NodePressure>& nodes) {
  std::vector<base::Vec3> places;
  for (const contact::SingularContactEdge& end : pair.sharp_ends) {
    double most = 0.0;
    base::Vec3 place = end.x;
    for (const contact::NodePressure& n : nodes) {
      if (n.closed && n.p_consistent > most &&
          std::ranges::find(end.nodes, n.node) != end.nodes.end()) {
        most = n.p_consistent;
        place = end.is_point ? place : n.x;
      }
    }
    if (most > 0.0 && !end.bounded) {
      places.push_back(place.unaryExpr(
          [least = 1e-9 * place.norm()](double c) { return std::abs(c) < least ? 0.0 : c; }));
    }
  }
  return places;
}

std::string unbounded_note(const results::ContactResult& contact) {
  constexpr std::size_t most = 4;
  std::vector<std::string> places;
  for (const base::Vec3& x : contact.unbounded) {
    if (places.size() < most) {
      places.push_back(base::format_coordinates(x, contact.space ? 3 : 2));
    }
  }
  if (contact.unbounded.size() > most) {
    places.push_back(fmt::format("{} more", contact.unbounded.size() - most));
  }
  return fmt::format("{} is pressed up to an edge of one surface, where pressure in general has "
                     "no bound: its largest value belongs to the mesh ({})",
                     contact.name, fmt::join(places, ", "));
}

// What pressure that goes up and down does, and what to do about it.
std::string unrest_note(const std::string& contact, double unrest, bool declared) {
  return fmt::format("{}: the pressure goes up and down by {:.0f} % from node to node: its largest "
                     "value and p_consistent are off by as much; p_lumped, forces and K, which "
                     "take means, are not. {}",
                     contact, 100.0 * unrest,
                     declared ? "The side that has the pressure is too fine or too stiff beside "
                                "the other: MULTIPLIER=CORNER is quieter"
                              : "A measured gap holds the facets of curved faces: declare it, or "
                                "use MULTIPLIER=CORNER");
}

// What a spot is known to that few elements lie across (manual, contact_limits.md).
std::string small_spot_note(const std::string& contact, double across) {
  return fmt::format(
      "{}: only {:.2g} elements lie across the spot where it presses most: its "
      "largest pressure may be off by {:.0f} %, and so may the size of the spot; its force "
      "is not. Take elements of a third of the spot there",
      contact, across, 100.0 * off_by_one_across / across);
}

struct SmallContactSpot {
  std::string contact;
  double force = 0.0;
  double across = 0.0; ///< elements
};

// A contact that hardly presses beside the others is not what a step is about.
void tell_small_spots(const std::vector<SmallContactSpot>& spots, results::LoadStepResult& out) {
  constexpr double counts = 0.05; // of the largest contact force
  double most = 0.0;
  for (const SmallContactSpot& spot : spots) {
    most = std::max(most, spot.force);
  }
  for (const SmallContactSpot& spot : spots) {
    if (spot.across < least_across_peak && spot.force > counts * most) {
      out.notes.push_back(results::less_exact_note(small_spot_note(spot.contact, spot.across)));
    }
  }
}

// The only face of a half model runs with its body on the left, which may be from the tip on: its
// places count from the mouth.
void count_from_mouth(const Discretisation& scene, std::size_t pair,
                      results::ContactResult& result) {
  for (std::size_t i = 0; i < scene.crack_face_pairs.size(); ++i) {
    if (scene.crack_face_pairs[i] && scene.crack_face_pairs[i]->pair == pair &&
        scene.cracked.faces[i].left.empty() && !result.points.empty()) {
      const double length = result.points.back().arc;
      std::ranges::reverse(result.points);
      for (results::ContactPoint& point : result.points) {
        point.arc = length - point.arc;
      }
      if (result.closed > 0) {
        result.arc_from = length - std::exchange(result.arc_to, length - result.arc_from);
      }
    }
  }
}

// Whether the nodes on either side of the interval that ends with point i are a few at least in the
// same state: how pressure and gap go to nothing can then be told.
bool many_alike(const std::vector<results::ContactPoint>& points, std::size_t i) {
  constexpr std::size_t few = 3;
  std::size_t before = 1;
  while (before < i && points[i - 1 - before].closed == points[i - 1].closed) {
    ++before;
  }
  std::size_t behind = 1;
  while (i + behind < points.size() && points[i + behind].closed == points[i].closed) {
    ++behind;
  }
  return before >= few && behind >= few;
}

// Where the faces of a crack part: pressure and gap are known at nodes, and how both go to nothing
// between two of them tells the place to less than a quarter of their distance; where one or two
// nodes are all that is closed or open, to their distance.
void note_parting(const Discretisation& scene, std::size_t pair, results::ContactResult& result,
                  results::LoadStepResult& out) {
  const bool faces =
      !result.space && std::ranges::any_of(scene.crack_face_pairs,
                                           [&](const std::optional<CrackFacePair>& crack_face) {
                                             return crack_face && crack_face->pair == pair;
                                           });
  for (const double end : {result.arc_from, result.arc_to}) {
    for (std::size_t i = 1; faces && i < result.points.size(); ++i) {
      const results::ContactPoint& a = result.points[i - 1];
      const results::ContactPoint& b = result.points[i];
      const double reach = 0.5 * (b.arc - a.arc); // an end may lie beyond (contact.11)
      if (a.closed != b.closed && end >= a.arc - reach && end <= b.arc + reach) {
        out.notes.push_back(results::make_note(
            fmt::format("{}: the faces part at {:.4g} along the crack, +- {:.2g} "
                        "by the distance of its nodes there",
                        result.name, end,
                        (many_alike(result.points, i) ? known_part : 1.0) * (b.arc - a.arc))));
        break;
      }
    }
  }
}

// In space: along the axis of a round surface, then round it; others by their nodes. The triangles
// go with them.
void by_places(const contact::PairPressure& pressure, results::ContactResult& result) {
  std::vector<std::size_t> order(result.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    const results::ContactPoint& p = result.points[i];
    return std::tuple(p.arc, p.theta, p.node);
  });
  std::vector<results::ContactPoint> sorted;
  std::vector<int> place(order.size());
  for (const std::size_t i : order) {
    place[i] = static_cast<int>(sorted.size());
    sorted.push_back(result.points[i]);
  }
  result.points = std::move(sorted);
  for (const std::array<std::size_t, 3>& triangle : pressure.triangles) {
    for (const std::size_t i : triangle) {
      result.corners.push_back(place[i]);
    }
  }
}

} // namespace

void recover_contacts(const Discretisation& scene, const StepState& state,
                      results::LoadStepResult& out) {
  std::vector<SmallContactSpot> spots;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairConstraints& pair = scene.pairs[c];
    const contact::PairPressure p = contact::recover_pressure(
        pair, state.pair_lambda[c], state.pair_gap[c], state.pair_closed[c],
        scene.contacts[c].type == model::ContactType::bonded);
    results::ContactResult result;
    result.name = scene.contacts[c].name;
    result.mounted = state.mounted[c];
    result.force_on_slave = p.force_on_slave;
    result.moment_on_slave = p.moment_on_slave;
    result.mean_pressure = p.mean_pressure;
    result.max_penetration = p.max_penetration;
    result.area = p.area;
    result.space = scene.cracked.mesh.dim == 3;
    result.round = contact::uses_angular_coordinate(pair);
    result.arc_from = p.arc_from;
    result.arc_to = p.arc_to;
    result.closed = p.closed;
    result.rows = static_cast<int>(pair.normal.size());
    result.min_pressure = p.min_pressure;
    result.max_pressure = p.max_pressure;
    for (const contact::NodePressure& n : p.nodes) {
      results::ContactPoint point;
      point.node = n.node;
      point.x = n.x;
      point.theta = n.theta;
      point.arc = n.arc;
      point.p_lumped = n.p_lumped;
      point.p_consistent = n.p_consistent;
      point.q_lumped = n.q_lumped;
      point.q_consistent = n.q_consistent;
      point.shear = n.shear;
      point.state = n.closed ? results::ContactState::closed : results::ContactState::open;
      point.gap = n.gap;
      point.closed = n.closed;
      point.crack_face = n.crack_face;
      result.points.push_back(point);
    }
    result.sheared = !pair.tangent.empty();
    if (!state.friction.empty() && !state.friction[c].touch.empty() && result.mounted) {
      gather_friction(scene, state, c, p, result);
      out.friction_work += result.friction_work;
    }
    if (result.space) {
      result.radius = p.radius;
      by_places(p, result);
    } else if (!result.round) {
      if (pair.swapped) { // which runs the other way
        std::ranges::reverse(result.points);
      }
      std::ranges::stable_sort(result.points, {}, &results::ContactPoint::arc);
    }
    const bool unilateral = scene.contacts[c].type == model::ContactType::unilateral;
    count_from_mouth(scene, c, result);
    note_parting(scene, c, result, out);
    if (p.unrest > most_unrest) {
      out.notes.push_back(results::less_exact_note(
          unrest_note(result.name, p.unrest, scene.contacts[c].gap.has_value())));
    }
    if (unilateral && result.mounted) {
      spots.push_back({result.name, result.mean_pressure * result.area, p.across_peak});
    }
    result.unbounded = pressed_edges(pair, p.nodes);
    if (!result.unbounded.empty()) {
      out.notes.push_back(results::make_note(unbounded_note(result)));
    }
    const std::string parts = result.mounted && unilateral && !result.space
                                  ? describe_closed_parts(result)
                                  : std::string();
    if (!parts.empty()) {
      out.notes.push_back(results::make_note(parts));
    }
    out.contacts.push_back(std::move(result));
  }
  tell_small_spots(spots, out);
}

} // namespace spricka::analysis
