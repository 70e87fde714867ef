// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/gmsh_groups.hpp"

#include "mesh/gmsh_elements.hpp"
#include "mesh/set_name.hpp"
#include "mesh/side_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_set>

namespace spricka::mesh {
namespace {

using base::NodeId;
using Tag = std::size_t;

class Sets {
public:
  Sets(model::Mesh& mesh, const ImportRequest& request, const GmshNumbering& numbers,
       base::Diagnostics& diagnostics)
      : mesh_(mesh), request_(request), numbers_(numbers), diagnostics_(diagnostics) {}

  void add(const GmshModel& from) {
    const SideIndex sides(mesh_, numbers_.first_element);
    for (const GmshPhysicalGroup& group : from.groups) {
      const std::vector<int>& members = group.entities;
      if (group.dim == numbers_.dim) {
        model::ElementSet set{group.set, {}, request_.span};
        const std::unordered_set<int> wanted(members.begin(), members.end());
        for (std::size_t i = 0; i < numbers_.entity.size(); ++i) {
          if (wanted.contains(numbers_.entity[i])) {
            set.elements.emplace_back(numbers_.first_element + i);
          }
        }
        for (const auto& [element, entity] : numbers_.also) {
          if (wanted.contains(entity)) {
            set.elements.push_back(element);
          }
        }
        std::sort(set.elements.begin(), set.elements.end());
        set.elements.erase(std::unique(set.elements.begin(), set.elements.end()),
                           set.elements.end());
        mesh_.element_sets.push_back(std::move(set));
      } else if (group.dim == numbers_.dim - 1) {
        add_face_set(group, from.sides, sides);
      } else {
        add_node_set(group);
      }
    }
  }

private:
  void add_node_set(const GmshPhysicalGroup& group) {
    std::set<NodeId> nodes;
    for (const Tag tag : group.nodes) {
      if (const NodeId node = numbers_.node_with_tag(tag); node.valid()) {
        nodes.insert(node);
      }
    }
    mesh_.node_sets.push_back({group.set, {nodes.begin(), nodes.end()}, request_.span});
  }

  void add_face_set(const GmshPhysicalGroup& group, const std::vector<GmshElementBlock>& blocks,
                    const SideIndex& sides) {
    model::FaceSet set{group.set, {}, request_.span};
    std::size_t strange = 0;
    for (const int entity : group.entities) {
      for (const GmshElementBlock& block : blocks) {
        if (block.entity == entity) {
          add_faces(block, sides, set, strange);
        }
      }
    }
    std::set<model::Face> met; // as elements, faces may stand in the file twice
    std::erase_if(set.faces, [&](const model::Face& face) { return !met.insert(face).second; });
    if (strange > 0) {
      diagnostics_.warning(request_.span, "W332",
                           fmt::format("{}: {} of {} faces of {} are no side of an element",
                                       request_.file.filename().string(), strange,
                                       strange + set.faces.size(), group.set));
    }
    mesh_.face_sets.push_back(std::move(set));
  }

  void add_faces(const GmshElementBlock& block, const SideIndex& sides, model::FaceSet& set,
                 std::size_t& strange) const {
    const std::size_t count = block.tags.empty() ? 1 : block.nodes.size() / block.tags.size();
    const auto known = find_gmsh_element_type(block.type);
    const auto corners =
        static_cast<std::size_t>(known ? base::element_info(known->type).corners : 2);
    for (std::size_t e = 0; e < block.tags.size(); ++e) {
      std::vector<NodeId> key;
      for (std::size_t i = 0; i < std::min(corners, count); ++i) {
        key.push_back(numbers_.node_with_tag(block.nodes[e * count + i]));
      }
      const auto face = key.size() < 2 ? std::nullopt : find_side_below(mesh_, sides, key);
      if (face) {
        set.faces.push_back(*face);
      } else {
        ++strange;
      }
    }
  }

  model::Mesh& mesh_;
  const ImportRequest& request_;
  const GmshNumbering& numbers_;
  base::Diagnostics& diagnostics_;
};

} // namespace

bool name_gmsh_sets(const ImportRequest& request, base::Diagnostics& diagnostics,
                    std::vector<GmshPhysicalGroup>& groups) {
  std::vector<bool> used(request.renames.size(), false);
  std::vector<std::string> names;
  for (GmshPhysicalGroup& group : groups) {
    const std::string name = group.name.empty() ? fmt::format("GROUP{}", group.tag) : group.name;
    names.push_back(name);
    std::string set = make_valid_set_name(name);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (upper_case(request.renames[i].first) == upper_case(name)) {
        set = request.renames[i].second;
        used[i] = true;
      }
    }
    group.set = request.prefix + set;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) {
      diagnostics.error(request.span, "E332",
                        fmt::format("no physical group '{}' in {}", request.renames[i].first,
                                    request.file.filename().string()),
                        base::make_spelling_hint(request.renames[i].first, names));
    }
  }
  return std::all_of(used.begin(), used.end(), [](bool b) { return b; });
}

void add_gmsh_sets(model::Mesh& mesh, const ImportRequest& request, const GmshModel& from,
                   const GmshNumbering& numbers, base::Diagnostics& diagnostics) {
  Sets(mesh, request, numbers, diagnostics).add(from);
}

} // namespace spricka::mesh
