// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/subdivide.hpp"

#include "mesh/numbering.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace spricka::mesh {

namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;

/// Places of the nodes of the quarters on the parent's reference element, as multiples of 1/4 of
/// the way from its lowest to its highest coordinate: exact keys, so that quarters share nodes.
using Place = std::array<int, 2>;

struct SubdivisionPattern {
  bool triangle = false;
  std::array<std::array<Place, 4>, 4> corners{}; ///< [quarter][corner]
  int count = 4;                                 ///< corners of a quarter
};

// Quarter i holds corner i of the parent as its own corner i; of a triangle the last one is the
// middle, turned by half a turn.
constexpr SubdivisionPattern triangle_pattern{true,
                                              {{{{{0, 0}, {2, 0}, {0, 2}}},
                                                {{{2, 0}, {4, 0}, {2, 2}}},
                                                {{{0, 2}, {2, 2}, {0, 4}}},
                                                {{{2, 2}, {0, 2}, {2, 0}}}}},
                                              3};
constexpr SubdivisionPattern square_pattern{false,
                                            {{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}},
                                              {{{2, 0}, {4, 0}, {4, 2}, {2, 2}}},
                                              {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}},
                                              {{{0, 2}, {2, 2}, {2, 4}, {0, 4}}}}},
                                            4};

/// How elements of a type are divided; null: they are not, as solids.
const SubdivisionPattern* pattern_of(ElementType type) {
  switch (base::element_info(type).domain) {
  case base::ReferenceDomain::triangle:
    return &triangle_pattern;
  case base::ReferenceDomain::quadrilateral:
    return &square_pattern;
  default:
    return nullptr;
  }
}

