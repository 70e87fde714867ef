// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_surfaces.hpp"

#include "mesh/import/nastran_sets.hpp"
#include "mesh/side_index.hpp"
#include "shape/topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace spricka::mesh {
namespace {

using base::NodeId;

/// The surfaces of bulk data, found on a mesh of its elements alone.
class NastranSurfaces {
public:
  NastranSurfaces(const LabelIndex& nodes, NastranModel& model,
                  std::vector<NastranIssue>& complaints)
      : nodes_(nodes), model_(model), complaints_(complaints), elements_(model.element) {
    for (std::size_t i = 0; i < model.node.size(); ++i) {
      model::add_node(mesh_, model.x[i], model.node[i], base::NetId(std::size_t{0}));
    }
    std::vector<NodeId> corners;
    for (std::size_t e = 0; e < model.element.size(); ++e) {
      corners.clear();
      for (std::size_t k = model.first[e]; k < model.first[e + 1]; ++k) {
        corners.emplace_back(*nodes.find(model.connectivity[k]));
      }
      model::add_element(mesh_, model.type[e], corners, model.element[e],
                         base::NetId(std::size_t{0}));
    }
  }

  void add_skins(std::vector<NastranSkin>& skins) {
    std::vector<bool> marked(mesh_.node_count(), false);
    std::vector<std::vector<NodeId>> corners(skins.size());
    for (std::size_t s = 0; s < skins.size(); ++s) {
      for (const base::Label label : skins[s].corners) {
        if (const auto at = nodes_.find(label)) {
          corners[s].emplace_back(*at);
          marked[*at] = true;
        }
      }
    }
    const SideIndex sides(mesh_, 0, &marked);
    for (std::size_t s = 0; s < skins.size(); ++s) {
      const auto face = corners[s].size() == skins[s].corners.size()
                            ? find_side_below(mesh_, sides, corners[s])
                            : std::nullopt;
      skins[s].lies_on_side = face.has_value();
      if (face) {
        add(fmt::format("S{}", skins[s].property), *face, skins[s].place);
        of_skin_[skins[s].label] = *face;
      }
    }
  }

  void add_list(const NastranBulk::NastranList& list, const std::string& name) {
    for (const auto& [first, last] : list.members) {
      for (auto at = of_skin_.lower_bound(first); at != of_skin_.end() && at->first <= last; ++at) {
        add(name, at->second, list.place);
      }
    }
  }

  void add_pressure(const NastranBulk::NastranPressure& pressure) {
    const std::string name = fmt::format("PLOAD4_{}", pressure.set);
    const auto [first, last] = pressure.elements;
    std::size_t found = 0;
    for (auto at = of_skin_.lower_bound(first); at != of_skin_.end() && at->first <= last; ++at) {
      add(name, at->second, pressure.place);
      ++found;
    }
    const auto element = elements_.find(first);
    if (element && found == 0 && !shape::is_plane_element_side(mesh_.type[*element], 0)) {
      const auto side = loaded_side(*element, pressure);
      if (!side) {
        complaints_.push_back({pressure.place,
                               fmt::format("PLOAD4: element {} has no side with corner {} that "
                                           "{} tells from the others",
                                           first, pressure.corner, pressure.other),
                               {}});
        return;
      }
      add(name, {base::ElementId(*element), *side}, pressure.place);
    }
  }

private:
  /// A quadrilateral by two corners across, a triangle by one of its corners; of a tetrahedron the
  /// other corner is that off the side.
  [[nodiscard]] std::optional<int> loaded_side(std::size_t element,
                                               const NastranBulk::NastranPressure& by) const {
    const base::ElementType type = mesh_.type[element];
    const base::ElementInfo& info = base::element_info(type);
    const auto nodes = mesh_.element_nodes(base::ElementId(element));
    std::optional<int> found;
    for (int s = 0; s < info.sides; ++s) {
      const std::size_t corners = shape::side_corner_count(type, s);
      const auto local = shape::side_nodes(type, s).first(corners);
      const auto holds = [&](base::Label label) {
        const auto at = nodes_.find(label);
        return at && std::any_of(local.begin(), local.end(), [&](int i) {
                 return nodes[static_cast<std::size_t>(i)].index() == *at;
               });
      };
      const bool fits = info.domain == base::ReferenceDomain::tetrahedron
                            ? by.other != 0 && !holds(by.other)
                        : by.other != 0 ? corners == 4 && holds(by.other)
                                        : corners == 3;
      if (fits && holds(by.corner)) {
        if (found) {
          return std::nullopt;
        }
        found = s;
      }
    }
    return found;
  }

  void add(const std::string& name, model::Face face, InpLocation place) {
    const auto [at, fresh] = surfaces_.try_emplace(name, model_.surfaces.size());
    if (fresh) {
      model_.surfaces.push_back({name, {}, place});
    }
    if (met_[name].insert(face).second) {
      model_.surfaces[at->second].sides.emplace_back(model_.element[face.element.index()],
                                                     face.side);
    }
  }

  const LabelIndex& nodes_;
  NastranModel& model_;
  std::vector<NastranIssue>& complaints_;
  LabelIndex elements_;
  model::Mesh mesh_;
  std::map<base::Label, model::Face> of_skin_;
  std::map<std::string, std::size_t> surfaces_;
  std::map<std::string, std::set<model::Face>> met_;
};

} // namespace

void add_nastran_surfaces(const NastranBulk& bulk, std::vector<NastranSkin>& skins,
                          const LabelIndex& nodes, NastranModel& model,
                          std::vector<NastranIssue>& complaints) {
  if (skins.empty() && bulk.pressures.empty()) {
    return;
  }
  NastranSurfaces surfaces(nodes, model, complaints);
  surfaces.add_skins(skins);
  for (const NastranBulk::NastranList& list : bulk.lists) {
    if (list.elements) {
      surfaces.add_list(list, name_of_nastran_list(bulk, list));
    }
  }
  for (const NastranBulk::NastranPressure& pressure : bulk.pressures) {
    surfaces.add_pressure(pressure);
  }
}

} // namespace spricka::mesh
