// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/recover_step.hpp"

#include "analysis/recover/body_overlap.hpp"
#include "analysis/recover/closed_parts.hpp"
#include "analysis/recover/contact_limits.hpp"
#include "analysis/recover/judge_faces.hpp"
#include "analysis/recover/judge_size.hpp"
#include "analysis/scene/tip_name.hpp"
#include "analysis/scene/tip_surroundings.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "base/tidy.hpp"
#include "contact/marked_arc.hpp"
#include "contact/recovery.hpp"
#include "contact/slave_places.hpp"
#include "crack/rough_loads.hpp"
#include "crack/stress_intensity.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double known_part = 0.25; // of the distance of nodes where faces part

const model::Vce* vce_of(const model::Model& model, base::CrackId crack) {
  for (const model::Vce& vce : model.vces) {
    if (vce.crack == crack) {
      return &vce;
    }
  }
  return nullptr;
}

void gather_tips(const model::Model& model, const Scene& scene, const StepState& state,
                 results::StepResult& out) {
  for (std::size_t t = 0; t < scene.cracked.fronts.size(); ++t) {
    const mesh::Front& front = scene.cracked.fronts[t];
    const model::Crack& crack = model.cracks[front.crack.index()];
    crack::VceRequest request;
    request.state = crack.state;
    if (const model::Vce* vce = vce_of(model, front.crack)) {
      request.shift = vce->shift;
      request.opening = vce->opening;
    }
    const std::optional<crack::CrackFaceForces> crack_faces =
        crack_face_forces(scene, front, state);
    request.crack_faces = crack_faces ? &*crack_faces : nullptr;
    const std::vector<crack::ExtensionField>& fields = scene.tips[t].fields;
    const crack::TipLoads loads = tip_loads(model, scene, fields, state.case_factor);
    const crack::StressIntensity K =
        crack::stress_intensity(model, scene.cracked, front, fields, request, state.u, loads);
    results::TipResult result;
    result.name = tip_name(model, scene.cracked, front);
    result.a = base::tidy(front.a);
    result.x = front.tip().x;
    result.direction = front.tip().growth;
    result.K1 = K.K1;
    result.K2 = K.K2;
    result.G = K.G;
    result.G_from_K = K.G_from_K;
    result.spread = K.spread;
    result.T = K.T;
    result.K_opening = K.opening;
    std::vector<bool> rough;
    if (!fields.empty()) {
      rough = crack::rough_rims(crack::tip_setting(model, scene.cracked, front, fields, loads),
                                fields, std::hypot(K.K1, K.K2));
    }
    for (std::size_t d = 0; d < K.domains.size(); ++d) {
      if (!rough[d]) { // others are no measure of each other
        result.K1_domain.push_back(K.domains[d].K1);
      }
    }
    if (K.shift_error && std::abs(*K.shift_error) > 2e-5) { // of G; 1e-5 of K (crack.15)
      out.notes.push_back(results::warning(fmt::format(
          "{}: G by the finite shift is {:+.2g} of the analytic one off; the shift is too "
          "large or lost in round-off",
          result.name, *K.shift_error)));
    }
    if (!K.domains.empty() && std::ranges::all_of(K.domains, [](const crack::DomainValue& d) {
          return std::isnan(d.G);
        })) {
      out.notes.push_back(
          results::note(fmt::format("{}: loads or temperatures jump within all domains of K, "
                                    "which leave G to K: it is (K1^2 + K2^2)/E'",
                                    result.name)));
    }
    result.two_materials = K.two_materials;
    judge_faces({model, scene, front, state, K}, result, out);
    out.tips.push_back(std::move(result));
  }
}

