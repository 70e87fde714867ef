// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_graft.hpp"

#include "mesh/boundary.hpp"
#include "mesh/numbering.hpp"
#include "mesh/side_index.hpp"
#include "mesh/surface/triangle_tree.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec3;

/// Finds the element of a cavity that a place lies in, or comes nearest to.
class ParentFinder {
public:
  ParentFinder(const SolidHost& host, const SolidCavity& cavity)
      : host_(host), elements_(cavity.elements) {
    // Where all of them are in the same sets, whatever is of some is of all.
    const model::Mesh& mesh = host.mesh();
    std::vector<bool> mine(mesh.element_count(), false);
    for (const ElementId e : elements_) {
      mine[e.index()] = true;
    }
    for (const model::ElementSet& set : mesh.element_sets) {
      const auto have = static_cast<std::size_t>(
          std::ranges::count_if(set.elements, [&](ElementId e) { return mine[e.index()]; }));
      uniform_ = uniform_ && (have == 0 || have == elements_.size());
    }
  }

  [[nodiscard]] ElementId parent_of(const Vec3& x) const {
    ElementId best = elements_.front();
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < elements_.size() && !uniform_ && least > 0.0; ++i) {
      const SolidHost::ElementExtent& extent = host_.extent(elements_[i]);
      if ((x - extent.middle).norm() > 1.1 * extent.radius) {
        continue;
      }
      const double outside = distance_outside(host_.mesh(), elements_[i], x);
      if (outside < least) {
        least = outside;
        best = elements_[i];
      }
    }
    return best;
  }

private:
  const SolidHost& host_;
  const std::vector<ElementId>& elements_;
  bool uniform_ = true;
};

class SolidGrafter {
public:
  SolidGrafter(const SolidHost& host, std::span<SolidGraft> grafts)
      : solids_(host), host_(host.mesh()), grafts_(grafts), kept_(host_.element_count()),
        used_(host_.node_count(), false) {}

  CrackedMesh graft() {
    add_nodes();
    keep_elements();
    add_elements();
    inherit_element_sets();
    inherit_face_sets();
    inherit_node_sets();
    return std::move(result_);
  }

private:
  void add_nodes() {
    model::Mesh& mesh = result_.mesh;
    mesh.dim = host_.dim;
    // All host nodes stay, also those that no element will have: numbers keep their meaning.
    mesh.x = host_.x;
    mesh.node_label = host_.node_label;
    mesh.node_net = host_.node_net;
    for (SolidGraft& g : grafts_) {
      const base::NetId net = host_.element_net[g.cavity.elements.front().index()];
      base::Label label = next_node_label(mesh, net);
      for (const SolidPatchNode& node : g.patch.nodes) {
        g.node.push_back(node.host.valid() ? node.host
                                           : model::add_node(mesh, node.x, label++, net));
      }
    }
  }

