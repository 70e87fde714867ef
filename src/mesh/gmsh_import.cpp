// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh_import.hpp"

#include "mesh/gmsh_elements.hpp"
#include "mesh/gmsh_preamble.hpp"
#include "mesh/gmsh_session.hpp"
#include "mesh/numbering.hpp"
#include "mesh/side_index.hpp"
#include "shape/topology.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace spricka::mesh {
namespace {

namespace fs = std::filesystem;
using base::ElementId;
using base::NodeId;
using Tag = std::size_t;

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

struct Group {
  int dim = 0;
  int tag = 0;
  std::string set; ///< qualified name of our set
};

class Import {
public:
  Import(model::Mesh& mesh, const ImportRequest& request, base::Diagnostics& diagnostics)
      : mesh_(mesh), request_(request), diagnostics_(diagnostics) {}

  void run() {
    std::error_code ignored;
    if (!fs::is_regular_file(request_.file, ignored)) {
      error("E330", fmt::format("no file '{}'", request_.file.string()));
      return;
    }
    const GmshSession session;
    if (!load() || !read_groups() || !read_elements()) {
      return;
    }
    add_nodes();
    add_elements();
    add_sets();
  }

private:
  struct Element {
    Tag tag = 0;
    base::ElementType type = base::ElementType::trim3;
    std::vector<Tag> nodes; ///< in our order
    int entity = 0;
    ElementId id;
  };

  void error(std::string code, std::string text, std::string hint = {}) {
    diagnostics_.error(request_.span, std::move(code), std::move(text), std::move(hint));
  }
  bool report_gmsh() {
    const std::vector<std::string> errors = GmshSession::errors();
    for (const std::string& line : errors) {
      error("E331", fmt::format("{}: gmsh says: {}", request_.file.filename().string(), line));
    }
    return errors.empty();
  }

  /// The model with its mesh inside gmsh.
  bool load() {
    if (request_.quadratic) {
      gmsh::option::setNumber("Mesh.ElementOrder", 2);
    }
    try {
      if (request_.format == ImportFormat::geo) {
        const GmshPreamble preamble(request_);
        if (!preamble.complete()) {
          error("E330", "no temporary file could be written for the deck's parameters");
          return false;
        }
        gmsh::open(preamble.path());
      } else {
        gmsh::open(request_.file.string());
      }
      if (!report_gmsh()) {
        return false;
      }
      mesh_if_needed();
    } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
      if (report_gmsh()) {
        error("E331", fmt::format("{}: gmsh gave up", request_.file.filename().string()));
      }
      return false;
    }
    return report_gmsh();
  }

  void mesh_if_needed() {
    dim_ = 0;
    std::vector<int> types;
    const auto find_dim = [&] {
      for (int d = 3; d >= 2 && dim_ == 0; --d) {
        gmsh::model::mesh::getElementTypes(types, d);
        dim_ = types.empty() ? 0 : d;
      }
    };
    find_dim();
    if (dim_ == 0 && request_.format == ImportFormat::geo) {
      gmsh::model::mesh::generate(std::max(2, gmsh::model::getDimension()));
      find_dim();
    }
    const bool linear = std::any_of(types.begin(), types.end(), [](int number) {
      const auto known = from_gmsh(number);
      return known && !base::info(known->type).quadratic;
    });
    if (request_.quadratic && linear) {
      gmsh::model::mesh::setOrder(2);
    }
  }