// Stick, slip and shear of a pair with friction. Rows have the slip of the target side along the
// contact side. The slave's along itself is the negative on either side: both run opposite ways.
void gather_friction(const Scene& scene, const StepState& state, std::size_t c,
                     const contact::PairPressure& p, results::ContactResult& result) {
  const contact::PairRows& pair = scene.pairs[c];
  const PairFriction& friction = state.friction[c];
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  std::vector<Eigen::Index> slip_row(pair.normal.size(), -1);
  for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
    slip_row[static_cast<std::size_t>(pair.tangent[i].normal)] =
        normals + static_cast<Eigen::Index>(i);
  }
  const bool round = contact::counts_angles(pair);
  std::vector<contact::ArcNode> arc;
  result.rubs = true;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    results::ContactPoint& point = result.points[i];
    contact::ArcNode node{round ? point.theta : point.arc, false, 0.0};
    if (p.nodes[i].row >= 0 && point.closed) {
      const auto row = static_cast<Eigen::Index>(p.nodes[i].row);
      const double area = pair.normal[static_cast<std::size_t>(row)].area;
      const double limit = friction.mu * state.pair_lambda[c][row];
      const double shear = std::abs(state.pair_lambda[c][slip_row[static_cast<std::size_t>(row)]]);
      point.state = friction.touch[static_cast<std::size_t>(row)] == solve::Touch::stick
                        ? results::ContactState::stick
                        : results::ContactState::slip;
      point.slip = -friction.slip[row] / area;
      point.slip_path = friction.path[row] / area;
      node = {node.s, point.state == results::ContactState::stick, limit - shear};
      (node.in ? result.sticking : result.slipping) += 1;
      result.shear_ratio = std::max(result.shear_ratio, limit > 0.0 ? shear / limit : 0.0);
      result.max_slip = std::max(result.max_slip, point.slip_path);
    }
    arc.push_back(node);
  }
  const contact::Arc stick = contact::marked_arc(std::move(arc), round);
  result.stick_from = stick.from;
  result.stick_to = stick.to;
  result.friction_work = friction.work;
}

// Edges of one surface against the other that are pressed.
std::vector<base::Vec3> pressed_edges(const contact::PairRows& pair,
                                      const std::vector<contact::NodePressure>& nodes) {
  std::vector<base::Vec3> places;
  for (const contact::SharpEnd& end : pair.sharp_ends) {
    const bool pressed = std::ranges::any_of(nodes, [&](const contact::NodePressure& n) {
      return n.closed && n.p_consistent > 0.0 &&
             std::ranges::find(end.nodes, n.node) != end.nodes.end();
    });
    if (pressed) {
      const auto clean = [&](double c) { return std::abs(c) < 1e-9 * end.x.norm() ? 0.0 : c; };
      places.emplace_back(clean(end.x.x()), clean(end.x.y()), 0.0);
    }
  }
  return places;
}

std::string unbounded_note(const results::ContactResult& contact) {
  constexpr std::size_t most = 4;
  std::vector<std::string> places;
  for (const base::Vec3& x : contact.unbounded) {
    if (places.size() < most) {
      places.push_back(fmt::format("({:.6g}, {:.6g})", x.x(), x.y()));
    }
  }
  if (contact.unbounded.size() > most) {
    places.push_back(fmt::format("{} more", contact.unbounded.size() - most));
  }
  return fmt::format("{} is pressed up to an edge of one surface, where pressure in general has "
                     "no bound: its largest value belongs to the mesh ({})",
                     contact.name, fmt::join(places, ", "));
}

