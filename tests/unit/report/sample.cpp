// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spricka::test {
namespace {

using base::ElementType;
using base::NodeId;

constexpr double pi = std::numbers::pi;
constexpr int sectors = 48;  ///< elements round a ring
constexpr int at_crack = 12; ///< the sector that starts at 90 degrees
constexpr double youngs = 70000.0;
constexpr std::array<double, 2> lengths{6.0, 18.0};

/// Radii of element boundaries from the bore on: the crack ends on one of them.
const std::vector<double> ring_radii{bore, 39, 42, 48, 54, 60, 66, 73, rim};

/// Nodes of one ring by half sectors and half layers; behind the tip the crack's radius has two.
class RingBuilder {
public:
  RingBuilder(model::Mesh& mesh, base::NetId net, const std::vector<double>& radii, double tip)
      : mesh_(mesh), net_(net), radii_(radii), tip_(tip) {}

  void build() {
    const int layers = static_cast<int>(radii_.size()) - 1;
    for (int r = 0; r < layers; ++r) {
      for (int s = 0; s < sectors; ++s) {
        if (r == layers - 1 && s % 2 == 0) {
          add_triangles(r, s);
        } else {
          add_quad(r, s, (r + s) % 3 == 0);
        }
      }
    }
  }

private:
  double radius(int half) const {
    const auto r = static_cast<std::size_t>(half / 2);
    return half % 2 == 0 ? radii_[r] : 0.5 * (radii_[r] + radii_[r + 1]);
  }
  /// Node at half layer i and half sector j; `sector` tells the crack faces apart.
  NodeId node(int i, int j, int sector) {
    const double r = radius(i);
    const int turn = (j + 2 * sectors) % (2 * sectors);
    const bool crack_face = turn == 2 * at_crack && r < tip_ - 1e-9 && sector < at_crack;
    const auto [place, fresh] = nodes_.try_emplace({i, turn, crack_face});
    if (fresh) {
      const double t = pi * turn / sectors;
      place->second = model::add_node(mesh_, {r * std::cos(t), r * std::sin(t), 0.0},
                                      static_cast<base::Label>(nodes_.size()), net_);
    }
    return place->second;
  }
  void add(ElementType type, const std::vector<NodeId>& nodes) {
    model::add_element(mesh_, type, nodes, ++label_, net_);
  }
  void add_quad(int r, int s, bool nine) {
    const int i = 2 * r;
    const int j = 2 * s;
    std::vector<NodeId> n{node(i, j, s),         node(i + 2, j, s), node(i + 2, j + 2, s),
                          node(i, j + 2, s),     node(i + 1, j, s), node(i + 2, j + 1, s),
                          node(i + 1, j + 2, s), node(i, j + 1, s)};
    if (nine) {
      n.push_back(node(i + 1, j + 1, s));
    }
    add(nine ? ElementType::quamc9 : ElementType::quamc8, n);
  }
  void add_triangles(int r, int s) {
    const int i = 2 * r;
    const int j = 2 * s;
    add(ElementType::trimc6, {node(i, j, s), node(i + 2, j, s), node(i + 2, j + 2, s),
                              node(i + 1, j, s), node(i + 2, j + 1, s), node(i + 1, j + 1, s)});
    add(ElementType::trimc6, {node(i, j, s), node(i + 2, j + 2, s), node(i, j + 2, s),
                              node(i + 1, j + 1, s), node(i + 1, j + 2, s), node(i, j + 1, s)});
  }

