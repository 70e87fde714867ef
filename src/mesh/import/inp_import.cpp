// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_import.hpp"

#include "mesh/import/inp_elements_taken.hpp"
#include "mesh/import/inp_left_out.hpp"
#include "mesh/import/inp_physics.hpp"
#include "mesh/import/inp_reader.hpp"
#include "mesh/import/inp_sets.hpp"
#include "mesh/import/inp_words.hpp"
#include "mesh/label_index.hpp"
#include "mesh/numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

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
    report(std::move(complaints));
    if (!sound() || !look_up_nodes() || !look_up_elements()) {
      return {};
    }
    const LabelIndex& nodes = node_finder_->index();
    const InpElementsTaken taken = take_inp_elements(data_, place_, nodes, request_, words_);
    if (!sound() || !plane()) {
      return {};
    }
    number_nodes();
    first_element_ = mesh_.element_count();
    const MeshCounts before{mesh_.node_sets.size(), mesh_.element_sets.size(),
                            mesh_.face_sets.size()};
    element_finder_.emplace(data_.element);
    const std::map<std::string, std::size_t> set_of_name =
        add_inp_sets(mesh_, data_, taken, request_,
                     {*node_finder_, *element_finder_, node_, first_element_}, words_);
    ImportedMaterialsAndEquations physics = read_inp_materials_and_equations(
        data_, request_, mesh_, {nodes, node_, set_of_name, taken, first_element_, dim_}, words_);
    if (!sound()) {
      mesh_.node_sets.resize(before.nodes);
      mesh_.element_sets.resize(before.elements);
      mesh_.face_sets.resize(before.faces);
      return {};
    }
    add_mesh();
    say_what_is_left_out(taken);
    warn(!physics.materials.empty());
    physics.joint = std::move(data_.joint);
    return physics;
  }

private:
  struct MeshCounts {
    std::size_t nodes, elements, faces;
  };

  void report(std::vector<InpIssue> complaints) {
    std::stable_sort(
        complaints.begin(), complaints.end(), [](const InpIssue& a, const InpIssue& b) {
          return std::pair(a.place.file, a.place.line) < std::pair(b.place.file, b.place.line);
        });
    for (InpIssue& c : complaints) {
      error(c.place, "E336", c.text, std::move(c.hint));
    }
    if (data_.element.empty() && data_.surface_elements.empty() && sound()) {
      error({}, "E333", "there are no elements");
    }
  }

  [[nodiscard]] bool sound() const { return diagnostics_.error_count() == errors_; }
  void error(InpLocation at, std::string code, const std::string& text, std::string hint = {}) {
    words_.error(at, std::move(code), text, std::move(hint));
  }

  /// Labels of nodes become places in the file's list.
  bool look_up_nodes() {
    node_finder_.emplace(data_.node);
    if (const auto i = find_duplicate(data_.node, node_finder_->index())) {
      error({}, "E304", fmt::format("node {} is defined twice", data_.node[*i]));
      return false;
    }
    place_.reserve(data_.connectivity.size());
    for (std::size_t e = 0; e < data_.element.size(); ++e) {
      for (std::size_t k = data_.first[e]; k < data_.first[e + 1]; ++k) {
        const auto at = node_finder_->index().find(data_.connectivity[k]);
        if (!at) {
          error(data_.element_place[e], "E303",
                fmt::format("element {} has node {}, which is not there", data_.element[e],
                            data_.connectivity[k]));
          return false;
        }
        place_.push_back(*at);
      }
    }
    return true;
  }

  bool look_up_elements() {
    const auto e = find_duplicate(data_.element, LabelIndex(data_.element));
    if (e) {
      error(data_.element_place[*e], "E304",
            fmt::format("element {} is defined twice", data_.element[*e]));
    }
    return !e;
  }

  /// Nodes of no element drop out.
  void number_nodes() {
    std::vector<bool> used(data_.node.size(), false);
    for (const std::size_t place : place_) {
      used[place] = true;
    }
    node_.assign(used.size(), NodeId());
    std::size_t next = mesh_.node_count();
    for (std::size_t i = 0; i < used.size(); ++i) {
      node_[i] = used[i] ? NodeId(next++) : NodeId();
    }
  }

  /// In space, or in the plane z = 0.
  bool plane() {
    dim_ = base::element_info(data_.type[0].type).dim;
    double size = 0.0;
    double height = 0.0;
    for (const std::size_t i : place_) {
      size = std::max(size, data_.x[i].cwiseAbs().maxCoeff());
      height = std::max(height, data_.x[i].tail(3 - dim_).lpNorm<Eigen::Infinity>());
    }
    if (height > 1e-9 * size) {
      error({}, "E335", "the elements do not lie in the plane z = 0");
      return false;
    }
    return true;
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
        nodes.push_back(node_[place_[k]]);
      }
      model::add_element(mesh_, data_.type[e].type, nodes, element_offset + data_.element[e],
                         request_.net);
    }
  }

  void say_what_is_left_out(const InpElementsTaken& taken) {
    for (const InpData::InpElementKind& idle : taken.idle) {
      words_.warning(idle.first, "W466",
                     fmt::format("{} elements of type {} lie on no side of others and are left "
                                 "out, with sets of them",
                                 idle.count, idle.name));
    }
    if (!taken.on_sides.empty()) {
      std::string kinds;
      for (const InpData::InpElementKind& kind : taken.on_sides) {
        kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", kind.count, kind.name);
      }
      words_.warning(taken.on_sides.front().first, "W466",
                     fmt::format("elements that lie on sides of others carry nothing, their sets "
                                 "are taken as surfaces: {}",
                                 kinds));
    }
    for (const InpIssue& remark : data_.remarks) {
      words_.warning(remark.place, "W469", remark.text);
    }
    const InpLeftOutText left = describe_left_out(data_, request_);
    if (!left.of_no_say.empty()) {
      words_.warning({}, "W467",
                     fmt::format("{}: {}",
                                 request_.joint_taken ? "left out"
                                 : request_.skip == InpSkip::all
                                     ? "passed over, as SKIP=ALL asks for"
                                     : "passed over, as SKIP=LOADS asks for",
                                 left.of_no_say));
    }
    if (!left.of_the_model.empty()) {
      words_.warning(
          {}, "W468",
          fmt::format("left out, though the model is another one without: {}", left.of_the_model),
          "spricka convert FILE.inp NEW.deck makes cards of contact, ties, supports and "
          "loads");
    }
  }

  void warn(bool has_moduli) {
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
  std::optional<InpLabelFinder> node_finder_, element_finder_;
  std::vector<std::size_t> place_; ///< [entry of the connectivity] in the file's list of nodes
  std::vector<NodeId> node_;       ///< [place in the file]; none if no element has it
};

} // namespace

ImportedMaterialsAndEquations import_inp(model::Mesh& mesh, const ImportRequest& request,
                                         base::Diagnostics& diagnostics) {
  std::vector<InpIssue> complaints;
  InpData data = read_inp_data(request.file, complaints, request.skip);
  return import_inp_data(mesh, request, std::move(data), std::move(complaints), diagnostics);
}

ImportedMaterialsAndEquations import_inp_data(model::Mesh& mesh, const ImportRequest& request,
                                              InpData data, std::vector<InpIssue> complaints,
                                              base::Diagnostics& diagnostics) {
  return InpImport(mesh, request, std::move(data), diagnostics).run(std::move(complaints));
}

} // namespace spricka::mesh
