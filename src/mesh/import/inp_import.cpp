// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_import.hpp"

#include "mesh/import/inp_physics.hpp"
#include "mesh/import/inp_reader.hpp"
#include "mesh/import/inp_words.hpp"
#include "mesh/label_index.hpp"
#include "mesh/numbering.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

/// The first place of a list whose number stands before it, too.
std::optional<std::size_t> find_duplicate(const std::vector<base::Label>& labels,
                                          const LabelIndex& index) {
  for (std::size_t i = 0; index.has_duplicates() && i < labels.size(); ++i) {
    if (index.find(labels[i]) != i) {
      return i;
    }
  }
  return std::nullopt;
}

class InpImport {
public:
  InpImport(model::Mesh& mesh, const ImportRequest& request, InpData data,
            base::Diagnostics& diagnostics)
      : mesh_(mesh), request_(request), diagnostics_(diagnostics),
        errors_(diagnostics.error_count()), data_(std::move(data)),
        words_(request, data_, diagnostics) {}

  ImportedMaterialsAndEquations run(std::vector<InpIssue> complaints) {
    std::stable_sort(
        complaints.begin(), complaints.end(), [](const InpIssue& a, const InpIssue& b) {
          return std::pair(a.place.file, a.place.line) < std::pair(b.place.file, b.place.line);
        });
    for (InpIssue& c : complaints) {
      error(c.place, "E336", c.text, std::move(c.hint));
    }
    if (data_.element.empty() && sound()) {
      error({}, "E333", "there are no elements");
    }
    if (!sound() || !look_up_nodes() || !look_up_elements() || !plane()) {
      return {};
    }
    first_element_ = mesh_.element_count();
    const MeshCounts before{mesh_.node_sets.size(), mesh_.element_sets.size(),
                            mesh_.face_sets.size()};
    add_sets();
    ImportedMaterialsAndEquations physics = read_inp_materials_and_equations(
        data_, request_, mesh_, {*node_index_, node_, set_of_name_, first_element_, dim_}, words_);
    if (!sound()) {
      mesh_.node_sets.resize(before.nodes);
      mesh_.element_sets.resize(before.elements);
      mesh_.face_sets.resize(before.faces);
      return {};
    }
    add_mesh();
    warn(!physics.materials.empty());
    return physics;
  }

private:
  struct MeshCounts {
    std::size_t nodes, elements, faces;
  };

  [[nodiscard]] bool sound() const { return diagnostics_.error_count() == errors_; }
  void error(InpLocation at, std::string code, const std::string& text, std::string hint = {}) {
    words_.error(at, std::move(code), text, std::move(hint));
  }

  /// Labels of nodes become places in the file's list, those of no element drop out.
  bool look_up_nodes() {
    node_index_.emplace(data_.node);
    if (const auto i = find_duplicate(data_.node, *node_index_)) {
      error({}, "E304", fmt::format("node {} is defined twice", data_.node[*i]));
      return false;
    }
    std::vector<bool> used(data_.node.size(), false);
    connectivity_.reserve(data_.connectivity.size());
    for (std::size_t e = 0; e < data_.element.size(); ++e) {
      for (std::size_t k = data_.first[e]; k < data_.first[e + 1]; ++k) {
        const auto at = node_index_->find(data_.connectivity[k]);
        if (!at) {
          error(data_.element_place[e], "E303",
                fmt::format("element {} has node {}, which is not there", data_.element[e],
                            data_.connectivity[k]));
          return false;
        }
        used[*at] = true;
        connectivity_.push_back(*at);
      }
    }
    node_.assign(used.size(), NodeId());
    std::size_t next = mesh_.node_count();
    for (std::size_t i = 0; i < used.size(); ++i) {
      node_[i] = used[i] ? NodeId(next++) : NodeId();
    }
    return true;
  }

  bool look_up_elements() {
    element_index_.emplace(data_.element);
    const auto e = find_duplicate(data_.element, *element_index_);
    if (e) {
      error(data_.element_place[*e], "E304",
            fmt::format("element {} is defined twice", data_.element[*e]));
    }
    return !e;
  }

