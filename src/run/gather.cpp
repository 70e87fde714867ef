// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/gather.hpp"

#include "contact/marked_arc.hpp"
#include "contact/sharp_end.hpp"
#include "crack/stress_intensity.hpp"
#include "run/lip_contact.hpp"
#include "run/lip_overlap.hpp"
#include "run/tip_loads.hpp"
#include "run/tip_name.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace spricka::run {

namespace {

const model::Vce* vce_of(const model::Model& model, base::CrackId crack) {
  for (const model::Vce& vce : model.vces) {
    if (vce.crack == crack) {
      return &vce;
    }
  }
  return nullptr;
}

// Fewer open nodes than these between the tip and the closed part of the faces: two elements.
constexpr int least_open_nodes = 4;
// K1 of the rings at a closed tip should be what the mesh cannot tell from 0, over that of k_scale.
constexpr double worst_closed_K1 = 0.05;

// Faces that do not overlap have no negative K1; where one is found it is 0 but for so much.
constexpr double small_K1 = 1e-3;

// FACES=FREE: what overlaps is told, and K1 < 0 is no answer even so.
void tell_overlap(const Scene& scene, const mesh::Tip& tip, const StepState& state,
                  results::TipResult& result, results::StepResult& out) {
  if (result.K1 < 0.0 && std::abs(result.K1) > 1e-9 * std::abs(result.K2)) {
    result.doubt = "K1 is negative: the crack faces overlap, which FACES=FREE lets them, so this K "
                   "is not an answer";
    out.notes.push_back(fmt::format("warning: {}: {}", result.name, result.doubt));
  } else if (const double part = lone_overlap(scene.cracked, tip.crack.index(), state.u);
             part > overlap_of_round_off) {
    out.notes.push_back(
        fmt::format("warning: {}: the crack faces overlap over a part of the crack, "
                    "by {:.1e} of their largest displacement, which FACES=FREE "
                    "lets them",
                    result.name, part));
  }
}

// Less than an element that overlaps is no contact (lip_overlap).
void tell_lone_overlap(const Scene& scene, const mesh::Tip& tip, const StepState& state,
                       const results::TipResult& result, results::StepResult& out) {
  const double part = lone_overlap(scene.cracked, tip.crack.index(), state.u);
  if (part > overlap_of_round_off) {
    out.notes.push_back(fmt::format(
        "warning: {}: the crack faces overlap at single nodes, by {:.1e} of their largest "
        "displacement: less than the mesh resolves, and left open",
        result.name, part));
  }
}

// Where the faces touch at the tip they do not part there: K1 is 0, and so is K2 where they have
// not slipped either. What the rings find instead is the error of the mesh.
void close_tip(const TipFaces& faces, double scale, results::TipResult& result,
               results::StepResult& out) {
  const double K1 = result.K1;
  if (faces.closed) {
    result.closed = true;
    result.K1 = 0.0;
    const double all = K1 * K1 + result.K2 * result.K2;
    result.K2 = faces.held ? 0.0 : result.K2;
    result.G = faces.held ? 0.0 : result.G;
    result.G_from_K *= all > 0.0 ? result.K2 * result.K2 / all : 0.0;
    if (std::abs(K1) > worst_closed_K1 * scale) {
      out.notes.push_back(
          fmt::format("warning: {}: the crack faces touch at the tip, but the rings "
                      "find K1 = {:.3g}: the mesh there is too coarse",
                      result.name, K1));
    }
    out.notes.push_back(
        fmt::format("{}: the crack faces touch at the tip{}", result.name,
                    faces.held ? " and have not slipped: K1 = K2 = 0" : ": K1 = 0"));
  } else if (faces.open_nodes > 0 && faces.open_nodes < least_open_nodes) {
    out.notes.push_back(fmt::format("warning: {}: the crack faces are open at the tip over less "
                                    "than two elements; K is that of the mesh",
                                    result.name));
  }
  if (!faces.closed && K1 < 0.0 && std::abs(K1) <= small_K1 * scale) {
    result.K1 = 0.0;
  } else if (!faces.closed && K1 < 0.0) {
    result.doubt = "K1 is negative though the crack faces do not overlap: the mesh at the tip is "
                   "too coarse, so this K is not an answer";
    out.notes.push_back(fmt::format("warning: {}: {}", result.name, result.doubt));
  }
}

// Whether K is nothing but the round-off of displacements that a crack is carried along with.
bool is_round_off(const crack::StressIntensity& K, const mesh::Tip& tip, const base::Vector& u) {
  const double scale = K.E_effective * u.cwiseAbs().maxCoeff() / std::sqrt(tip.a);
  return std::hypot(K.K1, K.K2) <= 1e-9 * scale;
}

// K of the size that pressure between the faces, or their largest displacement against each other,
// has at a crack of this length under uniform stress; no less than what round-off makes of it.
double k_scale(const Scene& scene, const mesh::Tip& tip, const StepState& state,
               const TipFaces& faces, const crack::StressIntensity& K) {
  const double pressed = faces.pressure * std::sqrt(std::numbers::pi * tip.a);
  const double jump = lip_jump(scene.cracked, tip.crack.index(), state.u);
  const double open = 0.25 * K.E_effective * jump * std::sqrt(std::numbers::pi / tip.a);
  const double least = 1e-6 * K.E_effective * state.u.lpNorm<Eigen::Infinity>() / std::sqrt(tip.a);
  return std::max({pressed, open, least});
}

void gather_tips(const model::Model& model, const Scene& scene, const StepState& state,
                 results::StepResult& out) {
  for (std::size_t t = 0; t < scene.cracked.tips.size(); ++t) {
    const mesh::Tip& tip = scene.cracked.tips[t];
    const model::Crack& crack = model.cracks[tip.crack.index()];
    crack::VceRequest request;
    request.state = crack.state;
    if (const model::Vce* vce = vce_of(model, tip.crack)) {
      request.shift = vce->shift;
      request.opening = vce->opening;
    }
    const std::optional<crack::LipForces> lips = lip_forces(scene, tip, state);
    request.lips = lips ? &*lips : nullptr;
    const crack::StressIntensity K =
        crack::stress_intensity(model, scene.cracked, tip, scene.tips[t].fields, request, state.u,
                                tip_loads(model, scene, scene.tips[t].fields, state.case_factor));
    results::TipResult result;
    result.name = tip_name(model, scene.cracked, tip);
    result.a = tip.a;
    result.x = tip.x;
    result.direction = tip.direction;
    result.K1 = K.K1;
    result.K2 = K.K2;
    result.G = K.G;
    result.G_from_K = K.G_from_K;
    result.spread = K.spread;
    result.has_T = !K.two_materials;
    result.T = result.has_T ? K.T : 0.0;
    result.K_opening = K.opening;
    for (const crack::DomainValue& d : K.domains) {
      result.K1_domain.push_back(d.K1);
    }
    if (K.shift_error && std::abs(*K.shift_error) > 2e-5) {
      out.notes.push_back(fmt::format(
          "warning: {}: G by the finite shift is {:+.2g} of the analytic one off; the shift is too "
          "large or lost in round-off",
          result.name, *K.shift_error));
    }
    result.two_materials = K.two_materials;
    const TipFaces faces = tip_faces(scene, tip, state);
    if (K.two_materials) {
      result.doubt =
          "the tip lies between two materials, where stresses oscillate: it has no K1 and "
          "K2, only G";
      out.notes.push_back(fmt::format("warning: {}: {}", result.name, result.doubt));
    } else if (crack.faces_in_contact) {
      close_tip(faces, k_scale(scene, tip, state, faces, K), result, out);
    } else if (!is_round_off(K, tip, state.u)) {
      tell_overlap(scene, tip, state, result, out);
    }
    if (crack.faces_in_contact && !scene.lip_pairs[tip.crack.index()]) {
      tell_lone_overlap(scene, tip, state, result, out);
    }
    out.tips.push_back(std::move(result));
  }
}

// Stick, slip and shear of a pair with friction; slips are told of the slave, which is one side or
// the other of the rows, along its own surface: both turn the sign.
void gather_friction(const Scene& scene, const StepState& state, std::size_t c,
                     const contact::PairPressure& p, results::ContactResult& result) {
  const contact::PairRows& pair = scene.pairs[c];
  const PairFriction& friction = state.friction[c];
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  const bool round = pair.contact.circle.has_value();
  std::vector<contact::ArcNode> arc;
  result.rubs = true;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    results::ContactPoint& point = result.points[i];
    contact::ArcNode node{round ? point.theta : point.arc, false, 0.0};
    if (p.nodes[i].row >= 0 && point.closed) {
      const auto row = static_cast<Eigen::Index>(p.nodes[i].row);
      const double area = pair.normal[static_cast<std::size_t>(row)].area;
      const double limit = friction.mu * state.pair_lambda[c][row];
      const double shear = std::abs(state.pair_lambda[c][normals + row]);
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
  for (const contact::SharpEnd& end : contact::sharp_ends(pair)) {
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
  for (std::size_t i = 0; i < scene.lip_pairs.size(); ++i) {
    if (scene.lip_pairs[i] && scene.lip_pairs[i]->pair == pair &&
        scene.cracked.lips[i].left.empty() && !result.points.empty()) {
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

void gather_contacts(const Scene& scene, const StepState& state, results::StepResult& out) {
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairRows& pair = scene.pairs[c];
    const contact::PairPressure p = contact::recover_pressure(
        pair, state.pair_lambda[c], state.pair_gap[c], state.pair_closed[c]);
    results::ContactResult result;
    result.name = scene.contacts[c].name;
    result.mounted = state.mounted[c];
    result.force_on_slave = p.force_on_slave;
    result.mean_pressure = p.mean_pressure;
    result.max_penetration = p.max_penetration;
    result.round = pair.contact.circle.has_value();
    result.arc_from = p.arc_from;
    result.arc_to = p.arc_to;
    result.closed = p.closed;
    result.rows = static_cast<int>(pair.normal.size());
    result.min_pressure = p.min_pressure;
    result.max_pressure = p.max_pressure;
    for (const contact::NodePressure& n : p.nodes) {
      results::ContactPoint point;
      point.node = n.node;
      point.x.head<2>() = n.x;
      point.theta = n.theta;
      point.arc = n.arc;
      point.p_lumped = n.p_lumped;
      point.p_consistent = n.p_consistent;
      point.q_lumped = n.q_lumped;
      point.q_consistent = n.q_consistent;
      point.state = n.closed ? results::ContactState::closed : results::ContactState::open;
      point.gap = n.gap;
      point.closed = n.closed;
      point.lip = n.lip;
      result.points.push_back(point);
    }
    result.sheared = !pair.tangent.empty();
    if (!state.friction.empty() && !state.friction[c].touch.empty() && result.mounted) {
      gather_friction(scene, state, c, p, result);
      out.friction_work += result.friction_work;
    }
    count_from_mouth(scene, c, result);
    result.unbounded = pressed_edges(pair, p.nodes);
    if (!result.unbounded.empty()) {
      out.notes.push_back(unbounded_note(result));
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
  return out;
}

} // namespace spricka::run