  model::Mesh& mesh_;
  base::NetId net_;
  const std::vector<double>& radii_;
  double tip_;
  std::map<std::tuple<int, int, bool>, NodeId> nodes_;
  base::Label label_ = 0;
};

model::Mesh make_mesh(double a) {
  model::Mesh mesh;
  RingBuilder(mesh, base::NetId(0), ring_radii, bore + a).build();
  const std::vector<double> sleeve{30.0, 33.0, bore};
  RingBuilder(mesh, base::NetId(1), sleeve, 0.0).build();
  model::add_node(mesh, {1e3, 1e3, 0.0}, 999, base::NetId(0)); // as a cut leaves them: unused
  mesh.property.assign(mesh.element_count(), base::PropertyId(0));
  for (std::size_t net = 0; net < 2; ++net) {
    model::ElementSet body{net == 0 ? "RING.BODY" : "SLEEVE.BODY", {}, {}};
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.element_net[e] == base::NetId(net)) {
        body.elements.emplace_back(e);
        mesh.property[e] = base::PropertyId(net);
      }
    }
    mesh.element_sets.push_back(body);
    mesh.face_sets.push_back({net == 0 ? "RING.INNER" : "SLEEVE.OUTER", {}, {}});
  }
  return mesh;
}

model::Model make_model() {
  model::Model model;
  model.title = "Sleeve in a cracked ring <sample>";
  model.parameters = {{"r", bore}, {"Sigma", sigma}};
  model.mesh = make_mesh(0.0);
  model.nets = {{"RING", {}}, {"SLEEVE", {}}};
  model.materials = {{"ALU", youngs, 0.33, 0.0, 0.0, {}}, {"STEEL", 206000.0, 0.3, 0.0, 0.0, {}}};
  for (std::size_t p = 0; p < 2; ++p) {
    model.properties.push_back(
        {base::ElementSetId(p), base::MaterialId(p), model::StressState::plane_stress, 14.0, {}});
  }
  model::Contact contact;
  contact.name = "BUSH";
  contact.slave = base::FaceSetId(1);
  contact.master = base::FaceSetId(0);
  contact.gap = -0.042;
  model.contacts = {contact};
  model::CrackDefinition crack;
  crack.name = "C1";
  crack.a0 = lengths[0];
  model.cracks = {crack};
  model.steps = {{"PRESS", 1, {}, {}}, {"LOAD", 4, {}, {}}, {"UNLOAD", 4, {}, {}}};
  model::CrackGrowthSettings growth;
  growth.kmax = base::StepId(1);
  growth.kmin = base::StepId(2);
  growth.lengths.assign(lengths.begin(), lengths.end());
  model.growth = growth;
  for (const double a : lengths) {
    model.checks.push_back({"K",
                            {std::string("C1"), std::string("LOAD"), a},
                            base::QuantityKind::stress_intensity,
                            1.02 * k1(a),
                            0.05,
                            true,
                            false,
                            false,
                            "Handbook, Table 1",
                            {}});
  }
  return model;
}

results::ContactResult make_contact(const model::Mesh& mesh, double factor, double a) {
  results::ContactResult contact;
  contact.name = "BUSH";
  contact.force_on_slave = {0.0, -97100.0 * factor, 0.0};
  contact.round = true;
  contact.arc_from = -2.0 * pi / 3.0;
  contact.arc_to = 2.0 * pi / 3.0;
  contact.rows = 2 * sectors;
  contact.max_penetration = 1e-17;
  // Against the clock from the left crack face once round to the right one.
  const int start = 2 * at_crack;
  for (int j = start; j <= start + 2 * sectors; ++j) {
    const double turn = pi * j / sectors;
    results::ContactPoint point;
    point.theta = std::remainder(turn, 2.0 * pi);
    point.x = {bore * std::cos(turn), bore * std::sin(turn), 0.0};
    point.arc = bore * (turn - 0.5 * pi);
    point.p_lumped = factor * pressure(point.theta) * (1.0 + a / bore);
    point.p_consistent = point.p_lumped * (j % 2 == 0 ? 0.9 : 1.1);
    point.closed = point.p_lumped > 0.0;
    point.crack_face = j == start ? 1 : (j == start + 2 * sectors ? -1 : 0);
    contact.points.push_back(point);
    contact.max_pressure = std::max(contact.max_pressure, point.p_lumped);
    contact.closed += point.closed ? 1 : 0;
  }
  contact.points.front().node = NodeId(0);
  contact.mean_pressure = 0.5 * contact.max_pressure;
  contact.rows = static_cast<int>(mesh.dim) * sectors;
  return contact;
}

