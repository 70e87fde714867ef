// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/graft.hpp"

#include "geometry/box_tree.hpp"
#include "geometry/triangle.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/numbering.hpp"
#include "mesh/side_index.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

/// Nodes of the sides in the place of one: of edges along them, of faces ascending.
std::vector<NodeId> nodes_in_order(const model::Mesh& mesh, const std::vector<model::Face>& sides) {
  std::vector<NodeId> nodes;
  for (const model::Face& side : sides) {
    const FaceNodes own = face_nodes(mesh, side);
    if (own.corners > 2) {
      return nodes_of_faces(mesh, sides);
    }
    nodes.insert(nodes.end(), {own.all[0], own.mid_node(0), own.all[1]});
  }
  return nodes;
}

class Grafter {
public:
  Grafter(const model::Mesh& host, std::span<const PatchGraft> grafts)
      : host_(host), grafts_(grafts), placed_(grafts.size()), kept_(host.element_count()),
        used_(host.node_count(), false) {}

  GraftedMesh graft() {
    add_nodes();
    keep_elements();
    add_elements();
    inherit_element_sets();
    find_new_faces();
    inherit_face_sets();
    inherit_node_sets();
    return {std::move(result_), std::move(placed_)};
  }

private:
  [[nodiscard]] base::NetId net_of(const PatchGraft& graft) const {
    return host_.element_net[graft.removed.front().index()];
  }

  void add_nodes() {
    model::Mesh& mesh = result_.mesh;
    mesh.dim = host_.dim;
    // All host nodes stay, also those that no element will have: numbers keep their meaning.
    mesh.x = host_.x;
    mesh.node_label = host_.node_label;
    mesh.node_net = host_.node_net;
    for (std::size_t g = 0; g < grafts_.size(); ++g) {
      const base::NetId net = net_of(grafts_[g]);
      base::Label label = next_node_label(mesh, net);
      for (const PatchNode& node : grafts_[g].patch.nodes) {
        placed_[g].node.push_back(node.host.valid() ? node.host
                                                    : model::add_node(mesh, node.x, label++, net));
      }
    }
  }

  void keep_elements() {
    std::vector<bool> removed(host_.element_count(), false);
    for (const PatchGraft& g : grafts_) {
      for (const ElementId e : g.removed) {
        removed[e.index()] = true;
      }
    }
    for (std::size_t e = 0; e < host_.element_count(); ++e) {
      if (!removed[e]) {
        kept_[e] = add(ElementId(e), host_.type[e], host_.element_nodes(ElementId(e)),
                       host_.element_label[e]);
        result_.host.emplace_back(e);
      }
    }
    first_new_ = result_.mesh.element_count();
  }

  ElementId add(ElementId like, base::ElementType type, std::span<const NodeId> nodes,
                base::Label label) {
    const ElementId e =
        model::add_element(result_.mesh, type, nodes, label, host_.element_net[like.index()]);
    result_.mesh.property[e.index()] = host_.property[like.index()];
    for (const NodeId n : nodes) {
      if (n.index() < used_.size()) {
        used_[n.index()] = true;
      }
    }
    return e;
  }

