// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/gmsh_import.hpp"

#include "base/label.hpp"
#include "mesh/gmsh_elements.hpp"
#include "mesh/import/gmsh_groups.hpp"
#include "mesh/import/gmsh_read.hpp"
#include "mesh/import/mesher_file.hpp"
#include "mesh/numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <unordered_map>

namespace spricka::mesh {
namespace {

namespace fs = std::filesystem;
using base::ElementId;
using base::NodeId;
using Tag = std::size_t;

class GmshImport {
public:
  GmshImport(model::Mesh& mesh, const ImportRequest& request, base::Diagnostics& diagnostics)
      : mesh_(mesh), request_(request), diagnostics_(diagnostics) {}

  std::vector<GeometryScriptConstant> run() {
    std::error_code ignored;
    if (!fs::is_regular_file(request_.file, ignored)) {
      error("E330", fmt::format("no file '{}'", request_.file.string()));
      return {};
    }
    GmshReadResult reading = read_by_gmsh(request_, diagnostics_);
    if (reading.model) {
      from_ = *std::move(reading.model);
      numbers_.dim = from_.dim;
      if (name_gmsh_sets(request_, diagnostics_, from_.groups)) {
        append();
      }
    }
    return std::move(reading.constants);
  }

private:
  /// Elements as gmsh has them, but their nodes in our order.
  struct GmshElementTable {
    std::vector<Tag> tag;
    std::vector<base::ElementType> type;
    std::vector<int> entity;
    std::vector<std::size_t> first; ///< [element] into `nodes`
    std::vector<Tag> nodes;
  };

  void error(std::string code, std::string text, std::string hint = {}) {
    diagnostics_.error(request_.span, std::move(code), std::move(text), std::move(hint));
  }
  [[nodiscard]] std::string file_name() const { return request_.file.filename().string(); }

  void append() {
    if (!read_elements() || !add_nodes()) {
      return;
    }
    add_elements();
    add_gmsh_sets(mesh_, request_, from_, numbers_, diagnostics_);
    if (request_.format == ImportFormat::step) { // said before such elements are mended
      std::erase_if(from_.warnings, [](const std::string& words) {
        return words.starts_with("Volume mesh: worst distortion");
      });
    }
    MesherFile(request_, diagnostics_).report_gmsh_warnings(from_.warnings);
  }

  /// Elements of the mesh's own dimension: those in physical groups if there are such groups, as
  /// gmsh itself saves a mesh, else all.
  bool read_elements() {
    std::set<int> wanted;
    for (const GmshPhysicalGroup& group : from_.groups) {
      if (group.dim == numbers_.dim) {
        wanted.insert(group.entities.begin(), group.entities.end());
      }
    }
    for (const GmshElementBlock& block : from_.elements) {
      if ((wanted.empty() || wanted.contains(block.entity)) && !read_block(block)) {
        return false;
      }
    }
    if (elements_.tag.empty()) {
      error("E333", fmt::format("{} has no elements", file_name()),
            "a surface or volume must be defined and meshed");
      return false;
    }
    order_.resize(elements_.tag.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t i, std::size_t j) { return elements_.tag[i] < elements_.tag[j]; });
    return true;
  }

  bool read_block(const GmshElementBlock& block) {
    const auto known = find_gmsh_element_type(block.type);
    if (!known) {
      error("E334", fmt::format("{}: elements of gmsh's type '{}' are not known", file_name(),
                                block.type_name));
      return false;
    }
    const auto count = static_cast<std::size_t>(base::element_info(known->type).nodes);
    for (std::size_t e = 0; e < block.tags.size(); ++e) {
      if (block.tags[e] > static_cast<Tag>(base::largest_label)) {
        error("E331", fmt::format("{}: element number {} has more than 18 digits", file_name(),
                                  block.tags[e]));
        return false;
      }
      elements_.tag.push_back(block.tags[e]);
      elements_.type.push_back(known->type);
      elements_.entity.push_back(block.entity);
      elements_.first.push_back(elements_.nodes.size());
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = known->order.empty() ? i : static_cast<std::size_t>(known->order[i]);
        elements_.nodes.push_back(block.nodes[e * count + at]);
      }
    }
    return true;
  }

