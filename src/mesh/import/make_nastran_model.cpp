// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/make_nastran_model.hpp"

#include "mesh/import/nastran_sets.hpp"
#include "mesh/import/nastran_surfaces.hpp"
#include "mesh/import/nastran_systems.hpp"
#include "mesh/label_index.hpp"
#include "mesh/set_name.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Label;

class NastranModelMaker {
public:
  NastranModelMaker(const NastranBulk& bulk, std::vector<NastranIssue>& complaints)
      : bulk_(bulk), complaints_(complaints) {}

  NastranModel run() {
    dim_ = std::any_of(bulk_.elements.begin(), bulk_.elements.end(),
                       [](const auto& e) { return dimension(e) == 3; })
               ? 3
               : 2;
    if (!place_nodes()) {
      return std::move(model_);
    }
    for (const NastranBulk::NastranElement& element : bulk_.elements) {
      if (dimension(element) == dim_) {
        add_element(element);
      } else {
        add_skin(element);
      }
    }
    add_bars();
    add_sections();
    check_plane();
    if (complaints_.empty() && all_nodes_are_there_) {
      add_nastran_lists(bulk_, model_);
      add_nastran_surfaces(bulk_, skins_, *index_, model_, complaints_);
      judge_skins();
      model_.load_sets = add_nastran_load_sets(bulk_, dim_, model_, complaints_);
    }
    return std::move(model_);
  }

private:
  static int dimension(const NastranBulk::NastranElement& element) {
    return base::element_info(element.entry->linear).dim;
  }
  void complain(InpLocation at, std::string words, std::string hint = {}) {
    complaints_.push_back({at, std::move(words), std::move(hint)});
  }

  bool place_nodes() {
    NastranSystems systems(bulk_);
    std::map<Label, std::pair<InpLocation, std::string>> bad; // once for each system
    for (const NastranBulk::NastranGrid& grid : bulk_.grids) {
      const Label system = grid.system == NastranBulk::blank ? bulk_.default_system : grid.system;
      base::Vec3 x;
      std::string trouble;
      if (!systems.find_basic(system, grid.x, x, trouble)) {
        bad.try_emplace(system, grid.place, trouble);
      }
      model_.node.push_back(grid.label);
      model_.x.push_back(x);
    }
    for (const auto& [system, trouble] : bad) {
      complain(trouble.first,
               fmt::format("the coordinate system {} of a GRID {}", system, trouble.second));
    }
    index_.emplace(model_.node);
    for (std::size_t i = 0; index_->has_duplicates() && i < model_.node.size(); ++i) {
      if (const std::size_t first = *index_->find(model_.node[i]); first != i) {
        complain(bulk_.grids[i].place, fmt::format("GRID {} stands in line {} already",
                                                   model_.node[i], bulk_.grids[first].place.line));
      }
    }
    return complaints_.empty();
  }

