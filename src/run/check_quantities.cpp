// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/check_quantities.hpp"

#include "fe/stress.hpp"
#include "mesh/boundary.hpp"
#include "model/property_points.hpp"
#include "results/stress_invariants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

namespace spricka::run {

namespace {

// Why a quantity has no value; caught where the line is evaluated.
struct Missing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arguments of one check, taken from the left.
class Arguments {
public:
  explicit Arguments(const model::Check& check) : check_(check) {}

  std::string name(const char* what) {
    if (next_ >= check_.arguments.size() ||
        !std::holds_alternative<std::string>(check_.arguments[next_])) {
      throw Missing(fmt::format("{} expects {} as argument {}", check_.quantity, what, next_ + 1));
    }
    return std::get<std::string>(check_.arguments[next_++]);
  }
  std::optional<double> number() {
    if (next_ < check_.arguments.size() &&
        std::holds_alternative<double>(check_.arguments[next_])) {
      return std::get<double>(check_.arguments[next_++]);
    }
    return std::nullopt;
  }
  double needed(const char* what) {
    const std::optional<double> value = number();
    if (!value) {
      throw Missing(fmt::format("{} expects {} as argument {}", check_.quantity, what, next_ + 1));
    }
    return *value;
  }

private:
  const model::Check& check_;
  std::size_t next_ = 0;
};

struct Place {
  const results::Increment* increment = nullptr;
  const results::StepResult* step = nullptr;
};

// The increment whose length is `a` (to 1e-6), or the last one when no length is given.
Place find_place(const results::Run& run, const std::string& step, std::optional<double> a) {
  for (auto it = run.increments.rbegin(); it != run.increments.rend(); ++it) {
    const results::StepResult* found = results::find_step(*it, step);
    if (found != nullptr && (!a || std::abs(it->a - *a) <= 1e-6 * std::abs(*a))) {
      return {&*it, found};
    }
  }
  std::string lengths;
  for (const results::Increment& increment : run.increments) {
    lengths += fmt::format("{}{:.9g}", lengths.empty() ? "" : ", ", increment.a);
  }
  throw Missing(
      a ? fmt::format("no increment of length {:.9g} with step {}, only {}", *a, step, lengths)
        : fmt::format("no results of step {}", step));
}

double tip_quantity(const std::string& quantity, Arguments& args, const results::Run& run) {
  const std::string tip = args.name("a crack");
  const std::string step = args.name("a step");
  const Place at = find_place(run, step, args.number());
  const results::TipResult* found = results::find_tip(*at.step, tip);
  if (found == nullptr) {
    throw Missing(fmt::format("no tip {}", tip));
  }
  if (!found->doubt.empty()) {
    throw Missing(found->doubt);
  }
  if (quantity == "K2") {
    return found->K2;
  }
  return quantity == "G" ? found->G : found->K1;
}

const results::ContactResult& contact_of(const results::StepResult& step,
                                         const std::string& contact) {
  const results::ContactResult* found = results::find_contact(step, contact);
  if (found == nullptr) {
    throw Missing(fmt::format("no contact {}", contact));
  }
  return *found;
}

double recovered(const results::ContactPoint& p, bool consistent) {
  return consistent ? p.p_consistent : p.p_lumped;
}

double extreme_pressure(const results::ContactResult& contact, bool consistent, bool largest) {
  if (contact.points.empty()) {
    throw Missing("the contact has no surface");
  }
  double found = recovered(contact.points.front(), consistent);
  for (const results::ContactPoint& p : contact.points) {
    const double value = recovered(p, consistent);
    found = largest ? std::max(found, value) : std::min(found, value);
  }
  return found;
}

// Between the two points next to theta; lips are met from their own side.
double pressure_at(const results::ContactResult& contact, bool consistent, double theta) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const results::ContactPoint* below = nullptr;
  const results::ContactPoint* above = nullptr;
  double down = std::numeric_limits<double>::infinity();
  double up = down;
  for (const results::ContactPoint& p : contact.points) {
    const double d = std::remainder(p.theta - theta, turn);
    if (d <= 0.0 && -d < down) {
      down = -d;
      below = &p;
    }
    if (d >= 0.0 && d < up) {
      up = d;
      above = &p;
    }
  }
  if (below == nullptr || above == nullptr || up + down > 1.0) {
    throw Missing("no contact surface at that angle");
  }
  const double t = up + down > 0.0 ? down / (up + down) : 0.0;
  return (1.0 - t) * recovered(*below, consistent) + t * recovered(*above, consistent);
}

double contact_quantity(const model::Model& model, const std::string& quantity, Arguments& args,
                        const results::Run& run) {
  const std::string name = args.name("a contact");
  const std::string step = args.name("a step");
  std::optional<double> theta;
  int component = 0;
  if (quantity == "CPRESS.AT") {
    theta = args.needed("an angle");
  } else if (quantity == "SUM") {
    const std::string axis = args.name("X, Y or Z");
    component = axis == "Z" ? 2 : (axis == "Y" ? 1 : 0);
  }
  const Place at = find_place(run, step, args.number());
  const results::ContactResult& contact = contact_of(*at.step, name);
  const auto card = std::find_if(model.contacts.begin(), model.contacts.end(),
                                 [&](const model::Contact& c) { return c.name == name; });
  const bool consistent =
      card != model.contacts.end() && card->recovery == model::Recovery::consistent;
  if (theta) {
    return pressure_at(contact, consistent, *theta);
  }
  if (quantity == "SUM") {
    return contact.force_on_slave[component];
  }
  if (quantity == "CPRESS.MIN" || quantity == "CPRESS.MAX") {
    return extreme_pressure(contact, consistent, quantity == "CPRESS.MAX");
  }
  if (quantity == "ARC.FROM") {
    return contact.arc_from;
  }
  return quantity == "ARC.TO" ? contact.arc_to : contact.mean_pressure;
}

std::vector<base::NodeId> nodes_of_set(const model::Mesh& mesh, const std::string& name) {
  for (const model::NodeSet& set : mesh.node_sets) {
    if (set.name == name) {
      return set.nodes;
    }
  }
  for (const model::FaceSet& set : mesh.face_sets) {
    if (set.name == name) {
      return mesh::nodes_of_faces(mesh, set.faces);
    }
  }
  for (const model::ElementSet& set : mesh.element_sets) {
    if (set.name == name) {
      std::vector<base::NodeId> nodes;
      for (const base::ElementId e : set.elements) {
        const std::span<const base::NodeId> own = mesh.nodes_of(e);
        nodes.insert(nodes.end(), own.begin(), own.end());
      }
      return nodes;
    }
  }
  throw Missing(fmt::format("no set {}", name));
}

/// "S.XX.MIN" -> what, component, how.
struct FieldName {
  std::string what, component, how;
};
FieldName split(const std::string& quantity) {
  const std::size_t first = quantity.find('.');
  const std::size_t last = quantity.rfind('.');
  if (first == std::string::npos || first == last) {
    throw Missing(fmt::format("{} is not a quantity", quantity));
  }
  return {quantity.substr(0, first), quantity.substr(first + 1, last - first - 1),
          quantity.substr(last + 1)};
}

double stress_component(const fe::Stress& stress, const std::string& component) {
  static constexpr std::array<const char*, 6> names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  results::Stress s{};
  std::copy_n(stress.data(), 6, s.begin());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (component == names[i]) {
      return s[i];
    }
  }
  if (component == "MISES") {
    return results::von_mises(s);
  }
  if (component == "P1" || component == "P2" || component == "P3") {
    return results::principal(s)[static_cast<std::size_t>(component[1] - '1')];
  }
  throw Missing(fmt::format("no stress component {}", component));
}

