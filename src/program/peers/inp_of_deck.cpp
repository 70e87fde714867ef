// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/inp_of_deck.hpp"

#include "base/vec.hpp"
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "mesh/export/write_inp.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// Whether the model holds all that a card says though it has no analysis yet: elements in space,
/// axial symmetry.
bool is_in_model(const model::UnimplementedAnalysis& u) {
  static constexpr std::array<std::string_view, 5> held{
      "elements in 3D", "$ELEMENT TYPE", "$MESH TYPE", "$PROPERTY STATE", "axial symmetry"};
  return std::any_of(held.begin(), held.end(),
                     [&](std::string_view begin) { return u.what.starts_with(begin); });
}

class ToInp {
public:
  ToInp(const model::Model& model, base::Diagnostics& refusals)
      : model_(model), refusals_(refusals) {}

  std::string text() {
    for (const model::Contact& contact : model_.contacts) {
      refuse(contact.span, "$CONTACT");
    }
    for (const model::CrackDefinition& crack : model_.cracks) {
      refuse(crack.span, "$CRACK");
    }
    for (const model::UnimplementedAnalysis& u : model_.unavailable) {
      if (!is_in_model(u)) {
        refuse(u.span, u.what);
      }
    }
    for (const std::string& type : mesh::types_without_inp_name(model_.mesh)) {
      refuse({}, fmt::format("the element {}", type));
    }
    if (model_.steps.empty() || refusals_.has_errors()) {
      return refusals_.has_errors() ? "" : mesh::write_inp(model_, nullptr);
    }
    const mesh::InpStep step = first_step();
    return refusals_.has_errors() ? "" : mesh::write_inp(model_, &step);
  }

private:
  void refuse(base::SourceSpan span, std::string_view what) {
    refusals_.error(span, "E540", fmt::format("{} cannot be written as Abaqus input", what));
  }

  mesh::InpStep first_step() {
    const model::Mesh& mesh = model_.mesh;
    const model::Step& from = model_.steps.front();
    const auto dim = static_cast<std::size_t>(mesh.dim);
    const auto size = static_cast<Eigen::Index>(dim * mesh.node_count());
    base::Vector f = base::Vector::Zero(size);
    base::Vector u = base::Vector::Zero(size);
    base::Vector T; // [connectivity index]
    for (const model::StepAction& action : from.actions) {
      const auto* load = std::get_if<model::ApplyLoad>(&action);
      if (load == nullptr) {
        refuse(from.span, "a $STEP that mounts, dismounts or fits");
        continue;
      }
      const model::LoadCase& with_heat = model_.cases[load->load_case.index()];
      model::LoadCase load_case =
          with_heat; // consistent_load_vector holds the forces of heat as well
      std::erase_if(load_case.loads,
                    [](const model::Load& l) { return l.type == model::LoadType::temperature; });
      f += load->factor * fe::consistent_load_vector(model_, mesh, load_case);
      u += load->factor * fe::prescribed_displacement_vector(model_, mesh, load_case);
      heat(with_heat, load->factor, T);
    }
    mesh::InpStep step;
    step.name = from.name;
    step.temperature = at_nodes(T);
    step.force.assign(mesh.node_count(), base::Vec3::Zero());
    const std::vector<model::FreedomRole> cls = fe::classify_freedoms(model_, mesh);
    for (std::size_t i = 0; i < cls.size(); ++i) {
      const base::NodeId node(i / dim);
      const auto c = static_cast<int>(i % dim);
      step.force[node.index()][c] = f[static_cast<Eigen::Index>(i)];
      if (cls[i] == model::FreedomRole::suppressed) {
        step.fixed.push_back({node, c, 0.0});
      } else if (cls[i] == model::FreedomRole::prescribed) {
        step.fixed.push_back({node, c, u[static_cast<Eigen::Index>(i)]});
      }
    }
    return step;
  }

  // Adds the temperatures of a case, by connectivity index as elements at a node may differ.
  void heat(const model::LoadCase& load_case, double factor, base::Vector& T) const {
    const model::Mesh& mesh = model_.mesh;
    for (const model::Load& load : load_case.loads) {
      if (load.type != model::LoadType::temperature) {
        continue;
      }
      if (T.size() == 0) {
        T = base::Vector::Zero(static_cast<Eigen::Index>(mesh.nodes.size()));
      }
      for (const base::ElementId e : mesh.set_with_id(load.elements).elements) {
        Eigen::Index k = mesh.first[e.index()];
        for (const base::NodeId n : mesh.element_nodes(e)) {
          T[k++] += factor * load.value.front()(mesh.x[n.index()]);
        }
      }
    }
  }

  /// Temperatures belong to nodes there: elements that expand must agree on them. [node]
  std::vector<double> at_nodes(const base::Vector& T) {
    const model::Mesh& mesh = model_.mesh;
    std::vector<double> node(T.size() > 0 ? mesh.node_count() : 0, 0.0);
    std::vector<bool> known(node.size(), false);
    const double tolerance = T.size() > 0 ? 1e-9 * T.lpNorm<Eigen::Infinity>() : 0.0;
    for (std::size_t e = 0; e < mesh.element_count() && !node.empty(); ++e) {
      Eigen::Index k = mesh.first[e];
      const bool expands = model_.element_material(mesh, base::ElementId(e)).alpha != 0.0;
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        const double here = T[k++];
        if (!expands) {
          continue;
        }
        if (known[n.index()] && std::abs(node[n.index()] - here) > tolerance) {
          refuse(model_.steps.front().span, "a temperature that jumps between elements");
          return {};
        }
        node[n.index()] = here;
        known[n.index()] = true;
      }
    }
    return node;
  }

  const model::Model& model_;
  base::Diagnostics& refusals_;
};

} // namespace

std::string abaqus_input_text(const model::Model& model, base::Diagnostics& refusals) {
  return ToInp(model, refusals).text();
}

} // namespace spricka::program
