// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_sets.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::Label;
using base::NodeId;

class SetWriter {
public:
  SetWriter(model::Mesh& mesh, const InpData& data, const InpElementsTaken& taken,
            const ImportRequest& request, const InpSetPlaces& places, InpMessages& words)
      : mesh_(mesh), data_(data), taken_(taken), request_(request), places_(places), words_(words) {
  }

  std::map<std::string, std::size_t> run() {
    for (const InpData::InpLabelSet& set : data_.element_sets) {
      add_element_set(set);
    }
    for (const InpData::InpLabelSet& set : data_.node_sets) {
      add_node_set(set);
    }
    for (const InpData::InpSurface& surface : data_.surfaces) {
      add_surface(surface);
    }
    say_what_is_lacking();
    refuse_missing_renames();
    return std::move(set_of_name_);
  }

private:
  std::string name_of(const std::string& written) {
    names_.push_back(written);
    for (std::size_t i = 0; i < request_.renames.size(); ++i) {
      if (upper_case(request_.renames[i].first) == upper_case(written)) {
        renamed_.resize(request_.renames.size(), false);
        renamed_[i] = true;
        return request_.prefix + request_.renames[i].second;
      }
    }
    return request_.prefix + make_valid_set_name(written);
  }

  void refuse_missing_renames() {
    renamed_.resize(request_.renames.size(), false);
    for (std::size_t i = 0; i < renamed_.size(); ++i) {
      if (!renamed_[i]) {
        words_.error({}, "E332", fmt::format("there is no set '{}'", request_.renames[i].first),
                     base::make_spelling_hint(request_.renames[i].first, names_));
      }
    }
  }

  /// A set that would be empty for what is not taken of the file.
  [[nodiscard]] bool partial() const { return !request_.element_set.empty(); }

  /// Whether a set may name what is not there; else an error, and false.
  bool may_lack(const InpData::InpLabelSet& set, std::string_view kind, Label label) {
    if (request_.skip != InpSkip::all) {
      words_.error(set.place, "E303",
                   fmt::format("set {} has {} {}, which is not there", set.name, kind, label));
      return false;
    }
    if (lacking_++ == 0) {
      first_lacking_ = fmt::format("{} has {} {}", set.name, kind, label);
      lacking_place_ = set.place;
    }
    return true;
  }
  void say_what_is_lacking() {
    if (lacking_ > 0) {
      words_.warning(lacking_place_, "W469",
                     fmt::format("{} of the sets {} what is not there, which is left out: {}",
                                 lacking_, lacking_ == 1 ? "names" : "name", first_lacking_));
    }
  }

  void add_node_set(const InpData::InpLabelSet& set) {
    const InpLabelFinder::FoundLabels found = places_.nodes.find(set.members);
    if (!found.complete() && !may_lack(set, "node", found.others.front())) {
      return;
    }
    std::vector<NodeId> nodes;
    for (const std::size_t place : found.places) {
      if (places_.node[place].valid()) {
        nodes.push_back(places_.node[place]);
      }
    }
    for (const std::string& elements : set.element_sets) {
      add_nodes_of_elements(set, elements, nodes);
    }
    if (nodes.empty() && partial()) {
      names_.push_back(set.name);
      return;
    }
    mesh_.node_sets.push_back({name_of(set.name), std::move(nodes), request_.span});
  }

  void add_nodes_of_elements(const InpData::InpLabelSet& set, const std::string& elements,
                             std::vector<NodeId>& nodes) {
    const auto at = std::ranges::find_if(data_.element_sets, [&](const auto& other) {
      return upper_case(other.name) == upper_case(elements);
    });
    if (at == data_.element_sets.end()) {
      words_.error(set.place, "E303", fmt::format("there is no element set '{}'", elements));
      return;
    }
    std::set<NodeId> met(nodes.begin(), nodes.end());
    for (const std::size_t e : places_.elements.find(at->members).places) {
      for (std::size_t k = data_.first[e]; k < data_.first[e + 1]; ++k) {
        const NodeId node = places_.node[*places_.nodes.index().find(data_.connectivity[k])];
        if (met.insert(node).second) {
          nodes.push_back(node);
        }
      }
    }
  }

  void add_element_set(const InpData::InpLabelSet& set) {
    const InpLabelFinder::FoundLabels found = places_.elements.find(set.members);
    std::vector<model::Face> faces;
    std::optional<Label> lacking;
    for (const Label label : found.others) {
      if (const auto face = taken_.faces.find(label); face != taken_.faces.end()) {
        faces.push_back(face->second);
      } else if (!lacking && !taken_.left.contains(label)) {
        lacking = label;
      }
    }
    if (lacking && !may_lack(set, "element", *lacking)) {
      return;
    }
    if (found.places.empty() && (partial() || !set.members.empty())) { // of what is not taken
      not_taken_.insert(upper_case(set.name));
      names_.push_back(set.name);
      add_faces(set.name, std::move(faces));
      return;
    }
    std::vector<ElementId> elements;
    for (const std::size_t place : found.places) {
      elements.emplace_back(places_.first_element + place);
    }
    set_of_name_[upper_case(set.name)] = mesh_.element_sets.size();
    mesh_.element_sets.push_back({name_of(set.name), std::move(elements), request_.span});
  }