Eigen::Index axis_of(const std::string& component) {
  if (component == "X" || component == "Y" || component == "Z") {
    return component[0] - 'X';
  }
  throw Missing(fmt::format("no displacement component {}", component));
}

// Stresses of a set's elements at their own nodes; of a node set, the mean of the elements that
// meet there, a value for each property.
std::vector<double> stresses_of_set(const model::Model& model, const Place& at,
                                    const std::string& name, const std::string& component) {
  const model::Mesh& mesh = at.increment->mesh;
  const std::vector<fe::Stress> stress =
      fe::element_node_stress(model, mesh, {at.step->u, at.step->temperature});
  std::vector<double> values;
  for (const model::ElementSet& set : mesh.element_sets) {
    if (set.name == name) {
      for (const base::ElementId e : set.elements) {
        const auto first = static_cast<std::size_t>(mesh.first[e.index()]);
        for (std::size_t k = 0; k < mesh.nodes_of(e).size(); ++k) {
          values.push_back(stress_component(stress[first + k], component));
        }
      }
      return values;
    }
  }
  const std::vector<fe::Stress> nodal = fe::nodal_stress(model, mesh, stress);
  std::vector<bool> wanted(mesh.node_count(), false);
  for (const base::NodeId n : nodes_of_set(mesh, name)) {
    wanted[n.index()] = true;
  }
  const model::PropertyPoints points = model::property_points(mesh);
  for (std::size_t p = 0; p < points.node.size(); ++p) {
    if (wanted[points.node[p].index()]) {
      values.push_back(stress_component(nodal[p], component));
    }
  }
  return values;
}

double displacement_at(const model::Mesh& mesh, const base::Vector& u, const base::Vec3& x,
                       Eigen::Index axis) {
  std::size_t nearest = 0;
  for (std::size_t n = 1; n < mesh.node_count(); ++n) {
    nearest = (mesh.x[n] - x).norm() < (mesh.x[nearest] - x).norm() ? n : nearest;
  }
  base::Vec3 low = mesh.x[0];
  base::Vec3 high = mesh.x[0];
  for (const base::Vec3& p : mesh.x) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if ((mesh.x[nearest] - x).norm() > 1e-6 * (high - low).norm()) {
    throw Missing("U is given at nodes only: no node at that point");
  }
  return u[static_cast<Eigen::Index>(nearest) * mesh.dim + axis];
}