  /// All in the plane or all in space.
  bool plane() {
    dim_ = base::element_info(data_.type[0].type).dim;
    for (std::size_t e = 0; e < data_.type.size(); ++e) {
      if (base::element_info(data_.type[e].type).dim != dim_) {
        error(data_.element_place[e], "E313", "elements of the plane and of space in one file");
        return false;
      }
    }
    double size = 0.0;
    double height = 0.0;
    for (std::size_t i = 0; i < node_.size(); ++i) {
      if (node_[i].valid()) {
        size = std::max(size, data_.x[i].cwiseAbs().maxCoeff());
        height = std::max(height, data_.x[i].tail(3 - dim_).lpNorm<Eigen::Infinity>());
      }
    }
    if (height > 1e-9 * size) {
      error({}, "E335", "the elements do not lie in the plane z = 0");
      return false;
    }
    return true;
  }

  std::string name_of(const std::string& written) {
    for (std::size_t i = 0; i < request_.renames.size(); ++i) {
      if (upper_case(request_.renames[i].first) == upper_case(written)) {
        renamed_.resize(request_.renames.size(), false);
        renamed_[i] = true;
        return request_.prefix + request_.renames[i].second;
      }
    }
    return request_.prefix + make_valid_set_name(written);
  }

  void add_sets() {
    std::vector<std::string> names;
    for (const auto& set : data_.node_sets) {
      mesh_.node_sets.push_back({name_of(set.name), nodes_of(set), request_.span});
      names.push_back(set.name);
    }
    for (const auto& set : data_.element_sets) {
      if (of_bars_alone(set)) {
        continue;
      }
      set_of_name_[upper_case(set.name)] = mesh_.element_sets.size();
      mesh_.element_sets.push_back({name_of(set.name), elements_of(set), request_.span});
      names.push_back(set.name);
    }
    for (const auto& surface : data_.surfaces) {
      mesh_.face_sets.push_back({name_of(surface.name), faces_of(surface), request_.span});
      names.push_back(surface.name);
    }
    renamed_.resize(request_.renames.size(), false);
    for (std::size_t i = 0; i < renamed_.size(); ++i) {
      if (!renamed_[i]) {
        error({}, "E332", fmt::format("there is no set '{}'", request_.renames[i].first),
              base::make_spelling_hint(request_.renames[i].first, names));
      }
    }
  }

  /// The places in the file's list of what a set names, each once, without elements that are bars.
  std::vector<std::size_t> places_of(const InpData::Named<base::Label>& set,
                                     const LabelIndex& index, std::string_view kind) {
    std::vector<std::size_t> places;
    std::vector<bool> met(std::max(data_.node.size(), data_.element.size()), false);
    for (const base::Label label : set.members) {
      const auto at = index.find(label);
      if (!at && kind == "element" && data_.bar.contains(label)) {
        continue;
      }
      if (!at) {
        error(set.place, "E303",
              fmt::format("set {} has {} {}, which is not there", set.name, kind, label));
        return {};
      }
      if (!met[*at]) {
        places.push_back(*at);
      }
      met[*at] = true;
    }
    return places;
  }

  std::vector<NodeId> nodes_of(const InpData::Named<base::Label>& set) {
    std::vector<NodeId> nodes;
    for (const std::size_t at : places_of(set, *node_index_, "node")) {
      if (node_[at].valid()) {
        nodes.push_back(node_[at]);
      }
    }
    return nodes;
  }

  // Such a set would be empty; the file has it for curves.
  [[nodiscard]] bool of_bars_alone(const InpData::Named<base::Label>& set) const {
    return !data_.bar.empty() &&
           std::all_of(set.members.begin(), set.members.end(),
                       [&](base::Label label) { return data_.bar.contains(label); });
  }

  std::vector<ElementId> elements_of(const InpData::Named<base::Label>& set) {
    std::vector<ElementId> elements;
    for (const std::size_t at : places_of(set, *element_index_, "element")) {
      elements.emplace_back(first_element_ + at);
    }
    return elements;
  }