Place middle(const Place& a, const Place& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

// Places of all nodes of one quarter, in the order of its type.
std::vector<Place> places_of(const SubdivisionPattern& pattern, std::size_t quarter, int nodes) {
  const auto count = static_cast<std::size_t>(pattern.count);
  std::vector<Place> place(pattern.corners[quarter].begin(),
                           pattern.corners[quarter].begin() + pattern.count);
  for (std::size_t i = 0; i < count && nodes > pattern.count; ++i) {
    place.push_back(middle(place[i], place[(i + 1) % count]));
  }
  if (nodes == 9) {
    place.push_back(middle(place[0], place[2]));
  }
  return place;
}

/// The edge of the parent that a place lies on, and how far along it in quarters; -1: inside.
struct ParentEdgePosition {
  int edge = -1;
  int quarters = 0;
};

ParentEdgePosition edge_of(const SubdivisionPattern& pattern, const Place& p) {
  if (p[1] == 0) {
    return {0, p[0]};
  }
  if (pattern.triangle) {
    if (p[0] + p[1] == 4) {
      return {1, p[1]};
    }
    return p[0] == 0 ? ParentEdgePosition{2, 4 - p[1]} : ParentEdgePosition{};
  }
  if (p[0] == 4) {
    return {1, p[1]};
  }
  if (p[1] == 4) {
    return {2, 4 - p[0]};
  }
  return p[0] == 0 ? ParentEdgePosition{3, 4 - p[1]} : ParentEdgePosition{};
}

// By the parent's own map.
base::Vec3 position(const model::Mesh& mesh, ElementId e, const Place& p) {
  const std::span<const NodeId> nodes = mesh.element_nodes(e);
  const shape::ReferenceElement<2>& element = shape::reference_element<2>(mesh.type[e.index()]);
  shape::Point<2> r(p[0] / 4.0, p[1] / 4.0);
  if (element.domain == shape::ReferenceDomain::quadrilateral) {
    r = 2.0 * r - shape::Point<2>::Ones();
  }
  const shape::ReferenceElement<2>::Values N = element.N(r);
  base::Vec3 x = base::Vec3::Zero();
  for (int n = 0; n < element.nodes; ++n) {
    x += N[n] * mesh.x[nodes[static_cast<std::size_t>(n)].index()];
  }
  return x;
}

class Subdivision {
public:
  Subdivision(model::Mesh& mesh, const std::vector<bool>& nets) : mesh_(mesh), nets_(nets) {}

  void run() {
    const std::size_t before = mesh_.element_count();
    children_.resize(before);
    const model::Mesh old = mesh_;
    for (std::size_t n = 0; n < nets_.size(); ++n) {
      next_node_.push_back(next_node_label(old, base::NetId(n)));
      next_element_.push_back(next_element_label(old, base::NetId(n)));
    }
    for (std::size_t e = 0; e < before; ++e) {
      if (marked(old, ElementId(e))) {
        divide(old, ElementId(e));
      }
    }
    rebuild(old);
    renew_element_sets();
    renew_face_sets(old);
    renew_node_sets(old);
  }

private:
  struct ChildElement {
    std::vector<NodeId> nodes;
  };
  /// What lies on an edge of the old mesh, from its lower corner to the upper one: nodes at 1/4,
  /// 1/2 and 3/4 of it, invalid where the type has none.
  using EdgeNodes = std::array<NodeId, 3>;

  [[nodiscard]] bool marked(const model::Mesh& old, ElementId e) const {
    return pattern_of(old.type[e.index()]) != nullptr && nets_[old.element_net[e.index()].index()];
  }

  void divide(const model::Mesh& old, ElementId e) {
    const ElementType type = old.type[e.index()];
    const base::ElementInfo& info = base::element_info(type);
    const SubdivisionPattern& pattern = *pattern_of(type);
    std::map<Place, NodeId> inside;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      ChildElement child;
      for (const Place& p : places_of(pattern, quarter, info.nodes)) {
        child.nodes.push_back(node_at(old, e, pattern, p, inside));
      }
      children_[e.index()].push_back(std::move(child));
    }
    for (const auto& [p, node] : inside) {
      if (node.index() >= old.node_count()) {
        centre_.emplace_back(node, e);
      }
    }
  }

  NodeId node_at(const model::Mesh& old, ElementId e, const SubdivisionPattern& pattern,
                 const Place& p, std::map<Place, NodeId>& inside) {
    const std::span<const NodeId> nodes = old.element_nodes(e);
    const ParentEdgePosition on = edge_of(pattern, p);
    const auto corners = static_cast<std::size_t>(pattern.count);
    if (on.edge < 0) {
      const auto [at, fresh] = inside.try_emplace(p);
      if (fresh) {
        at->second = nodes.size() == 9 && p == Place{2, 2} ? nodes[8] : add(old, e, p);
      }
      return at->second;
    }
    const auto side = static_cast<std::size_t>(on.edge);
    const NodeId a = nodes[side];
    const NodeId b = nodes[(side + 1) % corners];
    if (on.quarters == 0 || on.quarters == 4) {
      return on.quarters == 0 ? a : b;
    }
    if (on.quarters == 2 && nodes.size() > corners) {
      return nodes[corners + side];
    }
    const bool up = a < b;
    EdgeNodes& edge = edges_[up ? std::pair(a, b) : std::pair(b, a)];
    NodeId& node = edge[static_cast<std::size_t>(up ? on.quarters : 4 - on.quarters) - 1];
    if (!node.valid()) {
      node = add(old, e, p);
    }
    return node;
  }

  NodeId add(const model::Mesh& old, ElementId e, const Place& p) {
    const base::NetId net = old.element_net[e.index()];
    return model::add_node(mesh_, position(old, e, p), next_node_[net.index()]++, net);
  }

  // First quarters stand where their parents stood, the others behind.
  void rebuild(const model::Mesh& old) {
    mesh_.type.clear();
    mesh_.nodes.clear();
    mesh_.first.assign(1, 0);
    mesh_.element_label.clear();
    mesh_.element_net.clear();
    mesh_.property.clear();
    for (std::size_t e = 0; e < old.element_count(); ++e) {
      const bool parted = !children_[e].empty();
      append(old, ElementId(e), old.element_label[e],
             parted ? std::span<const NodeId>(children_[e].front().nodes)
                    : old.element_nodes(ElementId(e)));
    }
    later_.resize(old.element_count());
    for (std::size_t e = 0; e < old.element_count(); ++e) {
      for (std::size_t quarter = 1; quarter < children_[e].size(); ++quarter) {
        later_[e].push_back(ElementId(mesh_.element_count()));
        append(old, ElementId(e), next_element_[old.element_net[e].index()]++,
               children_[e][quarter].nodes);
      }
    }
  }

  void append(const model::Mesh& old, ElementId parent, base::Label label,
              std::span<const NodeId> nodes) {
    model::add_element(mesh_, old.type[parent.index()], nodes, label,
                       old.element_net[parent.index()]);
    mesh_.property.back() = old.property[parent.index()];
  }

  void renew_element_sets() {
    for (model::ElementSet& set : mesh_.element_sets) {
      const std::vector<ElementId> parents = set.elements;
      for (const ElementId e : parents) {
        set.elements.insert(set.elements.end(), later_[e.index()].begin(), later_[e.index()].end());
      }
    }
  }

  // Side s of the parent is side s of the quarters at its two corners.
  void renew_face_sets(const model::Mesh& old) {
    for (model::FaceSet& set : mesh_.face_sets) {
      const std::vector<model::Face> sides = std::exchange(set.faces, {});
      for (const model::Face& face : sides) {
        if (children_[face.element.index()].empty()) {
          set.faces.push_back(face);
          continue;
        }
        const int corners = base::element_info(old.type[face.element.index()]).corners;
        for (const int corner : {face.side, (face.side + 1) % corners}) {
          const ElementId child =
              corner == 0 ? face.element
                          : later_[face.element.index()][static_cast<std::size_t>(corner) - 1];
          set.faces.push_back({child, face.side});
        }
      }
    }
  }

  void renew_node_sets(const model::Mesh& old) {
    std::map<std::pair<NodeId, NodeId>, NodeId> mids; // mid node of each edge, as the mesh was
    for (std::size_t e = 0; e < old.element_count(); ++e) {
      const base::ElementInfo& info = base::element_info(old.type[e]);
      const std::span<const NodeId> nodes = old.element_nodes(ElementId(e));
      for (int m = 0; marked(old, ElementId(e)) && info.quadratic && m < info.corners; ++m) {
        const std::array<int, 2> ends = shape::edge_corners(old.type[e], m);
        const NodeId a = nodes[static_cast<std::size_t>(ends[0])];
        const NodeId b = nodes[static_cast<std::size_t>(ends[1])];
        mids.emplace(std::minmax(a, b), nodes[static_cast<std::size_t>(info.corners + m)]);
      }
    }
    for (model::NodeSet& set : mesh_.node_sets) {
      renew(old, mids, set);
    }
  }

  void renew(const model::Mesh& old, const std::map<std::pair<NodeId, NodeId>, NodeId>& mids,
             model::NodeSet& set) const {
    const std::vector<bool> member = model::mark_members(mesh_.node_count(), set.nodes);
    const auto in = [&](NodeId n) { return member[n.index()]; };
    std::map<std::pair<NodeId, NodeId>, NodeId> between; // of two nodes side by side on an edge
    for (const auto& [ends, nodes] : edges_) {
      const auto mid = mids.find(ends);
      if (!in(ends.first) || !in(ends.second) || (mid != mids.end() && !in(mid->second))) {
        continue;
      }
      if (mid == mids.end()) {
        between.emplace(ends, nodes[1]);
      } else {
        between.emplace(std::minmax(ends.first, mid->second), nodes[0]);
        between.emplace(std::minmax(mid->second, ends.second), nodes[2]);
      }
    }
    std::vector<NodeId> grown;
    for (const NodeId node : set.nodes) {
      if (!grown.empty()) {
        const auto at = between.find(std::minmax(grown.back(), node));
        if (at != between.end() && at->second.valid()) {
          grown.push_back(at->second);
          between.erase(at);
        }
      }
      grown.push_back(node);
    }
    for (const auto& [ends, node] : between) {
      if (node.valid()) {
        grown.push_back(node);
      }
    }
    for (const auto& [node, parent] : centre_) {
      const std::span<const NodeId> nodes = old.element_nodes(parent);
      if (std::all_of(nodes.begin(), nodes.end(), in)) {
        grown.push_back(node);
      }
    }
    set.nodes = std::move(grown);
  }

  model::Mesh& mesh_;
  const std::vector<bool>& nets_;
  std::vector<base::Label> next_node_, next_element_; ///< [net]
  std::vector<std::vector<ChildElement>> children_;   ///< [old element][quarter]
  std::vector<std::vector<ElementId>> later_;         ///< [old element] quarters 1 to 3
  std::map<std::pair<NodeId, NodeId>, EdgeNodes> edges_;
  std::vector<std::pair<NodeId, ElementId>> centre_; ///< new nodes inside an old element
};

} // namespace

void subdivide_plane_elements(model::Mesh& mesh, const std::vector<bool>& nets) {
  Subdivision(mesh, nets).run();
}

} // namespace spricka::mesh