  bool read_groups() {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups);
    std::vector<bool> used(request_.renames.size(), false);
    std::vector<std::string> names;
    for (const auto& [dim, tag] : groups) {
      std::string name;
      gmsh::model::getPhysicalName(dim, tag, name);
      if (name.empty()) {
        name = fmt::format("GROUP{}", tag);
      }
      names.push_back(name);
      std::string set = upper(name);
      std::replace(set.begin(), set.end(), ' ', '_');
      for (std::size_t i = 0; i < used.size(); ++i) {
        if (upper(request_.renames[i].first) == upper(name)) {
          set = request_.renames[i].second;
          used[i] = true;
        }
      }
      groups_.push_back({dim, tag, request_.prefix + set});
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) {
        error("E332",
              fmt::format("no physical group '{}' in {}", request_.renames[i].first,
                          request_.file.filename().string()),
              base::suggest(request_.renames[i].first, names));
      }
    }
    return std::all_of(used.begin(), used.end(), [](bool b) { return b; });
  }

  std::vector<int> entities(const Group& group) const {
    std::vector<int> result;
    gmsh::model::getEntitiesForPhysicalGroup(group.dim, group.tag, result);
    return result;
  }

  /// Elements of the mesh's own dimension: those in physical groups if there are such groups, as
  /// gmsh itself saves a mesh, else all.
  bool read_elements() {
    std::set<int> wanted;
    for (const Group& group : groups_) {
      if (group.dim == dim_) {
        const std::vector<int> members = entities(group);
        wanted.insert(members.begin(), members.end());
      }
    }
    gmsh::vectorpair all;
    gmsh::model::getEntities(all, dim_ > 0 ? dim_ : 2);
    for (const auto& [dim, tag] : all) {
      if ((wanted.empty() || wanted.contains(tag)) && !read_entity(tag)) {
        return false;
      }
    }
    if (elements_.empty()) {
      error("E333", fmt::format("{} has no elements", request_.file.filename().string()),
            "a surface or volume must be defined and meshed");
      return false;
    }
    std::sort(elements_.begin(), elements_.end(),
              [](const Element& a, const Element& b) { return a.tag < b.tag; });
    return true;
  }

  bool read_entity(int entity) {
    std::vector<int> types;
    std::vector<std::vector<Tag>> tags;
    std::vector<std::vector<Tag>> nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dim_, entity);
    for (std::size_t t = 0; t < types.size(); ++t) {
      const auto known = from_gmsh(types[t]);
      if (!known) {
        std::string name;
        int dim = 0;
        int order = 0;
        int count = 0;
        int primary = 0;
        std::vector<double> local;
        gmsh::model::mesh::getElementProperties(types[t], name, dim, order, count, local, primary);
        error("E334", fmt::format("{}: elements of gmsh's type '{}' are not known",
                                  request_.file.filename().string(), name));
        return false;
      }
      const auto count = static_cast<std::size_t>(base::info(known->type).nodes);
      for (std::size_t e = 0; e < tags[t].size(); ++e) {
        Element element{tags[t][e], known->type, {}, entity, {}};
        for (std::size_t i = 0; i < count; ++i) {
          const std::size_t at =
              known->order.empty() ? i : static_cast<std::size_t>(known->order[i]);
          element.nodes.push_back(nodes[t][e * count + at]);
        }
        elements_.push_back(std::move(element));
      }
    }
    return true;
  }

  void add_nodes() {
    std::vector<Tag> tags;
    std::vector<double> x;
    std::vector<double> parametric;
    gmsh::model::mesh::getNodes(tags, x, parametric);
    std::map<Tag, base::Vec3> needed;
    for (const Element& element : elements_) {
      for (const Tag n : element.nodes) {
        needed[n];
      }
    }
    double size = 0.0;
    double height = 0.0;
    for (std::size_t i = 0; i < tags.size(); ++i) {
      const auto at = needed.find(tags[i]);
      if (at != needed.end()) {
        at->second = request_.scale * base::Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
        size = std::max(size, at->second.cwiseAbs().maxCoeff());
        height = std::max(height, std::abs(at->second.z()));
      }
    }
    if (dim_ == 2 && height > 1e-9 * size) {
      error("E335",
            fmt::format("{} does not lie in the plane z = 0", request_.file.filename().string()));
    }
    const base::Label offset = next_node_label(mesh_, request_.net) - 1;
    for (auto& [tag, at] : needed) {
      if (dim_ == 2) {
        at.z() = 0.0;
      }
      node_[tag] = model::add_node(mesh_, at, offset + static_cast<base::Label>(tag), request_.net);
    }
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
    mesh_.dim = std::max(mesh_.dim, dim_);
    const base::Label offset = next_element_label(mesh_, request_.net) - 1;
    for (Element& element : elements_) {
      std::vector<NodeId> nodes;
      for (const Tag tag : element.nodes) {
        nodes.push_back(node_.at(tag));
      }
      if (dim_ == 2 && runs_clockwise(nodes, base::info(element.type).corners)) {
        const std::vector<NodeId> old = nodes;
        const std::span<const int> order = turned_over(element.type);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          nodes[i] = old[static_cast<std::size_t>(order[i])];
        }
      }
      const auto number = static_cast<base::Label>(element.tag - elements_.front().tag + 1);
      element.id = model::add_element(mesh_, element.type, nodes, offset + number, request_.net);
    }
  }

  void add_sets() {
    const SideIndex sides(mesh_, elements_.front().id.index());
    for (const Group& group : groups_) {
      const std::vector<int> members = entities(group);
      if (group.dim == dim_) {
        model::ElementSet set{group.set, {}, request_.span};
        for (const Element& element : elements_) {
          if (std::find(members.begin(), members.end(), element.entity) != members.end()) {
            set.elements.push_back(element.id);
          }
        }
        mesh_.element_sets.push_back(std::move(set));
      } else if (group.dim == dim_ - 1) {
        add_face_set(group, members, sides);
      } else {
        add_node_set(group);
      }
    }
  }

  void add_node_set(const Group& group) {
    std::vector<Tag> tags;
    std::vector<double> x;
    gmsh::model::mesh::getNodesForPhysicalGroup(group.dim, group.tag, tags, x);
    std::set<NodeId> nodes;
    for (const Tag tag : tags) {
      if (const auto at = node_.find(tag); at != node_.end()) {
        nodes.insert(at->second);
      }
    }
    mesh_.node_sets.push_back({group.set, {nodes.begin(), nodes.end()}, request_.span});
  }

  /// The side with these corners. Between two elements it is that of the element on the left of the
  /// group's own direction.
  [[nodiscard]] std::optional<model::Face> side_on(const SideIndex& sides,
                                                   const std::vector<NodeId>& corners) const {
    const std::span<const model::Face> found = sides.find(corners);
    if (found.empty()) {
      return std::nullopt;
    }
    for (const model::Face& face : found) {
      const auto nodes = mesh_.nodes_of(face.element);
      const auto local = shape::side_nodes(mesh_.type[face.element.index()], face.side);
      if (dim_ == 2 && nodes[static_cast<std::size_t>(local[0])] == corners[0]) {
        return face;
      }
    }
    return found.front();
  }

  void add_face_set(const Group& group, const std::vector<int>& members, const SideIndex& sides) {
    model::FaceSet set{group.set, {}, request_.span};
    for (const int entity : members) {
      std::vector<int> types;
      std::vector<std::vector<Tag>> tags;
      std::vector<std::vector<Tag>> nodes;
      gmsh::model::mesh::getElements(types, tags, nodes, group.dim, entity);
      for (std::size_t t = 0; t < types.size(); ++t) {
        const std::size_t count = tags[t].empty() ? 1 : nodes[t].size() / tags[t].size();
        const auto known = from_gmsh(types[t]);
        const auto corners = static_cast<std::size_t>(known ? base::info(known->type).corners : 2);
        for (std::size_t e = 0; e < tags[t].size(); ++e) {
          std::vector<NodeId> key;
          for (std::size_t i = 0; i < corners; ++i) {
            const auto at = node_.find(nodes[t][e * count + i]);
            key.push_back(at == node_.end() ? NodeId() : at->second);
          }
          if (const auto face = side_on(sides, key)) {
            set.faces.push_back(*face);
          }
        }
      }
    }
    mesh_.face_sets.push_back(std::move(set));
  }

  model::Mesh& mesh_;
  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  int dim_ = 0;
  std::vector<Group> groups_;
  std::vector<Element> elements_;
  std::unordered_map<Tag, NodeId> node_;
};

} // namespace

void import_mesh(model::Mesh& mesh, const ImportRequest& request, base::Diagnostics& diagnostics) {
  Import(mesh, request, diagnostics).run();
}

} // namespace spricka::mesh