  /// A face set of a set of bars or facets.
  void add_faces(const std::string& name, std::vector<model::Face> faces) {
    if (faces.empty()) {
      return;
    }
    faces_of_name_[upper_case(name)] = faces;
    const auto same = [&](const InpData::InpSurface& surface) {
      return upper_case(surface.name) == upper_case(name);
    };
    if (std::ranges::none_of(data_.surfaces, same)) {
      for (model::Face& face : faces) {
        face.element = in_mesh(face.element);
      }
      mesh_.face_sets.push_back({name_of(name), std::move(faces), request_.span});
    }
  }

  [[nodiscard]] ElementId in_mesh(ElementId taken) const {
    return ElementId(places_.first_element + taken.index());
  }

  void add_surface(const InpData::InpSurface& surface) {
    std::vector<model::Face> faces;
    for (const InpData::InpSurfaceSide& entry : surface.members) {
      if (!add_sides(entry, faces)) {
        return;
      }
    }
    if (faces.empty() && (partial() || !surface.members.empty())) {
      names_.push_back(surface.name);
      return;
    }
    for (model::Face& face : faces) {
      face.element = in_mesh(face.element);
    }
    mesh_.face_sets.push_back({name_of(surface.name), std::move(faces), request_.span});
  }

  /// False after an error.
  bool add_sides(const InpData::InpSurfaceSide& entry, std::vector<model::Face>& faces) {
    if (entry.elements.empty()) {
      const auto place = places_.elements.index().find(entry.element);
      const auto own = taken_.faces.find(entry.element);
      if (place) {
        return add_sides_of({*place}, entry, faces);
      }
      if (own != taken_.faces.end()) {
        faces.push_back(own->second);
      }
      return own != taken_.faces.end() || taken_.left.contains(entry.element) ||
             lacks(entry, std::to_string(entry.element));
    }
    const std::string name = upper_case(entry.elements);
    if (const auto set = set_of_name_.find(name); set != set_of_name_.end()) {
      std::vector<std::size_t> elements;
      for (const ElementId e : mesh_.element_sets[set->second].elements) {
        elements.push_back(e.index() - places_.first_element);
      }
      return add_sides_of(elements, entry, faces);
    }
    if (const auto own = faces_of_name_.find(name); own != faces_of_name_.end()) {
      faces.insert(faces.end(), own->second.begin(), own->second.end());
      return true;
    }
    return not_taken_.contains(name) || lacks(entry, entry.elements);
  }
  bool lacks(const InpData::InpSurfaceSide& entry, const std::string& name) {
    words_.error(entry.place, "E303", fmt::format("there is no element or set '{}'", name));
    return false;
  }

  bool add_sides_of(const std::vector<std::size_t>& elements, const InpData::InpSurfaceSide& entry,
                    std::vector<model::Face>& faces) {
    if (!entry.side) {
      const std::set<std::size_t> member(elements.begin(), elements.end());
      std::ranges::copy_if(
          taken_.free_sides, std::back_inserter(faces),
          [&](const model::Face& face) { return member.contains(face.element.index()); });
      return true;
    }
    for (const std::size_t e : elements) {
      const base::ElementInfo& info = base::element_info(data_.type[e].type);
      if (*entry.side >= info.sides) {
        words_.error(entry.place, "E336",
                     fmt::format("{} has no side S{}", info.name, *entry.side + 1));
        return false;
      }
      faces.push_back({ElementId(e), *entry.side});
    }
    return true;
  }

  model::Mesh& mesh_;
  const InpData& data_;
  const InpElementsTaken& taken_;
  const ImportRequest& request_;
  InpSetPlaces places_;
  InpMessages& words_;
  std::map<std::string, std::size_t> set_of_name_;
  std::map<std::string, std::vector<model::Face>> faces_of_name_; ///< sets of bars or facets
  std::set<std::string> not_taken_;
  std::vector<std::string> names_;
  std::vector<bool> renamed_;
  std::size_t lacking_ = 0;
  std::string first_lacking_;
  InpLocation lacking_place_;
};

} // namespace

std::map<std::string, std::size_t> add_inp_sets(model::Mesh& mesh, const InpData& data,
                                                const InpElementsTaken& taken,
                                                const ImportRequest& request, InpSetPlaces places,
                                                InpMessages& words) {
  return SetWriter(mesh, data, taken, request, places, words).run();
}

} // namespace spricka::mesh