  bool add_nodes() {
    const std::vector<Tag>& tags = from_.node_tags;
    const std::vector<double>& x = from_.x;
    numbers_.tags.emplace(tags);
    numbers_.node.assign(tags.size(), NodeId());
    std::vector<std::size_t> needed; // places in `tags`, ascending by tag
    std::vector<bool> met(tags.size(), false);
    for (const Tag tag : elements_.nodes) {
      const auto at = numbers_.tags->find(tag);
      if (!at) {
        error("E331",
              fmt::format("{}: an element has node {}, which is not there", file_name(), tag));
        return false;
      }
      if (tag > static_cast<Tag>(base::largest_label)) {
        error("E331", fmt::format("{}: node number {} has more than 18 digits", file_name(), tag));
        return false;
      }
      if (!met[*at]) {
        met[*at] = true;
        needed.push_back(*at);
      }
    }
    std::sort(needed.begin(), needed.end(),
              [&](std::size_t i, std::size_t j) { return tags[i] < tags[j]; });
    const base::Label offset = next_node_label(mesh_, request_.net) - 1;
    double size = 0.0;
    double height = 0.0;
    for (const std::size_t i : needed) {
      base::Vec3 at = request_.scale * base::Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      size = std::max(size, at.cwiseAbs().maxCoeff());
      auto across = at.tail(3 - numbers_.dim); // the plane, if the mesh lies in it
      height = std::max(height, across.lpNorm<Eigen::Infinity>());
      across.setZero();
      numbers_.node[i] =
          model::add_node(mesh_, at, offset + static_cast<base::Label>(tags[i]), request_.net);
    }
    if (height > 1e-9 * size) {
      error("E335", fmt::format("{} does not lie in the plane z = 0", file_name()));
    }
    return true;
  }

  [[nodiscard]] bool runs_clockwise(const std::vector<NodeId>& nodes, int corners) const {
    double twice_area = 0.0;
    for (int i = 0; i < corners; ++i) {
      const base::Vec3& a = mesh_.x[nodes[static_cast<std::size_t>(i)].index()];
      const base::Vec3& b = mesh_.x[nodes[static_cast<std::size_t>((i + 1) % corners)].index()];
      twice_area += a.x() * b.y() - b.x() * a.y();
    }
    return twice_area < 0.0;
  }

  void add_elements() {
    mesh_.dim = std::max(mesh_.dim, numbers_.dim);
    numbers_.entity.reserve(order_.size());
    const base::Label offset = next_element_label(mesh_, request_.net) - 1;
    numbers_.first_element = mesh_.element_count();
    const Tag lowest = elements_.tag[order_.front()];
    std::vector<NodeId> nodes;
    for (const std::size_t e : order_) {
      const base::ElementInfo& info = base::element_info(elements_.type[e]);
      nodes.clear();
      for (int i = 0; i < info.nodes; ++i) {
        nodes.push_back(numbers_.node_with_tag(
            elements_.nodes[elements_.first[e] + static_cast<std::size_t>(i)]));
      }
      const std::span<const int> over = reversed_node_order(elements_.type[e]);
      if (!over.empty() && runs_clockwise(nodes, info.corners)) {
        const std::vector<NodeId> before = nodes;
        std::transform(over.begin(), over.end(), nodes.begin(),
                       [&](int i) { return before[static_cast<std::size_t>(i)]; });
      }
      if (const ElementId twin = met_before(nodes); twin.valid()) {
        numbers_.also.emplace_back(twin, elements_.entity[e]);
        continue;
      }
      const auto number = static_cast<base::Label>(elements_.tag[e] - lowest + 1);
      numbers_.entity.push_back(elements_.entity[e]);
      model::add_element(mesh_, elements_.type[e], nodes, offset + number, request_.net);
    }
  }

  /// The element with these nodes in this order, if a file has it already; else notes it.
  ElementId met_before(const std::vector<NodeId>& nodes) {
    if (request_.format != ImportFormat::msh) {
      return {};
    }
    std::uint64_t hash = 14695981039346656037U; // FNV-1a
    for (const NodeId n : nodes) {
      hash = (hash ^ static_cast<std::uint64_t>(n.value)) * 1099511628211U;
    }
    const auto [at, fresh] = met_.try_emplace(hash, mesh_.element_count());
    const std::span<const NodeId> before =
        fresh ? std::span<const NodeId>() : mesh_.element_nodes(at->second);
    return std::equal(nodes.begin(), nodes.end(), before.begin(), before.end()) ? at->second
                                                                                : ElementId();
  }

  model::Mesh& mesh_;
  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  GmshModel from_;
  GmshElementTable elements_;
  std::vector<std::size_t> order_;                   ///< elements by ascending tag
  std::unordered_map<std::uint64_t, ElementId> met_; ///< by a hash of the nodes
  GmshNumbering numbers_;
};

} // namespace

std::vector<GeometryScriptConstant> import_gmsh_mesh_or_script(model::Mesh& mesh,
                                                               const ImportRequest& request,
                                                               base::Diagnostics& diagnostics) {
  return GmshImport(mesh, request, diagnostics).run();
}

} // namespace spricka::mesh