  void add_element(const NastranBulk::NastranElement& element) {
    const NastranElementEntry& entry = *element.entry;
    const base::ElementType type = element.quadratic ? entry.quadratic : entry.linear;
    const auto count = static_cast<std::size_t>(base::element_info(type).nodes);
    const std::span<const int> order = nastran_node_order(type);
    std::vector<Label> nodes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = order.empty() ? i : static_cast<std::size_t>(order[i]);
      nodes[i] = bulk_.connectivity[element.first + from];
    }
    if (is_left_handed(type, nodes)) {
      const std::vector<Label> before = nodes;
      const std::vector<int> mirrored = mirrored_node_order(type);
      std::transform(mirrored.begin(), mirrored.end(), nodes.begin(),
                     [&](int i) { return before[static_cast<std::size_t>(i)]; });
    }
    const auto property = bulk_.properties.find(element.property);
    const bool strain = property != bulk_.properties.end() && property->second.plane_strain;
    model_.element.push_back(element.label);
    model_.type.push_back(type);
    model_.state.push_back(dim_ == 3 ? model::StressState::solid
                           : strain  ? model::StressState::plane_strain
                                     : model::StressState::plane_stress);
    if (entry.special && !element.quadratic) {
      model_.special.try_emplace(fmt::format("{} of {} nodes", entry.name, count), element.place);
    }
    model_.element_place.push_back(element.place);
    model_.connectivity.insert(model_.connectivity.end(), nodes.begin(), nodes.end());
    model_.first.push_back(model_.connectivity.size());
    parts_[element.property].push_back(element.label);
    if (element.own_thickness && dim_ == 2 &&
        thick_.insert(entry.name).second) { // once for each kind
      complain(element.place,
               fmt::format("{} {} has thicknesses at its corners (T1 ..), which are "
                           "not imported",
                           entry.name, element.label),
               "PSHELL has the thickness of a plane part");
    }
  }

  void check_plane() {
    double size = 0.0;
    double height = 0.0;
    for (const Label label : model_.connectivity) {
      const auto at = index_->find(label);
      if (!at) {
        all_nodes_are_there_ = false; // told where nodes are looked up
        return;
      }
      size = std::max(size, model_.x[*at].cwiseAbs().maxCoeff());
      height = std::max(height, std::abs(model_.x[*at].z()));
    }
    if (dim_ == 2 && height > 1e-9 * size) {
      complain({}, "the shells do not lie in the plane z = 0",
               "shells are imported as plane parts alone, bodies in space as solids");
    }
  }

  /// Nastran takes elements of either sense.
  [[nodiscard]] bool is_left_handed(base::ElementType type, const std::vector<Label>& nodes) {
    const base::ElementInfo& info = base::element_info(type);
    std::array<base::Vec3, 8> x;
    x.fill(base::Vec3::Zero());
    for (std::size_t i = 0; i < static_cast<std::size_t>(info.corners); ++i) {
      const auto at = index_->find(nodes[i]);
      if (!at) {
        return false; // a mistake that is told where nodes are looked up
      }
      x[i] = model_.x[*at];
    }
    const base::Vec3 triangle = (x[1] - x[0]).cross(x[2] - x[0]);
    const base::Vec3 quadrilateral = (x[2] - x[0]).cross(x[3] - x[1]);
    switch (info.domain) {
    case base::ReferenceDomain::tetrahedron:
      return triangle.dot(x[3] - x[0]) < 0.0;
    case base::ReferenceDomain::prism:
      return triangle.dot(x[3] + x[4] + x[5] - x[0] - x[1] - x[2]) < 0.0;
    case base::ReferenceDomain::hexahedron:
      return quadrilateral.dot(x[4] + x[5] + x[6] + x[7] - x[0] - x[1] - x[2] - x[3]) < 0.0;
    case base::ReferenceDomain::triangle:
      return triangle.z() < 0.0;
    default:
      return quadrilateral.z() < 0.0;
    }
  }

  void add_skin(const NastranBulk::NastranElement& element) {
    const std::span<const Label> corners =
        std::span<const Label>(bulk_.connectivity).subspan(element.first, element.entry->corners);
    skins_.push_back({element.label,
                      element.property,
                      {corners.begin(), corners.end()},
                      std::string(element.entry->name),
                      element.place});
  }

  /// Bars without a property are lines of a preprocessor: of edges in the plane, else of nothing.
  void add_bars() {
    for (const NastranBulk::NastranBar& bar : bulk_.bars) {
      if (bulk_.bar_properties.contains(bar.property)) {
        continue; // told as an entry that is not imported
      }
      if (dim_ == 2) {
        skins_.push_back(
            {bar.label, bar.property, {bar.nodes[0], bar.nodes[1]}, bar.name, bar.place});
      } else {
        model_.bars[bar.name].add(bar.place);
      }
    }
  }

  void add_sections() {
    std::map<std::string, std::vector<Label>> named;
    for (auto& [property, elements] : parts_) {
      const std::string set = fmt::format("P{}", property);
      model_.element_sets.push_back({set, elements, {}});
      if (const auto name = bulk_.property_names.find(property);
          name != bulk_.property_names.end()) {
        std::vector<Label>& all = named[make_valid_set_name(name->second)];
        all.insert(all.end(), elements.begin(), elements.end());
      }
      if (const auto at = bulk_.properties.find(property); at != bulk_.properties.end()) {
        add_section(property, set, at->second);
      }
    }
    for (auto& [name, elements] : named) {
      const bool taken = std::any_of(model_.element_sets.begin(), model_.element_sets.end(),
                                     [&name = name](const auto& set) { return set.name == name; });
      if (!taken) {
        model_.element_sets.push_back({name, std::move(elements), {}});
      }
    }
  }

  void add_section(Label label, const std::string& set,
                   const NastranBulk::NastranProperty& property) {
    if (property.shell != (dim_ == 2)) {
      complain(property.place, fmt::format("property {} is a {}, and elements of {} have it", label,
                                           property.shell ? "PSHELL" : "PSOLID",
                                           dim_ == 2 ? "the plane" : "space"));
      return;
    }
    if (bulk_.empty_materials.contains(property.material)) {
      return;
    }
    if (property.shell && !(property.material > 0 && property.thickness > 0.0)) {
      complain(property.place,
               fmt::format("PSHELL {} of a plane part needs MID1 and a thickness T", label));
      return;
    }
    if (bulk_.materials.contains(property.material)) {
      model_.sections.push_back({set, fmt::format("M{}", property.material),
                                 property.shell ? property.thickness : 1.0, property.place});
      return;
    }
    const bool other = std::any_of(bulk_.refused.begin(), bulk_.refused.end(), [](const auto& met) {
      return met.first.starts_with("MAT"); // that one is told of
    });
    if (!other) {
      complain(property.place, fmt::format("property {} has material {}, which is not there", label,
                                           property.material));
    }
  }

  /// Shells beside the solids are parts that are missing; on them, their stiffness is.
  void judge_skins() {
    std::map<std::pair<Label, std::string>, std::pair<std::size_t, InpLocation>> stray;
    std::set<std::string> stiff;
    for (const NastranSkin& skin : skins_) {
      const auto property = bulk_.properties.find(skin.property);
      const bool carries = dim_ == 3 && property != bulk_.properties.end() &&
                           bulk_.materials.contains(property->second.material);
      if (skin.lies_on_side && carries) {
        stiff.insert(fmt::format("{} of property {}", skin.name, skin.property));
      } else if (!skin.lies_on_side) {
        auto& [count, place] = stray[{skin.property, skin.name}];
        place = count++ == 0 ? skin.place : place;
      }
    }
    model_.skins_with_stiffness.assign(stiff.begin(), stiff.end());
    for (const auto& [kind, met] : stray) {
      model_.stray_skins.push_back(
          {met.second,
           fmt::format("{} {} of property {} lie on no side of {}", met.first, kind.second,
                       kind.first, dim_ == 3 ? "a solid" : "an element"),
           dim_ == 3 ? "shells are imported where they lie on faces of solids, as surfaces"
                     : "bars are imported where they lie on edges, as surfaces"});
    }
  }

  const NastranBulk& bulk_;
  std::vector<NastranIssue>& complaints_;
  NastranModel model_;
  int& dim_ = model_.dim;
  std::optional<LabelIndex> index_;
  std::map<Label, std::vector<Label>> parts_; ///< elements by property
  std::vector<NastranSkin> skins_;
  std::set<std::string_view> thick_;
  bool all_nodes_are_there_ = true;
};

} // namespace

NastranModel make_nastran_model(const NastranBulk& bulk, std::vector<NastranIssue>& complaints) {
  return NastranModelMaker(bulk, complaints).run();
}

} // namespace spricka::mesh
