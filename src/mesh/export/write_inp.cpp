// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/export/write_inp.hpp"

#include "base/by_dimension.hpp"
#include "mesh/inp_elements.hpp"
#include "mesh/numbering.hpp"
#include "mesh/set_name.hpp"
#include "model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Label;

/// What a line holds at most.
constexpr std::size_t per_line = 16;

/// Of elements without a property.
constexpr base::ByDimension usual_state{model::StressState::plane_stress,
                                        model::StressState::solid};

/// A number as short as it can be read back, but no longer than the 20 characters that CalculiX
/// looks at (the rest, an exponent perhaps, it passes over in silence): what needs more loses its
/// last digits, a few parts in 1e16.
std::string number(double value) {
  static constexpr std::size_t most = 20;
  std::string text = fmt::format("{}", value);
  for (int digits = 17; text.size() > most; --digits) {
    text = fmt::format("{:.{}g}", value, digits);
  }
  return text;
}

class InpWriter {
public:
  explicit InpWriter(const model::Model& model) : model_(model), mesh_(model.mesh) {
    node_ = inp_node_numbers(mesh_);
    element_ = make_labels_unique(mesh_.element_label);
    used_ = model::mark_nodes_in_use(mesh_);
  }

  std::string text(const InpStep* step) {
    put("*HEADING\n{}\n", model_.title.empty() ? "spricka" : model_.title);
    nodes();
    elements();
    sets();
    properties();
    if (step != nullptr) {
      write_step(*step);
    }
    return std::move(text_);
  }

private:
  template <class... T> void put(fmt::format_string<T...> form, T&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<T>(values)...);
  }
  /// A name that no other set or material has.
  std::string unique(const std::string& name) {
    const std::string wanted = make_valid_set_name(name);
    std::string free = wanted;
    for (int n = 2; !names_.insert(free).second; ++n) {
      free = fmt::format("{}_{}", wanted, n);
    }
    return free;
  }
  /// Numbers with commas between them, at most 16 a line.
  template <class List, class NumberOf> void numbers(const List& list, const NumberOf& number_of) {
    std::size_t on_line = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      put("{}", number_of(list[i]));
      const bool last = i + 1 == list.size();
      on_line = on_line + 1 == per_line ? 0 : on_line + 1;
      text_ += last ? "\n" : (on_line == 0 ? ",\n" : ", ");
    }
  }
  [[nodiscard]] model::StressState state_of(std::size_t e) const {
    if (mesh_.property[e].valid()) {
      return model_.properties[mesh_.property[e].index()].state;
    }
    return usual_state.at(base::element_info(mesh_.type[e]).dim);
  }

  void nodes() {
    put("*NODE\n");
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (used_[n]) {
        put("{}, {}, {}, {}\n", node_[n], number(mesh_.x[n].x()), number(mesh_.x[n].y()),
            number(mesh_.x[n].z()));
      }
    }
  }

  void elements() {
    std::string before;
    std::vector<Label> row;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      std::string type = inp_element_name(mesh_.type[e], state_of(e));
      if (type != before) {
        put("*ELEMENT, TYPE={}\n", type);
        before = std::move(type);
      }
      row.assign(1, element_[e]);
      for (const base::NodeId n : mesh_.element_nodes(base::ElementId(e))) {
        row.push_back(node_[n.index()]);
      }
      numbers(row, [](Label label) { return label; });
    }
  }

  void sets() {
    for (const model::NodeSet& set : mesh_.node_sets) {
      std::vector<base::NodeId> nodes = set.nodes;
      std::erase_if(nodes, [&](base::NodeId n) { return !used_[n.index()]; });
      if (!set.name.empty() && !nodes.empty()) {
        put("*NSET, NSET={}\n", unique(set.name));
        numbers(nodes, [&](base::NodeId n) { return node_[n.index()]; });
      }
    }
    for (const model::ElementSet& set : mesh_.element_sets) {
      std::string name;
      if (!set.name.empty() && !set.elements.empty()) {
        name = unique(set.name);
        put("*ELSET, ELSET={}\n", name);
        numbers(set.elements, [&](base::ElementId e) { return element_[e.index()]; });
      }
      element_set_name_.push_back(std::move(name));
    }
    for (const model::FaceSet& set : mesh_.face_sets) {
      if (!set.name.empty() && !set.faces.empty()) {
        put("*SURFACE, NAME={}, TYPE=ELEMENT\n", unique(set.name));
        for (const model::Face& face : set.faces) {
          put("{}, S{}\n", element_[face.element.index()], face.side + 1);
        }
      }
    }
  }

  void properties() {
    std::vector<std::string> material;
    for (const model::ElasticMaterial& m : model_.materials) {
      material.push_back(unique(m.name));
      put("*MATERIAL, NAME={}\n*ELASTIC\n{}, {}\n", material.back(), number(m.E), number(m.nu));
      if (m.rho > 0.0) {
        put("*DENSITY\n{}\n", number(m.rho));
      }
      if (m.alpha != 0.0) {
        put("*EXPANSION\n{}\n", number(m.alpha));
      }
    }
    for (const model::ElementProperty& p : model_.properties) {
      const std::string& set = element_set_name_[static_cast<std::size_t>(p.elements.index())];
      put("*SOLID SECTION, ELSET={}, MATERIAL={}\n", set, material[p.material.index()]);
      if (p.state == model::StressState::plane_stress ||
          p.state == model::StressState::plane_strain) {
        put("{}\n", number(p.thickness));
      }
    }
  }

  template <class Value> void temperatures(const InpStep& step, const Value& value) {
    for (std::size_t n = 0; n < step.temperature.size(); ++n) {
      if (used_[n]) {
        put("{}, {}\n", node_[n], number(value(step.temperature[n])));
      }
    }
  }

  void write_step(const InpStep& step) {
    if (!step.temperature.empty()) { // strains count from it
      put("*INITIAL CONDITIONS, TYPE=TEMPERATURE\n");
      temperatures(step, [](double /*T*/) { return 0.0; });
    }
    put("*STEP\n*STATIC\n");
    if (!step.fixed.empty()) {
      put("*BOUNDARY\n");
    }
    for (const InpStep::PrescribedFreedom& f : step.fixed) {
      put("{}, {}, {}, {}\n", node_[f.node.index()], f.dof + 1, f.dof + 1, number(f.value));
    }
    bool headed = false;
    for (std::size_t n = 0; n < step.force.size(); ++n) {
      for (int c = 0; c < 3; ++c) {
        if (step.force[n][c] != 0.0 && used_[n]) {
          put("{}{}, {}, {}\n", headed ? "" : "*CLOAD\n", node_[n], c + 1,
              number(step.force[n][c]));
          headed = true;
        }
      }
    }
    if (!step.temperature.empty()) {
      put("*TEMPERATURE\n");
      temperatures(step, [](double T) { return T; });
    }
    put("*NODE FILE\nU, RF\n*EL FILE\nS\n*END STEP\n");
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  std::vector<Label> node_, element_;
  std::vector<bool> used_;
  std::set<std::string> names_;
  std::vector<std::string> element_set_name_;
  std::string text_;
};

} // namespace

std::vector<std::string> types_without_inp_name(const model::Mesh& mesh) {
  std::set<std::string> missing;
  for (const base::ElementType type : mesh.type) {
    const base::ElementInfo& info = base::element_info(type);
    if (inp_element_name(type, usual_state.at(info.dim)).empty()) {
      missing.insert(std::string(info.name));
    }
  }
  return {missing.begin(), missing.end()};
}

std::vector<base::Label> inp_node_numbers(const model::Mesh& mesh) {
  return make_labels_unique(mesh.node_label);
}

std::string write_inp(const model::Model& model, const InpStep* step) {
  return InpWriter(model).text(step);
}

} // namespace spricka::mesh
