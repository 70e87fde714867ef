// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/graft.hpp"

#include "geometry/box_tree.hpp"
#include "mesh/boundary.hpp"
#include "mesh/numbering.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;

/// Finds the element of a cavity that a point lies in, or comes nearest to.
class Locator {
public:
  Locator(const model::Mesh& host, const PatchGraft& graft) : elements_(graft.cavity.elements) {
    std::vector<geometry::Box<2>> boxes;
    for (const ElementId e : elements_) {
      outlines_.push_back(polygon(host, e, graft.frame));
      boxes.push_back(geometry::Box<2>::around(outlines_.back()));
    }
    boxes_ = geometry::BoxTree<2>(boxes);
  }

  [[nodiscard]] ElementId element_at(const Vec2& p) const {
    const std::optional<std::size_t> nearest = boxes_.nearest(p, [&](std::size_t i) {
      return distance(outlines_[i], {p, p});
    });
    return elements_[nearest.value_or(0)];
  }

private:
  const std::vector<ElementId>& elements_;
  std::vector<std::vector<Vec2>> outlines_; ///< [element]
  geometry::BoxTree<2> boxes_;              ///< [element]
};

class Grafter {
public:
  Grafter(const model::Mesh& host, std::span<PatchGraft> grafts)
      : host_(host), grafts_(grafts), kept_(host.element_count()), used_(host.node_count(), false) {
  }

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
    // All host nodes stay, also those that no element will have, so that numbers keep their
    // meaning.
    mesh.x = host_.x;
    mesh.node_label = host_.node_label;
    mesh.node_net = host_.node_net;
    for (PatchGraft& g : grafts_) {
      const base::NetId net = host_.element_net[g.cavity.elements.front().index()];
      base::Label label = next_node_label(mesh, net);
      for (const PatchNode& node : g.patch.nodes) {
        g.node.push_back(node.host.valid() ? node.host
                                           : model::add_node(mesh, node.x, label++, net));
      }
    }
  }

  void keep_elements() {
    std::vector<bool> removed(host_.element_count(), false);
    for (const PatchGraft& g : grafts_) {
      for (const ElementId e : g.cavity.elements) {
        removed[e.index()] = true;
      }
    }
    for (std::size_t e = 0; e < host_.element_count(); ++e) {
      if (!removed[e]) {
        add(ElementId(e), host_.type[e], host_.element_nodes(ElementId(e)), host_.element_label[e]);
        kept_[e] = ElementId(result_.host.size());
        result_.host.emplace_back(e);
      }
    }
  }

  void add(ElementId like, base::ElementType type, std::span<const NodeId> nodes,
           base::Label label) {
    const ElementId e =
        model::add_element(result_.mesh, type, nodes, label, host_.element_net[like.index()]);
    result_.mesh.property[e.index()] = host_.property[like.index()];
    for (const NodeId n : nodes) {
      if (n.index() < used_.size()) {
        used_[n.index()] = true;
      }
    }
  }

  void add_elements() {
    for (const PatchGraft& g : grafts_) {
      const base::NetId net = host_.element_net[g.cavity.elements.front().index()];
      // Labels of elements that were cut out are not given anew.
      base::Label label =
          std::max(next_element_label(host_, net), next_element_label(result_.mesh, net));
      const Locator locator(host_, g);
      for (const PatchElement& element : g.patch.elements) {
        std::vector<NodeId> nodes;
        Vec2 centre = Vec2::Zero();
        const auto corners = static_cast<std::size_t>(base::element_info(element.type).corners);
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
          const auto n = static_cast<std::size_t>(element.nodes[i]);
          nodes.push_back(g.node[n]);
          if (i < corners) {
            // Rounded coordinates: round-off does not choose the parent of an element between two.
            centre += g.patch.nodes[n].local / static_cast<double>(corners);
          }
        }
        const ElementId parent = locator.element_at(centre);
        parent_.emplace_back(ElementId(result_.mesh.element_count()), parent);
        add(parent, element.type, nodes, label++);
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
  [[nodiscard]] std::map<model::Face, std::vector<model::Face>> new_faces() const {
    std::map<std::pair<NodeId, NodeId>, model::Face> by_ends;
    for (const auto& [e, parent] : parent_) {
      for (int s = 0; s < base::element_info(result_.mesh.type[e.index()]).sides; ++s) {
        // Pieces run as the host's edge does, body on the left: the direction tells a side from
        // that of the neighbour.
        const ElementEdge edge = element_edge(result_.mesh, {e, s});
        by_ends[{edge.a, edge.b}] = {e, s};
      }
    }
    std::map<model::Face, std::vector<model::Face>> result;
    for (const PatchGraft& g : grafts_) {
      for (const auto& [face, pieces] : g.patch.edges) {
        for (const auto& [a, b] : pieces) {
          result[face].push_back(by_ends.at(
              {g.node[static_cast<std::size_t>(a)], g.node[static_cast<std::size_t>(b)]}));
        }
      }
    }
    return result;
  }

  void inherit_face_sets() {
    faces_ = new_faces();
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
  [[nodiscard]] bool covers(const std::vector<bool>& member, const Cavity& cavity) const {
    return std::all_of(cavity.elements.begin(), cavity.elements.end(), [&](ElementId e) {
      const auto nodes = host_.element_nodes(e);
      return std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) { return member[n.index()]; });
    });
  }

  /// Members that are gone, but for those of whole sides of the boundary and of whole cavities.
  [[nodiscard]] std::vector<NodeId> removed_nodes(const model::NodeSet& old,
                                                  const std::vector<bool>& member,
                                                  const std::vector<bool>& had) const {
    std::vector<NodeId> removed;
    for (const NodeId n : old.nodes) {
      if (had[n.index()] && !used_[n.index()]) {
        removed.push_back(n);
      }
    }
    if (removed.empty()) {
      return removed;
    }
    std::vector<bool> replaced(host_.node_count(), false);
    for (const model::Face& face : boundary_faces(host_)) {
      const ElementEdge edge = element_edge(host_, face);
      if (!kept_[face.element.index()].valid() && member[edge.a.index()] &&
          member[edge.b.index()] && (!edge.mid.valid() || member[edge.mid.index()])) {
        replaced[edge.a.index()] = true;
        replaced[edge.b.index()] = true;
        replaced[edge.mid.valid() ? edge.mid.index() : edge.a.index()] = true;
      }
    }
    for (const PatchGraft& g : grafts_) {
      for (const ElementId e :
           covers(member, g.cavity) ? g.cavity.elements : std::vector<ElementId>()) {
        for (const NodeId n : host_.element_nodes(e)) {
          replaced[n.index()] = true;
        }
      }
    }
    std::erase_if(removed, [&](NodeId n) { return replaced[n.index()]; });
    return removed;
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
      // Whether a side or a cavity was in the set is asked of the set as it was: nodes that join
      // here must not bring others in.
      const std::vector<bool> old_member = member;
      const auto join = [&](NodeId n) {
        if (!member[n.index()]) {
          member[n.index()] = true;
          set.nodes.push_back(n);
        }
      };
      for (const auto& [face, pieces] : faces_) {
        const ElementEdge edge = element_edge(host_, face);
        if (old_member[edge.a.index()] && old_member[edge.b.index()] &&
            (!edge.mid.valid() || old_member[edge.mid.index()])) {
          for (const model::Face& piece : pieces) {
            const ElementEdge part = element_edge(result_.mesh, piece);
            join(part.a);
            join(part.mid);
            join(part.b);
          }
        }
      }
      for (const PatchGraft& g : grafts_) {
        // A set that has all of a cavity has all of the patch.
        if (covers(old_member, g.cavity)) {
          std::for_each(g.node.begin(), g.node.end(), join);
        }
      }
      result_.removed_nodes.push_back(removed_nodes(old, old_member, had));
      result_.mesh.node_sets.push_back(std::move(set));
    }
  }

  const model::Mesh& host_;
  std::span<PatchGraft> grafts_;
  CrackedMesh result_;
  std::vector<ElementId> kept_;                         ///< [host element] its new number
  std::vector<bool> used_;                              ///< [host node] by an element of the result
  std::vector<std::pair<ElementId, ElementId>> parent_; ///< new element, host element it lies in
  std::map<model::Face, std::vector<model::Face>> faces_;
};

} // namespace

CrackedMesh graft_patches(const model::Mesh& host, std::span<PatchGraft> grafts) {
  return Grafter(host, grafts).graft();
}

} // namespace spricka::mesh