  void add_elements() {
    for (std::size_t g = 0; g < grafts_.size(); ++g) {
      const Patch& patch = grafts_[g].patch;
      const base::NetId net = net_of(grafts_[g]);
      // Labels of elements that were cut out are not given anew.
      base::Label label =
          std::max(next_element_label(host_, net), next_element_label(result_.mesh, net));
      for (const PatchElement& element : patch.elements) {
        std::vector<NodeId> nodes;
        PatchNode middle;
        const auto corners = static_cast<std::size_t>(base::element_info(element.type).corners);
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
          nodes.push_back(placed_[g].node_in_mesh(element.nodes[i]));
          if (i < corners) {
            const PatchNode& corner = patch.nodes[static_cast<std::size_t>(element.nodes[i])];
            middle.x += corner.x / static_cast<double>(corners);
            middle.local += corner.local / static_cast<double>(corners);
          }
        }
        const ElementId parent = grafts_[g].parent(middle);
        placed_[g].element.push_back(add(parent, element.type, nodes, label++));
        parent_.emplace_back(placed_[g].element.back(), parent);
        result_.host.emplace_back();
      }
    }
  }

  void inherit_element_sets() {
    for (const model::ElementSet& old : host_.element_sets) {
      model::ElementSet set{old.name, {}, old.span};
      const std::vector<bool> member = model::mark_members(host_.element_count(), old.elements);
      for (const ElementId e : old.elements) {
        if (kept_[e.index()].valid()) {
          set.elements.push_back(kept_[e.index()]);
        }
      }
      for (const auto& [e, parent] : parent_) {
        if (member[parent.index()]) {
          set.elements.push_back(e);
        }
      }
      result_.mesh.element_sets.push_back(std::move(set));
    }
  }

  /// New sides in the place of those of removed elements.
  void find_new_faces() {
    const SideIndex sides(result_.mesh, first_new_);
    for (std::size_t g = 0; g < grafts_.size(); ++g) {
      for (const auto& [face, pieces] : grafts_[g].patch.faces) {
        std::vector<model::Face>& sides_there = faces_[face];
        for (const std::vector<int>& piece : pieces) {
          std::vector<NodeId> corners;
          std::ranges::transform(piece, std::back_inserter(corners),
                                 [&](int n) { return placed_[g].node_in_mesh(n); });
          // Not those of the patch of a neighbour, which may have the same nodes.
          std::ranges::copy_if(sides.find(corners), std::back_inserter(sides_there),
                               [&](const model::Face& side) {
                                 return placed_[g].element.front() <= side.element &&
                                        side.element <= placed_[g].element.back();
                               });
        }
      }
    }
  }

  void inherit_face_sets() {
    for (const model::FaceSet& old : host_.face_sets) {
      model::FaceSet set{old.name, {}, old.span};
      for (const model::Face& face : old.faces) {
        if (const ElementId e = kept_[face.element.index()]; e.valid()) {
          set.faces.push_back({e, face.side});
        } else if (const auto at = faces_.find(face); at != faces_.end()) {
          set.faces.insert(set.faces.end(), at->second.begin(), at->second.end());
        }
      }
      result_.mesh.face_sets.push_back(std::move(set));
    }
  }

  void inherit_node_sets() {
    const std::vector<bool> had = model::mark_nodes_in_use(host_);
    for (const model::NodeSet& old : host_.node_sets) {
      NodeSetHeir heir(*this, old);
      for (const NodeId n : old.nodes) {
        // Nodes without an element in the host were taken by no cavity.
        if (used_[n.index()] || !had[n.index()]) {
          heir.set.nodes.push_back(n);
        }
      }
      heir.replace_faces();
      for (std::size_t g = 0; g < grafts_.size(); ++g) {
        heir.replace_held_edges(g);
        heir.replace_cavity(g);
      }
      std::vector<NodeId>& removed = result_.unreplaced_set_nodes.emplace_back();
      std::ranges::copy_if(old.nodes, std::back_inserter(removed), [&](NodeId n) {
        return had[n.index()] && !used_[n.index()] && !heir.replaced[n.index()];
      });
      leave_covered(heir.member, removed);
      result_.mesh.node_sets.push_back(std::move(heir.set));
    }
  }

  /// What becomes of one node set. Whether an edge, a side or a cavity was in it is asked of the
  /// set as it was: nodes that join must not bring others in.
  struct NodeSetHeir {
    NodeSetHeir(const Grafter& of, const model::NodeSet& old)
        : grafter(of), set{old.name, {}, old.span},
          member(model::mark_members(of.result_.mesh.node_count(), old.nodes)), old_member(member),
          replaced(of.host_.node_count(), false) {}

    void join(NodeId n) {
      if (!member[n.index()]) {
        member[n.index()] = true;
        set.nodes.push_back(n);
      }
    }

    void replace_faces() {
      for (const auto& [face, pieces] : grafter.faces_) {
        if (face_has_all_nodes_inside(grafter.host_, face, old_member)) {
          for (const NodeId n : nodes_in_order(grafter.result_.mesh, pieces)) {
            join(n);
          }
          for (const NodeId n : nodes_of_faces(grafter.host_, {face})) {
            replaced[n.index()] = true;
          }
        }
      }
    }

    void replace_held_edges(std::size_t g) {
      for (const HeldSetEdgeReplacement& edge : grafter.grafts_[g].patch.edges) {
        if (!std::ranges::all_of(edge.host,
                                 [&](NodeId n) { return !n.valid() || old_member[n.index()]; })) {
          continue;
        }
        for (const int n : edge.ends) {
          join(grafter.placed_[g].node_in_mesh(n));
        }
        if (edge.mid >= 0) {
          join(grafter.placed_[g].node_in_mesh(edge.mid));
        }
        for (const NodeId n : edge.host) {
          if (n.valid()) {
            replaced[n.index()] = true;
          }
        }
      }
    }

    /// A set that has all nodes of a cavity has all of the patch.
    void replace_cavity(std::size_t g) {
      const std::vector<ElementId>& removed = grafter.grafts_[g].removed;
      const bool covers = std::ranges::all_of(removed, [&](ElementId e) {
        return std::ranges::all_of(grafter.host_.element_nodes(e),
                                   [&](NodeId n) { return old_member[n.index()]; });
      });
      if (!covers) {
        return;
      }
      for (const NodeId n : grafter.placed_[g].node) {
        join(n);
      }
      for (const ElementId e : removed) {
        for (const NodeId n : grafter.host_.element_nodes(e)) {
          replaced[n.index()] = true;
        }
      }
    }

    const Grafter& grafter;
    model::NodeSet set;
    std::vector<bool> member;     ///< [node of the result]
    std::vector<bool> old_member; ///< the same, of the set as it was
    std::vector<bool> replaced;   ///< [host node] others have come in its place
  };

  /// Where new faces are larger than the host's some of these have none in their place: of a set's
  /// removed nodes those stay for which no new face that is all in the set covers the place.
  void leave_covered(const std::vector<bool>& member, std::vector<NodeId>& removed) const {
    if (removed.empty()) {
      return;
    }
    using Corners = std::array<base::Vec3, 3>;
    std::vector<Corners> triangles;
    std::vector<geometry::Box<3>> boxes;
    for (const auto& [face, pieces] : faces_) {
      for (const model::Face& piece : pieces) {
        if (face_has_all_nodes_inside(result_.mesh, piece, member)) {
          const FaceNodes nodes = face_nodes(result_.mesh, piece);
          const auto x = [&](std::size_t i) { return result_.mesh.x[nodes.all[i].index()]; };
          for (std::size_t i = 2; i < nodes.corners; ++i) {
            triangles.push_back({x(0), x(i - 1), x(i)});
            boxes.push_back(geometry::Box<3>::around(triangles.back()));
          }
        }
      }
    }
    constexpr double off_chord = 0.1; // of an edge: where the surface is curved
    const geometry::BoxTree<3> tree(boxes);
    std::erase_if(removed, [&](NodeId n) {
      const base::Vec3& x = host_.x[n.index()];
      const auto distance = [&](std::size_t t) {
        return (geometry::nearest_point(x, triangles[t]).x - x).norm();
      };
      const auto t = tree.nearest(x, distance);
      return t && distance(*t) <= off_chord * (triangles[*t][1] - triangles[*t][0]).norm();
    });
  }

  const model::Mesh& host_;
  std::span<const PatchGraft> grafts_;
  CrackedMesh result_;
  std::vector<GraftedPatch> placed_; ///< [graft]
  std::size_t first_new_ = 0;
  std::vector<ElementId> kept_;                         ///< [host element] its new number
  std::vector<bool> used_;                              ///< [host node] by an element of the result
  std::vector<std::pair<ElementId, ElementId>> parent_; ///< new element, host element it lies in
  std::map<model::Face, std::vector<model::Face>> faces_; ///< [side of the host] new ones there
};

} // namespace