results::LoadStepResult make_step(const model::Mesh& mesh, const std::string& name, double factor,
                                  double a) {
  results::LoadStepResult step;
  step.step = name;
  step.u.resize(static_cast<Eigen::Index>(2 * mesh.node_count()));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    step.u.segment<2>(static_cast<Eigen::Index>(2 * n)) = factor * displacement(mesh.x[n]);
    step.stress.push_back(stress(mesh.x[n]));
    for (double& s : step.stress.back()) {
      s *= factor;
    }
  }
  results::FrontResult front;
  front.name = "C1";
  front.a = a;
  results::FrontPointResult& tip = front.points.emplace_back();
  tip.K1 = factor * k1(a);
  tip.K2 = -0.05 * tip.K1;
  tip.smooth = {tip.K1, tip.K2, 0.0};
  tip.G = (tip.K1 * tip.K1 + tip.K2 * tip.K2) / youngs;
  tip.G_from_K = tip.G;
  tip.spread = 1e-4;
  tip.T = -0.3 * tip.K1;
  tip.x = {0.0, bore + a, 0.0};
  tip.direction = base::Vec3::UnitY();
  if (factor > 0.0) { // no load, no bar
    front.missing_bar_reason.clear();
    for (std::size_t k = 0; k < 2; ++k) {
      const double K = k == 0 ? tip.K1 : tip.K2;
      const double eta = 1e-3 * K;
      tip.bar[k] = {eta,
                    2.0 * std::abs(eta),
                    1e-4 * tip.K1,
                    2.0 * std::abs(eta),
                    2e-5 * tip.K1,
                    1e-4 * tip.K1,
                    K + eta,
                    false,
                    false,
                    std::vector<double>(mesh.element_count(),
                                        eta / static_cast<double>(mesh.element_count()))};
    }
  }
  step.fronts = {front};
  step.contacts = {make_contact(mesh, factor, a)};
  step.contacts.front().mounted = factor > 0.0;
  step.balance = {{"SLEEVE", {97100.0 * factor, 0, 0}, {0, 0, 0}, {-97100.0 * factor, 1e-9, 0}}};
  step.iterations = 5;
  return step;
}

} // namespace

base::Vec2 displacement(const base::Vec3& x) {
  return {1e-3 * x[0] + 2e-5 * x[0] * x[1], -5e-4 * x[1] + 1e-5 * x[0] * x[0]};
}

std::array<double, 6> stress(const base::Vec3& x) {
  return {x[0], x[1], 0.0, 0.1 * x[0] * x[1], 0.0, 0.0};
}

double k1(double a) {
  return sigma * std::sqrt(pi * a) * (1.0 + 1.0 / (1.0 + a / bore));
}

double pressure(double theta) {
  return 60.0 * std::max(0.0, std::cos(0.75 * theta));
}

Sample make_sample() {
  Sample sample;
  sample.sources.add_text("sample.deck", "! a sample\r\n$DECK VERSION=1\n\n$END");
  sample.model = make_model();
  results::RunResult& run = sample.run;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    results::CrackLengthResult increment;
    increment.number = static_cast<int>(i) + 1;
    increment.a = lengths[i];
    increment.mesh = make_mesh(lengths[i]);
    increment.steps = {make_step(increment.mesh, "PRESS", 0.2, lengths[i]),
                       make_step(increment.mesh, "LOAD", 1.0, lengths[i]),
                       make_step(increment.mesh, "UNLOAD", 0.0, lengths[i])};
    run.increments.push_back(std::move(increment));
    const double wanted = sample.model.checks[i].value;
    const double found = k1(lengths[i]);
    run.checks.push_back({"K(C1,LOAD,a)", wanted, found, found / wanted - 1.0, 0.05, true, true,
                          "Handbook, Table 1", ""});
  }
  run.log = {{"TOPOLOGY", "2 nets", 0.01, 0.01}, {"CONTACT", "5 iterations", 0.5, 0.25}};
  run.cpu = 0.51;
  run.wall = 0.26;
  run.peak_memory = 123'000'000;
  return sample;
}

} // namespace spricka::test
