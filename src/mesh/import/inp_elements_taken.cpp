// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_elements_taken.hpp"

#include "mesh/set_name.hpp"
#include "mesh/side_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

class ElementSorter {
public:
  ElementSorter(InpData& data, std::vector<std::size_t>& place, const LabelIndex& nodes,
                const ImportRequest& request, InpMessages& words)
      : data_(data), place_(place), nodes_(nodes), request_(request), words_(words) {}

  InpElementsTaken run() {
    keep_bodies();
    refuse_plates_alone();
    for (const InpLabelList::InpLabelRange& range : data_.connector.ranges()) {
      for (base::Label label = range.first; label <= range.last; ++label) {
        result_.left.emplace(label, false);
      }
    }
    const bool free_sides =
        std::ranges::any_of(data_.surfaces, [](const InpData::InpSurface& surface) {
          return std::ranges::any_of(surface.members,
                                     [](const auto& member) { return !member.side; });
        });
    keep_wanted();
    if (free_sides || !data_.surface_elements.empty()) {
      find_sides(free_sides);
    }
    shorten();
    return std::move(result_);
  }

private:
  /// Plane elements beside solids are faces, as gmsh writes surfaces of a solid.
  void keep_bodies() {
    int highest = 0;
    for (const InpElementType& type : data_.type) {
      highest = std::max(highest, base::element_info(type.type).dim);
    }
    keep_.assign(data_.element.size(), true);
    std::vector<std::size_t> type_of(base::element_infos.size() * 4, no_type);
    for (std::size_t e = 0; e < keep_.size(); ++e) {
      const base::ElementInfo& info = base::element_info(data_.type[e].type);
      if (info.dim == highest) {
        continue;
      }
      keep_[e] = false;
      std::size_t& type = type_of[static_cast<std::size_t>(data_.type[e].type) * 4 +
                                  static_cast<std::size_t>(data_.type[e].state)];
      if (type == no_type) {
        type = data_.surface_types.size();
        data_.surface_types.push_back(
            {inp_element_name(data_.type[e].type, data_.type[e].state), data_.element_place[e], 0});
      }
      ++data_.surface_types[type].count;
      InpData::InpSurfaceElement side;
      side.label = data_.element[e];
      side.corners = static_cast<std::size_t>(info.corners);
      side.type = type;
      std::copy_n(data_.connectivity.begin() + static_cast<std::ptrdiff_t>(data_.first[e]),
                  side.corners, side.corner.begin());
      data_.surface_elements.push_back(side);
    }
    bodies_ = keep_;
  }

  /// Shells without a solid or plane element that they could lie on.
  void refuse_plates_alone() {
    if (std::ranges::find(keep_, true) != keep_.end()) {
      return;
    }
    for (const InpData::InpElementKind& kind : data_.surface_types) {
      words_.error(kind.first, "E336",
                   fmt::format("elements of type {} are not known ({})", kind.name, kind.count),
                   "solids and plane elements are imported, no shells, membranes or bars");
    }
  }

  void keep_wanted() {
    if (request_.element_set.empty()) {
      return;
    }
    const auto wanted = std::ranges::find_if(data_.element_sets, [&](const auto& set) {
      return upper_case(set.name) == upper_case(request_.element_set) ||
             make_valid_set_name(set.name) == upper_case(request_.element_set);
    });
    if (wanted == data_.element_sets.end()) {
      std::vector<std::string> names;
      for (const auto& set : data_.element_sets) {
        names.push_back(set.name);
      }
      words_.error({}, "E332", fmt::format("there is no element set '{}'", request_.element_set),
                   base::make_spelling_hint(request_.element_set, names));
      return;
    }
    std::vector<bool> member(keep_.size(), false);
    for (const std::size_t e : InpLabelFinder(data_.element).find(wanted->members).places) {
      member[e] = true;
    }
    for (std::size_t e = 0; e < keep_.size(); ++e) {
      if (keep_[e] && !member[e]) {
        keep_[e] = false;
        result_.left.emplace(data_.element[e], false);
      }
    }
    if (std::ranges::find(keep_, true) == keep_.end()) {
      words_.error(wanted->place, "E333",
                   fmt::format("set {} has no element that can be imported", wanted->name));
    }
  }