  void keep_elements() {
    std::vector<bool> removed(host_.element_count(), false);
    for (const SolidGraft& g : grafts_) {
      for (const ElementId e : g.cavity.elements) {
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
    for (SolidGraft& g : grafts_) {
      const base::NetId net = host_.element_net[g.cavity.elements.front().index()];
      // Labels of elements that were cut out are not given anew.
      base::Label label =
          std::max(next_element_label(host_, net), next_element_label(result_.mesh, net));
      const ParentFinder finder(solids_, g.cavity);
      for (const SolidPatchElement& element : g.patch.elements) {
        std::vector<NodeId> nodes;
        Vec3 centre = Vec3::Zero();
        const auto corners = static_cast<std::size_t>(base::element_info(element.type).corners);
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
          nodes.push_back(g.node[static_cast<std::size_t>(element.nodes[i])]);
          if (i < corners) {
            centre += result_.mesh.x[nodes.back().index()] / static_cast<double>(corners);
          }
        }
        const ElementId parent = finder.parent_of(centre);
        g.element.push_back(add(parent, element.type, nodes, label++));
        parent_.emplace_back(g.element.back(), parent);
        result_.host.emplace_back();
      }
    }
  }

  void inherit_element_sets() {
    for (const model::ElementSet& old : host_.element_sets) {
      model::ElementSet set{old.name, {}, old.span};
      std::vector<bool> member(host_.element_count(), false);
      for (const ElementId e : old.elements) {
        member[e.index()] = true;
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
    for (const SolidGraft& g : grafts_) {
      for (const auto& [face, pieces] : g.patch.faces) {
        std::vector<model::Face>& sides_there = faces_[face];
        for (const std::vector<int>& piece : pieces) {
          std::vector<NodeId> corners;
          std::ranges::transform(piece, std::back_inserter(corners),
                                 [&](int n) { return g.node[static_cast<std::size_t>(n)]; });
          for (const model::Face& side : sides.find(corners)) {
            sides_there.push_back(side);
          }
        }
      }
    }
  }

  void inherit_face_sets() {
    find_new_faces();
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

  /// Whether all nodes of the elements of a cavity are in a set.
  [[nodiscard]] bool covers(const std::vector<bool>& member, const SolidCavity& cavity) const {
    return std::ranges::all_of(cavity.elements, [&](ElementId e) {
      return std::ranges::all_of(host_.element_nodes(e),
                                 [&](NodeId n) { return member[n.index()]; });
    });
  }

  /// Where new faces are larger than the host's some of these have none in their place: of a set's
  /// lost nodes those stay for which no new face that is all in the set covers the place.
  void leave_covered(const std::vector<bool>& member, std::vector<NodeId>& removed) const {
    if (removed.empty()) {
      return;
    }
    std::vector<CornerPlaces> triangles;
    for (const auto& [face, pieces] : faces_) {
      for (const model::Face& piece : pieces) {
        if (lies_within(result_.mesh, piece, member)) {
          const FaceNodes nodes = face_nodes(result_.mesh, piece);
          for (std::size_t i = 2; i < nodes.corners; ++i) {
            triangles.push_back({result_.mesh.x[nodes.all[0].index()],
                                 result_.mesh.x[nodes.all[i - 1].index()],
                                 result_.mesh.x[nodes.all[i].index()]});
          }
        }
      }
    }
    if (triangles.empty()) {
      return;
    }
    constexpr double off_chord = 0.1; // of an edge: where the surface is curved
    const TriangleTree tree(std::move(triangles));
    std::erase_if(removed, [&](NodeId n) {
      const TriangleTree::NearestTriangle at = tree.nearest(host_.x[n.index()]);
      const CornerPlaces& t = tree.triangles()[at.triangle];
      return at.distance <= off_chord * (t[1] - t[0]).norm();
    });
  }

  template <class PatchCoupling>
  static void join_edge(const SolidGraft& g, const HeldEdgePieces& edge, PatchCoupling&& join,
                        std::vector<bool>& replaced) {
    for (const int n : edge.ends) {
      join(g.node[static_cast<std::size_t>(n)]);
    }
    if (edge.mid >= 0) {
      join(g.node[static_cast<std::size_t>(edge.mid)]);
    }
    for (const NodeId n : edge.host) {
      if (n.valid()) {
        replaced[n.index()] = true;
      }
    }
  }

  void inherit_node_sets() {
    std::vector<bool> had(host_.node_count(), false);
    for (const NodeId n : host_.nodes) {
      had[n.index()] = true;
    }
    for (const model::NodeSet& old : host_.node_sets) {
      model::NodeSet set{old.name, {}, old.span};
      std::vector<bool> member(result_.mesh.node_count(), false);
      for (const NodeId n : old.nodes) {
        member[n.index()] = true;
        // Nodes without an element in the host were taken by no cavity.
        if (used_[n.index()] || !had[n.index()]) {
          set.nodes.push_back(n);
        }
      }
      // Asked of the set as it was: nodes that join must not bring others in.
      const std::vector<bool> old_member = member;
      std::vector<bool> replaced(host_.node_count(), false);
      const auto join = [&](NodeId n) {
        if (!member[n.index()]) {
          member[n.index()] = true;
          set.nodes.push_back(n);
        }
      };
      for (const auto& [face, pieces] : faces_) {
        if (lies_within(host_, face, old_member)) {
          std::ranges::for_each(nodes_of_faces(result_.mesh, pieces), join);
          const FaceNodes nodes = face_nodes(host_, face);
          for (const NodeId n : nodes.all) {
            replaced[n.index()] = true;
          }
        }
      }
      for (const SolidGraft& g : grafts_) {
        for (const HeldEdgePieces& edge : g.patch.edges) {
          if (std::ranges::all_of(edge.host,
                                  [&](NodeId n) { return !n.valid() || old_member[n.index()]; })) {
            join_edge(g, edge, join, replaced);
          }
        }
        // A set that has all of a cavity has all of the patch.
        if (covers(old_member, g.cavity)) {
          std::ranges::for_each(g.node, join);
          for (const ElementId e : g.cavity.elements) {
            for (const NodeId n : host_.element_nodes(e)) {
              replaced[n.index()] = true;
            }
          }
        }
      }
      std::vector<NodeId>& removed = result_.removed_nodes.emplace_back();
      std::ranges::copy_if(old.nodes, std::back_inserter(removed), [&](NodeId n) {
        return had[n.index()] && !used_[n.index()] && !replaced[n.index()];
      });
      leave_covered(member, removed);
      result_.mesh.node_sets.push_back(std::move(set));
    }
  }

  const SolidHost& solids_;
  const model::Mesh& host_;
  std::span<SolidGraft> grafts_;
  CrackedMesh result_;
  std::size_t first_new_ = 0;
  std::vector<ElementId> kept_;                         ///< [host element] its new number
  std::vector<bool> used_;                              ///< [host node] by an element of the result
  std::vector<std::pair<ElementId, ElementId>> parent_; ///< new element, host element it lies in
  std::map<model::Face, std::vector<model::Face>> faces_;
};

} // namespace

CrackedMesh graft_solids(const SolidHost& host, std::span<SolidGraft> grafts) {
  return SolidGrafter(host, grafts).graft();
}

} // namespace spricka::mesh
