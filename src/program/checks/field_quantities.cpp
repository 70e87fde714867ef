// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/gone_nodes.hpp"
#include "fe/locate.hpp"
#include "fe/stress.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "model/property_points.hpp"
#include "program/checks/check_line.hpp"
#include "results/stress_component.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::program {

CheckedStep find_checked_increment_and_step(const results::RunResult& run, const std::string& step,
                                            std::optional<double> a) {
  // From the end: without a length the last increment is meant.
  for (auto it = run.increments.rbegin(); it != run.increments.rend(); ++it) {
    const results::LoadStepResult* found = results::find_step(*it, step);
    if (found != nullptr && (!a || std::abs(it->a - *a) <= 1e-6 * std::abs(*a))) {
      return {&*it, found};
    }
  }
  std::string lengths;
  for (const results::CrackLengthResult& increment : run.increments) {
    lengths += fmt::format("{}{:.9g}", lengths.empty() ? "" : ", ", increment.a);
  }
  throw MissingQuantity(
      a ? fmt::format("no increment of length {:.9g} with step {}, only {}", *a, step, lengths)
        : fmt::format("no results of step {}", step));
}

std::vector<base::NodeId> nodes_of_named_set(const model::Mesh& mesh, const std::string& name) {
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
        const std::span<const base::NodeId> own = mesh.element_nodes(e);
        nodes.insert(nodes.end(), own.begin(), own.end());
      }
      return nodes;
    }
  }
  throw MissingQuantity(fmt::format("no set {}", name));
}

Eigen::Index axis_index(const std::string& component) {
  if (component == "X" || component == "Y" || component == "Z") {
    return component[0] - 'X';
  }
  throw MissingQuantity(fmt::format("no displacement component {}", component));
}

namespace {

/// "S.XX.MIN" -> what, component, how.
struct FieldName {
  std::string what, component, how;
};
FieldName split(const std::string& quantity) {
  const std::size_t first = quantity.find('.');
  const std::size_t last = quantity.rfind('.');
  if (first == std::string::npos || first == last) {
    throw MissingQuantity(fmt::format("{} is not a quantity", quantity));
  }
  return {quantity.substr(0, first), quantity.substr(first + 1, last - first - 1),
          quantity.substr(last + 1)};
}

double stress_component(const fe::Stress& stress, const std::string& component) {
  results::Stress s{};
  std::copy_n(stress.data(), 6, s.begin());
  const std::optional<double> found = results::stress_component(s, component);
  if (!found) {
    throw MissingQuantity(fmt::format("no stress component {}", component));
  }
  return *found;
}

// Stresses of a set's elements at their own nodes; of a node set, the mean of the elements that
// meet there, a value for each property.
std::vector<double> stresses_of_set(const model::Model& model, const CheckedStep& at,
                                    const std::string& name, const std::string& component) {
  const model::Mesh& mesh = at.increment->mesh;
  const std::vector<fe::Stress> stress =
      fe::element_node_stress(model, mesh, {at.step->u, at.step->temperature});
  std::vector<double> values;
  for (const model::ElementSet& set : mesh.element_sets) {
    if (set.name == name) {
      for (const base::ElementId e : set.elements) {
        const auto first = static_cast<std::size_t>(mesh.first[e.index()]);
        for (std::size_t k = 0; k < mesh.element_nodes(e).size(); ++k) {
          values.push_back(stress_component(stress[first + k], component));
        }
      }
      return values;
    }
  }
  std::vector<fe::Stress> nodal = fe::nodal_stress(model, mesh, stress);
  // Nodes whose elements a patch has replaced have the stress at their place.
  analysis::fill_removed_node_stresses(model, mesh, {at.step->u, at.step->temperature}, nodal);
  std::vector<bool> wanted(mesh.node_count(), false);
  for (const base::NodeId n : nodes_of_named_set(mesh, name)) {
    wanted[n.index()] = true;
  }
  const model::FieldPointsByProperty points = model::property_points(mesh);
  for (std::size_t p = 0; p < points.node.size(); ++p) {
    if (wanted[points.node[p].index()]) {
      values.push_back(stress_component(nodal[p], component));
    }
  }
  return values;
}

// Where faces of a crack, or two bodies, meet in a point and move apart there is no one
// displacement.
double displacement_at(const model::Mesh& mesh, const base::Vector& u, const base::Vec3& x,
                       Eigen::Index axis) {
  constexpr double alike = 1e-4; // of the largest displacement
  const std::vector<fe::PointElementGroup> sides =
      fe::group_elements_at_point(mesh, fe::elements_at_point(mesh, x));
  if (sides.empty()) {
    throw MissingQuantity("the point lies outside the body");
  }
  const double first = fe::displacement_at(mesh, u, sides.front())[axis];
  double sum = 0.0;
  for (const fe::PointElementGroup& side : sides) {
    const double value = fe::displacement_at(mesh, u, side)[axis];
    if (std::abs(value - first) > alike * u.lpNorm<Eigen::Infinity>()) {
      throw MissingQuantity(
          fmt::format("faces meet at that point that move apart, by {:.6g} and {:.6g}: "
                      "ask a little beside it",
                      first, value));
    }
    sum += value;
  }
  return sum / static_cast<double>(sides.size());
}

} // namespace

double evaluate_field_quantity(CheckLine& line) {
  auto& [model, run, quantity, args] = line;
  const FieldName field = split(quantity);
  if (field.how == "AT") {
    const base::Vec3 x = args.required_point(model.mesh.dim);
    const CheckedStep at = read_step_argument(line);
    if (field.what == "U") {
      return displacement_at(at.increment->mesh, at.step->u, x, axis_index(field.component));
    }
    const std::optional<fe::Stress> s =
        fe::stress_at_body_point(model, at.increment->mesh, {at.step->u, at.step->temperature}, x);
    if (!s) {
      throw MissingQuantity("the point lies outside the body");
    }
    return stress_component(*s, field.component);
  }
  const std::string set = args.required_name("a set");
  const CheckedStep at = read_step_argument(line);
  std::vector<double> values;
  if (field.what == "S") {
    values = stresses_of_set(model, at, set, field.component);
  } else {
    for (const base::NodeId n : nodes_of_named_set(at.increment->mesh, set)) {
      values.push_back(at.step->u[static_cast<Eigen::Index>(n.index()) * at.increment->mesh.dim +
                                  axis_index(field.component)]);
    }
  }
  if (values.empty()) {
    throw MissingQuantity(fmt::format("set {} is empty", set));
  }
  return field.how == "MIN" ? *std::min_element(values.begin(), values.end())
                            : *std::max_element(values.begin(), values.end());
}

} // namespace spricka::program