GraftedMesh graft_patches(const model::Mesh& host, std::span<const PatchGraft> grafts) {
  return Grafter(host, grafts).graft();
}

void add_patch_ties(const Patch& patch, const GraftedPatch& placed, base::CrackId crack,
                    CrackedMesh& cracked) {
  for (const PatchTie& tie : patch.ties) {
    HangingNodeTie& made = cracked.ties.emplace_back();
    made.slave = placed.node_in_mesh(tie.slave);
    std::ranges::transform(tie.master, std::back_inserter(made.master),
                           [&](int n) { return placed.node_in_mesh(n); });
    made.weight = tie.weight;
    made.crack = crack;
  }
}

namespace {

// Sides whose nodes follow one another along a crack face. Sides run with their body on the left:
// along the left crack face they go towards the tip, along the right crack face away from it.
std::vector<model::Face> along(const model::Mesh& mesh, const std::vector<NodeId>& crack_face,
                               bool left) {
  std::map<NodeId, std::size_t> place;
  for (std::size_t i = 0; i < crack_face.size(); ++i) {
    place.emplace(crack_face[i], i);
  }
  std::vector<std::pair<std::size_t, model::Face>> found;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId element(e);
    if (std::ranges::count_if(mesh.element_nodes(element),
                              [&](NodeId n) { return place.contains(n); }) < 2) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, {element, s});
      const auto from = place.find(left ? edge.a : edge.b);
      const auto to = place.find(left ? edge.b : edge.a);
      if (from == place.end() || to == place.end()) {
        continue;
      }
      // Both ends alone do not tell: the middle node must lie on the same face.
      const std::size_t step = edge.mid.valid() ? 2 : 1;
      if (to->second == from->second + step &&
          (step == 1 || crack_face[from->second + 1] == edge.mid)) {
        found.emplace_back(from->second, model::Face{element, s});
      }
    }
  }
  std::ranges::sort(found);
  std::vector<model::Face> faces;
  faces.reserve(found.size());
  for (const auto& [at, face] : found) {
    faces.push_back(face);
  }
  return faces;
}

} // namespace

CrackFaceSides crack_face_sides(const model::Mesh& mesh, const CrackFaceNodes& crack_faces) {
  if (crack_faces.has_sides()) {
    return {crack_faces.left_sides, crack_faces.right_sides};
  }
  return {along(mesh, crack_faces.left, true), along(mesh, crack_faces.right, false)};
}

} // namespace spricka::mesh
