// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_physics.hpp"

#include "mesh/set_name.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <optional>
#include <set>
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
    for (const InpData::InpMaterial& m : data_.materials) {
      add_material(m);
    }
    std::vector<bool> taken(data_.element.size(), false);
    for (const InpData::InpSection& section : data_.sections) {
      add_section(section, taken);
    }
    for (const auto& [material, without] : inelastic_sections_) {
      words_.warning(without.first, "W469",
                     fmt::format("sections of material {} are left out, as it has no isotropic "
                                 "*ELASTIC: give $MATERIAL and $PROPERTY for {}",
                                 material, without.sets));
    }
    if (!request_.element_set.empty()) {
      drop_unused_materials();
    }
    physics_.files = data_.files;
    for (const InpData::InpEquation& equation : data_.equations) {
      add_equation(equation);
    }
    if (unknown_count_ > 0 && request_.element_set.empty()) {
      words_.warning(unknown_, "W468",
                     fmt::format("{} of {} equations are left out: they name nodes that no element "
                                 "has, or rotations",
                                 unknown_count_, data_.equations.size()));
    }
    return std::move(physics_);
  }

private:
  void add_material(const InpData::InpMaterial& from) {
    const std::string name = upper_case(from.name);
    if (index_.contains(name) || inelastic_.contains(name)) {
      words_.error(from.place, "E302", fmt::format("material {} is defined twice", from.name));
    }
    if (!from.elastic) {
      inelastic_.insert(name);
      if (request_.skip != InpSkip::all) {
        words_.error(from.place, "E336", fmt::format("material {} has no *ELASTIC", from.name));
      }
      return;
    }
    index_.try_emplace(name, physics_.materials.size());
    model::ElasticMaterial material;
    material.name = request_.prefix + make_valid_set_name(from.name);
    material.E = from.E;
    material.nu = from.nu;
    material.rho = from.rho;
    material.alpha = from.alpha;
    material.span = request_.span;
    physics_.materials.push_back(std::move(material));
  }

  void add_section(const InpData::InpSection& section, std::vector<bool>& taken) {
    const auto set = places_.set_of_name.find(upper_case(section.elements));
    const bool there = set != places_.set_of_name.end();
    if (has_bars_or_facets(section.elements)) {
      words_.error(section.place, "E336",
                   fmt::format("set {} has a section and holds bars or facets, which are not "
                               "imported",
                               section.elements),
                   "take them out of the file if they carry no load");
    } else if (!there && is_set_of_file(section.elements)) {
      return; // of what is not taken
    } else if (there && inelastic_.contains(upper_case(section.material))) {
      WithoutProperty& without = inelastic_sections_[section.material];
      without.first = without.sets.empty() ? section.place : without.first;
      without.sets += (without.sets.empty() ? "" : ", ") + section.elements;
    } else if (const auto material = index_.find(upper_case(section.material));
               material == index_.end() || !there) {
      words_.error(section.place, "E301",
                   there ? fmt::format("there is no material {}", section.material)
                         : fmt::format("there is no element set {}", section.elements));
    } else {
      add_property(section, base::ElementSetId(set->second), base::MaterialId(material->second),
                   taken);
    }
  }

  [[nodiscard]] bool is_set_of_file(const std::string& name) const {
    return std::ranges::any_of(data_.element_sets, [&](const InpData::InpLabelSet& set) {
      return upper_case(set.name) == upper_case(name) && !set.members.empty();
    });
  }
  [[nodiscard]] bool has_bars_or_facets(const std::string& name) {
    if (sides_.empty()) {
      for (const InpData::InpSurfaceElement& element : data_.surface_elements) {
        sides_.push_back(element.label);
      }
      std::sort(sides_.begin(), sides_.end());
    }
    const auto holds_one = [&](const InpLabelList::InpLabelRange& range) {
      auto at = std::ranges::lower_bound(sides_, std::min(range.first, range.last));
      while (at != sides_.end() && *at <= std::max(range.first, range.last) && !range.holds(*at)) {
        ++at;
      }
      return at != sides_.end() && range.holds(*at);
    };
    return std::ranges::any_of(data_.element_sets, [&](const InpData::InpLabelSet& set) {
      return upper_case(set.name) == upper_case(name) &&
             std::ranges::any_of(set.members.ranges(), holds_one);
    });
  }

  /// A file of several bodies has materials of the others.
  void drop_unused_materials() {
    std::vector<model::ElasticMaterial> used;
    std::vector<std::optional<std::size_t>> place(physics_.materials.size());
    for (model::ElementProperty& property : physics_.properties) {
      std::optional<std::size_t>& at = place[property.material.index()];
      if (!at) {
        at = used.size();
        used.push_back(physics_.materials[property.material.index()]);
      }
      property.material = base::MaterialId(*at);
    }
    physics_.materials = std::move(used);
  }

  void add_equation(const InpData::InpEquation& from) {
    model::ConstraintEquation equation;
    equation.span = request_.span;
    for (const InpData::InpEquation::InpEquationTerm& term : from.terms) {
      const auto at = places_.nodes.find(term.node);
      if (!at || !places_.node[*at].valid() || term.dof >= places_.dim) {
        if (request_.skip == InpSkip::all) {
          unknown_ = unknown_.line == 0 ? from.place : unknown_;
          ++unknown_count_;
          return;
        }
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
    bool said = false;
    for (const ElementId e : elements) {
      const std::size_t i = e.index() - places_.first_element;
      if (data_.type[i].state != property.state) {
        words_.error(section.place, "E313",
                     fmt::format("set {} mixes plane stress, plane strain or axial symmetry",
                                 section.elements));
        return;
      }
      if (taken[i] && request_.skip != InpSkip::all) {
        words_.error(section.place, "E306",
                     fmt::format("element {} has a *SOLID SECTION already", data_.element[i]));
        return;
      }
      if (taken[i] && !said) {
        words_.warning(section.place, "W469",
                       fmt::format("element {} has a *SOLID SECTION already: of two the later one "
                                   "counts",
                                   data_.element[i]));
        said = true;
      }
      taken[i] = true;
    }
    physics_.properties.push_back(property);
  }

  struct WithoutProperty {
    InpLocation first;
    std::string sets;
  };

  const InpData& data_;
  const ImportRequest& request_;
  const model::Mesh& mesh_;
  const InpMeshNumbering& places_;
  InpMessages& words_;
  std::map<std::string, std::size_t> index_; ///< place of a material, by its name in upper case
  std::set<std::string> inelastic_;
  std::map<std::string, WithoutProperty> inelastic_sections_; ///< by material
  std::vector<base::Label> sides_; ///< numbers of bars and facets, ascending
  InpLocation unknown_;            ///< the first equation of nodes that no element has
  std::size_t unknown_count_ = 0;
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