// The only face of a half model runs with its body on the left, which may be from the tip on: its
// places count from the mouth.
void count_from_mouth(const Scene& scene, std::size_t pair, results::ContactResult& result) {
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
void note_parting(const Scene& scene, std::size_t pair, results::ContactResult& result,
                  results::StepResult& out) {
  const bool faces = std::ranges::any_of(scene.crack_face_pairs,
                                         [&](const std::optional<CrackFacePair>& crack_face) {
                                           return crack_face && crack_face->pair == pair;
                                         });
  for (const double end : {result.arc_from, result.arc_to}) {
    for (std::size_t i = 1; faces && i < result.points.size(); ++i) {
      const results::ContactPoint& a = result.points[i - 1];
      const results::ContactPoint& b = result.points[i];
      const double reach = 0.5 * (b.arc - a.arc); // an end may lie beyond (contact.11)
      if (a.closed != b.closed && end >= a.arc - reach && end <= b.arc + reach) {
        out.notes.push_back(results::note(
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

void gather_contacts(const Scene& scene, const StepState& state, results::StepResult& out) {
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairRows& pair = scene.pairs[c];
    const contact::PairPressure p = contact::recover_pressure(
        pair, state.pair_lambda[c], state.pair_gap[c], state.pair_closed[c],
        scene.contacts[c].type == model::ContactType::bonded);
    results::ContactResult result;
    result.name = scene.contacts[c].name;
    result.mounted = state.mounted[c];
    result.force_on_slave = p.force_on_slave;
    result.mean_pressure = p.mean_pressure;
    result.max_penetration = p.max_penetration;
    result.area = p.area;
    result.space = scene.cracked.mesh.dim == 3;
    result.round = contact::counts_angles(pair);
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
    count_from_mouth(scene, c, result);
    note_parting(scene, c, result, out);
    result.unbounded = pressed_edges(pair, p.nodes);
    if (!result.unbounded.empty()) {
      out.notes.push_back(results::note(unbounded_note(result)));
    }
    const bool unilateral = scene.contacts[c].type == model::ContactType::unilateral;
    const std::string parts =
        result.mounted && unilateral && !result.space ? parts_note(result) : std::string();
    if (!parts.empty()) {
      out.notes.push_back(results::note(parts));
    }
    out.contacts.push_back(std::move(result));
  }
}

void add_node(results::Balance& balance, const StepState& state, base::NodeId n, int dim) {
  const auto at = static_cast<Eigen::Index>(n.index()) * dim;
  balance.applied.head(dim) += state.force.segment(at, dim);
  balance.contact.head(dim) += state.contact.segment(at, dim);
  balance.reaction.head(dim) += state.reaction.segment(at, dim);
  if (state.tie.size() > 0) {
    balance.tie.head(dim) += state.tie.segment(at, dim);
  }
}

void drop_radial(results::Balance& balance) { // radial forces balance round the circumference
  for (base::Vec3* sum : {&balance.applied, &balance.contact, &balance.reaction, &balance.tie}) {
    sum->x() = 0.0;
  }
}

void gather_bodies(const model::Model& model, const Scene& scene,
                   const std::vector<BodyNet>& bodies, const StepState& state,
                   results::StepResult& out) {
  for (const BodyNet& body : bodies) {
    results::Balance balance;
    balance.body = body.name;
    for (const base::NodeId n : body.body.nodes) {
      add_node(balance, state, n, scene.cracked.mesh.dim);
    }
    for (const base::ElementId e : body.body.elements) {
      balance.energy += state.energy[e.index()];
    }
    if (model::axisymmetric(model)) {
      drop_radial(balance);
    }
    out.balance.push_back(balance);
  }
}

// What presses on a rigid target has to be taken by whatever holds it.
void gather_targets(const model::Model& model, const results::StepResult& found,
                    std::vector<results::Balance>& targets) {
  for (std::size_t r = 0; r < model.rigids.size(); ++r) {
    results::Balance balance;
    balance.body = model.rigids[r].name;
    bool used = false;
    for (std::size_t c = 0; c < model.contacts.size(); ++c) {
      if (model.contacts[c].rigid == base::RigidId(r)) {
        balance.contact -= found.contacts[c].force_on_slave;
        used = true;
      }
    }
    balance.reaction = -balance.contact;
    if (model::axisymmetric(model)) {
      drop_radial(balance);
    }
    if (used) {
      targets.push_back(balance);
    }
  }
}

void gather_nets(const model::Model& model, const Scene& scene, const StepState& state,
                 results::StepResult& out) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<results::Balance> nets(model.nets.size());
  std::vector<bool> used(model.nets.size(), false);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    used[mesh.element_net[e].index()] = true;
    nets[mesh.element_net[e].index()].energy += state.energy[e];
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    add_node(nets[mesh.node_net[n].index()], state, base::NodeId(n), mesh.dim);
  }
  for (std::size_t n = 0; n < nets.size(); ++n) {
    nets[n].body = model.nets[n].name.empty() ? "(deck)" : model.nets[n].name;
    if (model::axisymmetric(model)) {
      drop_radial(nets[n]);
    }
    if (used[n]) {
      out.nets.push_back(nets[n]);
    }
  }
}

} // namespace

results::StepResult gather_step(const model::Model& model, const Scene& scene,
                                const std::vector<BodyNet>& bodies, const model::Step& step,
                                const StepState& state) {
  results::StepResult out;
  out.step = step.name;
  out.u = state.u;
  out.reaction = state.reaction;
  out.temperature = state.temperature;
  out.energy = std::accumulate(state.energy.begin(), state.energy.end(), 0.0);
  out.tied = state.tie.size() > 0;
  out.increments = state.increments;
  out.iterations = state.iterations;
  out.pivots = state.pivots;
  out.notes = state.notes;
  gather_tips(model, scene, state, out);
  gather_contacts(scene, state, out);
  gather_bodies(model, scene, bodies, state, out);
  gather_nets(model, scene, state, out);
  gather_targets(model, out, out.targets);
  judge_size(model, scene, bodies, state, out);
  if (scene.cracked.mesh.dim == 2) {
    tell_slides(scene, state, out);
    tell_overlaps(model, scene, bodies, state, out);
  }
  return out;
}

} // namespace spricka::analysis