  /// A mesh of corners is all that sides are found by.
  void find_sides(bool free_sides) {
    model::Mesh mesh;
    std::vector<std::size_t> taken; ///< [element of this mesh] its place among those taken
    std::vector<NodeId> corners;
    for (std::size_t n = 0; n < data_.node.size(); ++n) {
      model::add_node(mesh, data_.x[n], data_.node[n], request_.net);
    }
    std::size_t next = 0;
    for (std::size_t e = 0; e < keep_.size(); ++e) {
      if (!bodies_[e]) {
        continue;
      }
      corners.clear();
      for (std::size_t k = data_.first[e]; k < data_.first[e + 1]; ++k) {
        corners.emplace_back(place_[k]);
      }
      model::add_element(mesh, data_.type[e].type, corners, data_.element[e], request_.net);
      taken.push_back(keep_[e] ? next++ : no_type);
    }
    const SideIndex sides(mesh);
    on_side_.assign(data_.surface_types.size(), 0);
    on_no_side_ = on_side_;
    for (const InpData::InpSurfaceElement& element : data_.surface_elements) {
      place_on_side(element, mesh, sides, taken);
    }
    sort_by_type();
    if (free_sides) {
      for (const model::Face& face : sides.unshared_sides()) {
        if (taken[face.element.index()] != no_type) {
          result_.free_sides.push_back({ElementId(taken[face.element.index()]), face.side});
        }
      }
    }
  }

  static std::optional<model::Face> side_of(const model::Mesh& mesh, const SideIndex& sides,
                                            std::span<const NodeId> corners) {
    const bool known = std::ranges::all_of(corners, [](NodeId n) { return n.valid(); });
    return known ? find_side_below(mesh, sides, corners) : std::nullopt;
  }

  void place_on_side(const InpData::InpSurfaceElement& element, const model::Mesh& mesh,
                     const SideIndex& sides, const std::vector<std::size_t>& taken) {
    std::array<NodeId, 4> corners{};
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto at = nodes_.find(element.corner[c]);
      corners[c] = at ? NodeId(*at) : NodeId();
    }
    const std::span<const NodeId> key(corners.data(), element.corners);
    auto face = side_of(mesh, sides, key);
    if (!face && element.corners == 2 && corners[2].valid()) { // the middle node stands between
      std::swap(corners[1], corners[2]);
      face = side_of(mesh, sides, key);
    }
    if (face && taken[face->element.index()] == no_type) { // of a body that is not taken
      const auto both = sides.find(key);
      const auto other = std::ranges::find_if(
          both, [&](const model::Face& f) { return taken[f.element.index()] != no_type; });
      face = other == both.end() ? std::nullopt : std::optional(*other);
      result_.left.emplace(element.label, true);
    } else if (!face) {
      result_.left.emplace(element.label, true);
      ++on_no_side_[element.type];
    }
    if (face) {
      result_.left.erase(element.label);
      result_.faces.emplace(element.label,
                            model::Face{ElementId(taken[face->element.index()]), face->side});
      ++on_side_[element.type];
    }
  }

  /// Plane elements that a mesher left beside solids carry nothing there, shells do.
  void sort_by_type() {
    for (std::size_t t = 0; t < on_no_side_.size(); ++t) {
      const InpData::InpElementKind& kind = data_.surface_types[t];
      const auto type = find_inp_surface_element_type(kind.name);
      if (on_side_[t] > 0) {
        result_.on_sides.push_back({kind.name, kind.first, on_side_[t]});
      }
      const bool idle = type ? type->corners == 2 : request_.skip == InpSkip::all;
      if (on_no_side_[t] > 0 && idle) {
        result_.idle.push_back({kind.name, kind.first, on_no_side_[t]});
      } else if (on_no_side_[t] > 0) {
        words_.error(kind.first, "E336",
                     fmt::format("{} of {} elements of type {} are no face of a solid: shells and "
                                 "membranes are not imported",
                                 on_no_side_[t], kind.count, kind.name));
      }
    }
  }

  /// The data without what is not kept.
  void shorten() {
    std::size_t element = 0;
    std::size_t entry = 0;
    for (std::size_t e = 0; e < keep_.size(); ++e) {
      if (!keep_[e]) {
        continue;
      }
      const std::size_t begin = data_.first[e];
      const std::size_t end = data_.first[e + 1];
      data_.element[element] = data_.element[e];
      data_.type[element] = data_.type[e];
      data_.element_place[element] = data_.element_place[e];
      for (std::size_t k = begin; k < end; ++k, ++entry) {
        place_[entry] = place_[k];
        data_.connectivity[entry] = data_.connectivity[k];
      }
      data_.first[++element] = entry;
    }
    data_.element.resize(element);
    data_.type.resize(element);
    data_.element_place.resize(element);
    data_.first.resize(element + 1);
    data_.connectivity.resize(entry);
    place_.resize(entry);
  }

  static constexpr std::size_t no_type = static_cast<std::size_t>(-1);

  InpData& data_;
  std::vector<std::size_t>& place_;
  const LabelIndex& nodes_;
  const ImportRequest& request_;
  InpMessages& words_;
  std::vector<bool> keep_, bodies_;
  std::vector<std::size_t> on_side_, on_no_side_; ///< [surface type]
  InpElementsTaken result_;
};

} // namespace

InpElementsTaken take_inp_elements(InpData& data, std::vector<std::size_t>& place,
                                   const LabelIndex& nodes, const ImportRequest& request,
                                   InpMessages& words) {
  return ElementSorter(data, place, nodes, request, words).run();
}

} // namespace spricka::mesh