  std::vector<model::Face> faces_of(const InpData::Named<InpData::InpSurfaceSide>& surface) {
    std::vector<model::Face> faces;
    for (const InpData::InpSurfaceSide& entry : surface.members) {
      std::vector<ElementId> elements;
      const auto set = set_of_name_.find(upper_case(entry.elements));
      const auto at = element_index_->find(entry.element);
      if (entry.elements.empty() ? !at.has_value() : set == set_of_name_.end()) {
        error(entry.place, "E303",
              fmt::format("there is no element or set '{}'",
                          entry.elements.empty() ? std::to_string(entry.element) : entry.elements));
        return {};
      }
      if (entry.elements.empty()) {
        elements.emplace_back(first_element_ + *at);
      } else {
        elements = mesh_.element_sets[set->second].elements;
      }
      for (const ElementId e : elements) {
        const base::ElementInfo& info =
            base::element_info(data_.type[e.index() - first_element_].type);
        if (entry.side >= info.sides) {
          error(entry.place, "E336", fmt::format("{} has no side S{}", info.name, entry.side + 1));
          return {};
        }
        faces.push_back({e, entry.side});
      }
    }
    return faces;
  }

  void add_mesh() {
    mesh_.dim = std::max(mesh_.dim, dim_);
    const base::Label node_offset = next_node_label(mesh_, request_.net) - 1;
    const base::Label element_offset = next_element_label(mesh_, request_.net) - 1;
    for (std::size_t i = 0; i < node_.size(); ++i) {
      if (node_[i].valid()) {
        base::Vec3 x = request_.scale * data_.x[i];
        x.tail(3 - dim_).setZero(); // in the plane
        model::add_node(mesh_, x, node_offset + data_.node[i], request_.net);
      }
    }
    std::vector<NodeId> nodes;
    for (std::size_t e = 0; e < data_.element.size(); ++e) {
      nodes.clear();
      for (std::size_t k = data_.first[e]; k < data_.first[e + 1]; ++k) {
        nodes.push_back(node_[connectivity_[k]]);
      }
      model::add_element(mesh_, data_.type[e].type, nodes, element_offset + data_.element[e],
                         request_.net);
    }
  }

  void warn(bool has_moduli) {
    for (const auto& [name, bars] : data_.bars) {
      words_.warning(bars.first, "W466",
                     fmt::format("{} lines of type {} are left out, as there are no bars; sets of "
                                 "them too",
                                 bars.count, name));
    }
    std::string keywords;
    for (const auto& [name, left] : data_.keywords) {
      keywords += fmt::format("{}*{} ({})", keywords.empty() ? "" : ", ", name, left.count);
    }
    if (!keywords.empty()) {
      words_.warning({}, "W467", fmt::format("passed over, as SKIP=LOADS asks for: {}", keywords));
    }
    if (request_.scale != 1.0 && has_moduli) {
      words_.warning({}, "W337",
                     "SCALE is for lengths; moduli are taken as they stand in the file");
    }
    for (const auto& [name, at] : data_.special) {
      words_.warning(
          at, "W336",
          fmt::format("{} stands for a special form (reduced integration, incompatible modes, "
                      "hybrid or modified); here its nodes make a fully integrated element",
                      name));
    }
  }

  model::Mesh& mesh_;
  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  std::size_t errors_;
  InpData data_;
  InpMessages words_;
  int dim_ = 2;
  std::size_t first_element_ = 0;
  std::optional<LabelIndex> node_index_;
  std::optional<LabelIndex> element_index_;
  std::vector<std::size_t> connectivity_;
  std::vector<NodeId> node_; ///< [place in the file]; none if no element has it
  std::map<std::string, std::size_t> set_of_name_;
  std::vector<bool> renamed_;
};

} // namespace

ImportedMaterialsAndEquations import_inp(model::Mesh& mesh, const ImportRequest& request,
                                         base::Diagnostics& diagnostics) {
  std::vector<InpIssue> complaints;
  InpData data = read_inp_data(request.file, complaints, request.skip == InpSkip::loads);
  return import_inp_data(mesh, request, std::move(data), std::move(complaints), diagnostics);
}

ImportedMaterialsAndEquations import_inp_data(model::Mesh& mesh, const ImportRequest& request,
                                              InpData data, std::vector<InpIssue> complaints,
                                              base::Diagnostics& diagnostics) {
  return InpImport(mesh, request, std::move(data), diagnostics).run(std::move(complaints));
}

} // namespace spricka::mesh