double field_quantity(const model::Model& model, const std::string& quantity, Arguments& args,
                      const results::Run& run) {
  const FieldName field = split(quantity);
  if (field.how == "AT") {
    base::Vec3 x = base::Vec3::Zero();
    x[0] = args.needed("x");
    x[1] = args.needed("y");
    if (model.mesh.dim == 3) {
      x[2] = args.needed("z");
    }
    const std::string step = args.name("a step");
    const Place at = find_place(run, step, args.number());
    if (field.what == "U") {
      return displacement_at(at.increment->mesh, at.step->u, x, axis_of(field.component));
    }
    const std::optional<fe::Stress> s =
        fe::stress_at(model, at.increment->mesh, {at.step->u, at.step->temperature}, x);
    if (!s) {
      throw Missing("the point lies outside the body");
    }
    return stress_component(*s, field.component);
  }
  const std::string set = args.name("a set");
  const std::string step = args.name("a step");
  const Place at = find_place(run, step, args.number());
  std::vector<double> values;
  if (field.what == "S") {
    values = stresses_of_set(model, at, set, field.component);
  } else {
    for (const base::NodeId n : nodes_of_set(at.increment->mesh, set)) {
      values.push_back(at.step->u[static_cast<Eigen::Index>(n.index()) * at.increment->mesh.dim +
                                  axis_of(field.component)]);
    }
  }
  if (values.empty()) {
    throw Missing(fmt::format("set {} is empty", set));
  }
  return field.how == "MIN" ? *std::min_element(values.begin(), values.end())
                            : *std::max_element(values.begin(), values.end());
}

double reaction(Arguments& args, const results::Run& run) {
  const std::string set = args.name("a set");
  const std::string step = args.name("a step");
  const Eigen::Index axis = axis_of(args.name("X, Y or Z"));
  const Place at = find_place(run, step, args.number());
  std::vector<base::NodeId> nodes = nodes_of_set(at.increment->mesh, set);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  double sum = 0.0;
  for (const base::NodeId n : nodes) {
    sum += at.step->reaction[static_cast<Eigen::Index>(n.index()) * at.increment->mesh.dim + axis];
  }
  return sum;
}

double energy(Arguments& args, const results::Run& run) {
  const std::string net = args.name("a net or *");
  const std::string step = args.name("a step");
  const results::StepResult& at = *find_place(run, step, args.number()).step;
  if (net == "*") {
    return at.energy;
  }
  const auto found = std::ranges::find(at.nets, net, &results::Balance::body);
  if (found == at.nets.end()) {
    throw Missing(fmt::format("net {} has no elements", net));
  }
  return found->energy;
}

double evaluate(const model::Model& model, const model::Check& check, const results::Run& run) {
  Arguments args(check);
  const std::string& q = check.quantity;
  if (q == "K" || q == "K1" || q == "K2" || q == "G") {
    return tip_quantity(q, args, run);
  }
  if (q.starts_with("CPRESS.") || q.starts_with("ARC.") || q == "SUM") {
    return contact_quantity(model, q, args, run);
  }
  if (q == "ENERGY") {
    return energy(args, run);
  }
  if (q == "REACTION") {
    return reaction(args, run);
  }
  if (q.starts_with("U.") || q.starts_with("S.")) {
    return field_quantity(model, q, args, run);
  }
  throw Missing(fmt::format("{} is not available in this version", q));
}

std::string text_of(const model::Check& check) {
  std::string text = check.quantity + "(";
  for (std::size_t i = 0; i < check.arguments.size(); ++i) {
    text += i > 0 ? "," : "";
    text += std::holds_alternative<std::string>(check.arguments[i])
                ? std::get<std::string>(check.arguments[i])
                : fmt::format("{:.6g}", std::get<double>(check.arguments[i]));
  }
  return text + ")";
}

} // namespace

std::vector<results::CheckResult> evaluate_checks(const model::Model& model,
                                                  const results::Run& run) {
  std::vector<results::CheckResult> all;
  for (const model::Check& check : model.checks) {
    results::CheckResult result;
    result.text = text_of(check);
    result.wanted = check.value;
    result.tolerance = check.tolerance;
    result.relative = check.relative;
    result.source = check.source;
    try {
      result.found = evaluate(model, check, run);
      const double difference = result.found - result.wanted;
      result.error = check.relative ? difference / std::abs(check.value) : difference;
      result.passed = std::abs(result.error) <= check.tolerance;
    } catch (const Missing& missing) {
      result.trouble = missing.what();
    }
    all.push_back(std::move(result));
  }
  return all;
}

} // namespace spricka::run
