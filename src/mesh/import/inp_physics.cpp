// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_physics.hpp"

#include "mesh/set_name.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;

class Physics {
public:
  Physics(const InpData& data, const ImportRequest& request, const model::Mesh& mesh,
          const InpMeshNumbering& places, InpMessages& words)
      : data_(data), request_(request), mesh_(mesh), places_(places), words_(words) {}

  ImportedMaterialsAndEquations run() {
    std::map<std::string, std::size_t> index;
    for (const InpData::InpMaterial& m : data_.materials) {
      if (!m.elastic) {
        words_.error(m.place, "E336", fmt::format("material {} has no *ELASTIC", m.name));
      }
      if (!index.try_emplace(upper_case(m.name), physics_.materials.size()).second) {
        words_.error(m.place, "E302", fmt::format("material {} is defined twice", m.name));
      }
      model::ElasticMaterial material;
      material.name = request_.prefix + make_valid_set_name(m.name);
      material.E = m.E;
      material.nu = m.nu;
      material.rho = m.rho;
      material.alpha = m.alpha;
      material.span = request_.span;
      physics_.materials.push_back(std::move(material));
    }
    std::vector<bool> taken(data_.element.size(), false);
    for (const InpData::InpSection& section : data_.sections) {
      if (has_bars(section.elements)) {
        words_.error(section.place, "E336",
                     fmt::format("set {} has a section and holds bars, which are not imported",
                                 section.elements),
                     "take the bars out of the file if they carry no load");
        continue;
      }
      const auto material = index.find(upper_case(section.material));
      const auto set = places_.set_of_name.find(upper_case(section.elements));
      if (material == index.end() || set == places_.set_of_name.end()) {
        words_.error(section.place, "E301",
                     material == index.end()
                         ? fmt::format("there is no material {}", section.material)
                         : fmt::format("there is no element set {}", section.elements));
        continue;
      }
      add_property(section, base::ElementSetId(set->second), base::MaterialId(material->second),
                   taken);
    }
    physics_.files = data_.files;
    for (const InpData::InpEquation& equation : data_.equations) {
      add_equation(equation);
    }
    return std::move(physics_);
  }

private:
  [[nodiscard]] bool has_bars(const std::string& set) const {
    return std::any_of(data_.element_sets.begin(), data_.element_sets.end(), [&](const auto& s) {
      return upper_case(s.name) == upper_case(set) &&
             std::any_of(s.members.begin(), s.members.end(),
                         [&](base::Label label) { return data_.bar.contains(label); });
    });
  }
  void add_equation(const InpData::InpEquation& from) {
    model::ConstraintEquation equation;
    equation.span = request_.span;
    for (const InpData::InpEquation::InpEquationTerm& term : from.terms) {
      const auto at = places_.nodes.find(term.node);
      if (!at || !places_.node[*at].valid() || term.dof >= places_.dim) {
        words_.error(from.place, "E303",
                     fmt::format("an *EQUATION names freedom {} of node {}, which no element has",
                                 term.dof + 1, term.node));
        return;
      }
      auto& terms = equation.terms;
      const auto same = std::find_if(terms.begin(), terms.end(), [&](const auto& t) {
        return t.node == places_.node[*at] && t.dof == term.dof;
      });
      if (same != terms.end()) {
        same->coefficient += term.coefficient;
      } else {
        terms.push_back({term.coefficient, places_.node[*at], term.dof});
      }
    }
    std::erase_if(equation.terms, [](const auto& term) { return term.coefficient == 0.0; });
    if (!equation.terms.empty()) {
      physics_.equations.push_back(std::move(equation));
    }
  }

  void add_property(const InpData::InpSection& section, base::ElementSetId set,
                    base::MaterialId material, std::vector<bool>& taken) {
    const std::vector<ElementId>& elements = mesh_.set_with_id(set).elements;
    if (elements.empty()) {
      return;
    }
    model::ElementProperty property;
    property.elements = set;
    property.material = material;
    property.thickness = request_.scale * section.thickness;
    property.span = request_.span;
    property.state = data_.type[elements[0].index() - places_.first_element].state;
    for (const ElementId e : elements) {
      const std::size_t i = e.index() - places_.first_element;
      if (data_.type[i].state != property.state) {
        words_.error(section.place, "E313",
                     fmt::format("set {} mixes plane stress, plane strain or axial symmetry",
                                 section.elements));
        return;
      }
      if (taken[i]) {
        words_.error(section.place, "E306",
                     fmt::format("element {} has a *SOLID SECTION already", data_.element[i]));
        return;
      }
      taken[i] = true;
    }
    physics_.properties.push_back(property);
  }

  const InpData& data_;
  const ImportRequest& request_;
  const model::Mesh& mesh_;
  const InpMeshNumbering& places_;
  InpMessages& words_;
  ImportedMaterialsAndEquations physics_;
};

} // namespace

ImportedMaterialsAndEquations read_inp_materials_and_equations(const InpData& data,
                                                               const ImportRequest& request,
                                                               const model::Mesh& mesh,
                                                               const InpMeshNumbering& places,
                                                               InpMessages& words) {
  return Physics(data, request, mesh, places, words).run();
}

} // namespace spricka::mesh
