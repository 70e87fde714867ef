// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/corners.hpp"

#include "estimate/wedge.hpp"
#include "fe/law.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spricka::estimate {

namespace {

constexpr double pi = std::numbers::pi;
// Sides that bend by less than this are curves drawn by chords.
constexpr double bend = 10.0 * pi / 180.0;
// Exponents nearer to 1 than this change nothing that counts.
constexpr double nearly_regular = 0.97;
// The displacement under a force on a point grows like log r, that of the adjoint is smooth there:
// together as much as twice a half.
constexpr double of_point = 0.5;
// Ends of two bodies nearer to each other than this part of an element are one.
constexpr double one_end = 1.1;

/// An element at a node, between its sides from the node on and towards it.
struct Slice {
  base::ElementId element;
  std::size_t out = 0, in = 0; ///< edges; the element lies between them, anticlockwise
  double from = 0.0, to = 0.0; ///< [rad] directions of both at the node
};

double direction(const model::Mesh& mesh, base::NodeId node, base::NodeId other,
                 base::NodeId middle) {
  const auto at = [&](base::NodeId n) -> base::Vec2 { return mesh.x[n.index()].head<2>(); };
  const base::Vec2 chord = at(other) - at(node);
  // Derivative of the side's parabola at the node.
  const base::Vec2 tangent = 4.0 * at(middle) - at(other) - 3.0 * at(node);
  // the tangent of a side with a quarter point is zero
  const base::Vec2& d = tangent.norm() > 0.1 * chord.norm() ? tangent : chord;
  return std::atan2(d.y(), d.x());
}

double ahead_of(double from, double angle) {
  while (angle <= from) {
    angle += 2.0 * pi;
  }
  return angle;
}

class CornerFinder {
public:
  explicit CornerFinder(const CornerSearchInput& setting)
      : set_(setting), slices_(setting.mesh.node_count()),
        left_out_(setting.mesh.node_count(), false) {
    const std::vector<bool> wanted = at_borders();
    for (std::size_t e = 0; e < set_.mesh.element_count(); ++e) {
      add_slices(base::ElementId(e), wanted);
    }
    for (const base::NodeId n : set_.front_nodes) {
      left_out_[n.index()] = true;
    }
    // Nodes of ties are no free wedges and none that are held, but where `tied` says so.
    for (const fe::ConstraintTransformation::DependentRow& row : set_.ties.rows()) {
      leave_out(static_cast<std::size_t>(row.freedom) / 2);
      for (const fe::FreedomTerm& term : row.terms) {
        leave_out(static_cast<std::size_t>(term.freedom) / 2);
      }
    }
  }

  [[nodiscard]] std::vector<SingularCorner> corners() const {
    std::vector<SingularCorner> found;
    for (std::size_t n = 0; n < slices_.size(); ++n) {
      if (!left_out_[n] && !slices_[n].empty()) {
        look_at(base::NodeId(n), found);
      }
    }
    drop_common_ends(found);
    add_points(found);
    return found;
  }

private:
  [[nodiscard]] bool tied(std::size_t n) const { return set_.tied != nullptr && (*set_.tied)[n]; }
  void leave_out(std::size_t n) { left_out_[n] = left_out_[n] || !tied(n); }

  // Ends of ties that no surface goes on past: a body that ends there alone is a smooth one.
  void drop_common_ends(std::vector<SingularCorner>& found) const {
    const auto at = [&](const SingularCorner& c) -> base::Vec2 {
      return set_.mesh.x[c.node.index()].head<2>();
    };
    std::vector<base::Vec2> passed;
    for (const SingularCorner& corner : found) {
      // A surface that goes on past the node opens to a straight angle there.
      if (tied(corner.node.index()) && opening(corner.node) > pi - bend) {
        passed.push_back(at(corner));
      }
    }
    std::erase_if(found, [&](const SingularCorner& corner) {
      const bool own = tied(corner.node.index()) && opening(corner.node) <= pi - bend;
      return own && std::ranges::none_of(passed, [&](const base::Vec2& x) {
               return (x - at(corner)).norm() < one_end * longest_side(corner);
             });
    });
  }

  [[nodiscard]] double opening(base::NodeId n) const {
    double angle = 0.0;
    for (const Slice& slice : slices_[n.index()]) {
      angle += slice.to - slice.from;
    }
    return angle;
  }

  [[nodiscard]] double longest_side(const SingularCorner& corner) const {
    double most = 0.0;
    for (const Slice& slice : slices_[corner.node.index()]) {
      for (const std::size_t side : {slice.out, slice.in}) {
        const QuadraticEdge& edge = set_.edges.edges[side];
        most = std::max(
            most, (set_.mesh.x[edge.nodes[0].index()] - set_.mesh.x[edge.nodes[1].index()]).norm());
      }
    }
    return most;
  }

  [[nodiscard]] bool given(base::NodeId n, std::size_t c) const {
    const model::FreedomRole k = set_.cls[2 * n.index() + c];
    return k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed;
  }

  // Nodes that are held though none of their sides is, and those that forces push.
  void add_points(std::vector<SingularCorner>& found) const {
    std::vector<bool> beside(2 * set_.mesh.node_count(), false); // of a side that is held
    for (const QuadraticEdge& edge : set_.edges.edges) {
      for (std::size_t c = 0; c < 2; ++c) {
        // a set may end in the middle of a side: two of its nodes bear together
        const bool together =
            std::ranges::count_if(edge.nodes, [&](base::NodeId n) { return given(n, c); }) > 1;
        for (const base::NodeId n : edge.nodes) {
          beside[2 * n.index() + c] = beside[2 * n.index() + c] || together;
        }
      }
    }
    std::map<base::NodeId, std::array<bool, 2>> points; // held alone
    for (const model::LoadCase& load_case : set_.model.cases) {
      for (const model::Load& load : load_case.loads) {
        if (load.type == model::LoadType::force) {
          for (const base::NodeId n : set_.mesh.set_with_id(load.nodes).nodes) {
            points.try_emplace(n);
          }
        }
      }
    }
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const base::NodeId n(i / 2);
      if (!beside[i] && given(n, i % 2) && !left_out_[n.index()]) {
        points[n][i % 2] = true;
      }
    }
    std::map<base::NodeId, std::vector<base::ElementId>> elements;
    for (std::size_t e = 0; e < set_.mesh.element_count() && !points.empty(); ++e) {
      for (const base::NodeId n : set_.mesh.element_nodes(base::ElementId(e))) {
        if (points.contains(n)) {
          elements[n].emplace_back(e);
        }
      }
    }
    for (const auto& [n, own] : elements) {
      found.push_back({.node = n,
                       .exponent = of_point,
                       .held_alone = points[n],
                       .elements = own,
                       .around = neighbourhood(own)});
    }
  }

  // Nodes on sides of one element only, and those where properties meet. [node]
  [[nodiscard]] std::vector<bool> at_borders() const {
    const model::Mesh& mesh = set_.mesh;
    std::vector<bool> wanted(mesh.node_count(), false);
    for (const QuadraticEdge& edge : set_.edges.edges) {
      for (const base::NodeId n : edge.nodes) {
        wanted[n.index()] = wanted[n.index()] || edge.elements == 1;
      }
    }
    std::vector<base::PropertyId> property(mesh.node_count());
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        base::PropertyId& own = property[n.index()];
        wanted[n.index()] = wanted[n.index()] || (own.valid() && own != mesh.property[e]);
        own = mesh.property[e];
      }
    }
    return wanted;
  }

  void add_slices(base::ElementId e, const std::vector<bool>& wanted) {
    const model::Mesh& mesh = set_.mesh;
    const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
    for (std::size_t i = 0; i < corners; ++i) {
      if (!wanted[nodes[i].index()]) {
        continue;
      }
      const std::size_t next = (i + 1) % corners;
      const std::size_t last = (i + corners - 1) % corners;
      Slice slice{.element = e,
                  .out = set_.edges.edge_at_side(e, static_cast<int>(i)),
                  .in = set_.edges.edge_at_side(e, static_cast<int>(last)),
                  .from = direction(mesh, nodes[i], nodes[next], nodes[corners + i])};
      slice.to =
          ahead_of(slice.from, direction(mesh, nodes[i], nodes[last], nodes[corners + last]));
      slices_[nodes[i].index()].push_back(slice);
    }
  }

  [[nodiscard]] bool outside(std::size_t edge) const {
    return set_.edges.edges[edge].elements == 1;
  }

  [[nodiscard]] std::array<bool, 2> held(std::size_t edge) const {
    std::array<bool, 2> both{};
    for (std::size_t c = 0; c < 2; ++c) {
      both[c] = std::ranges::all_of(set_.edges.edges[edge].nodes,
                                    [&](base::NodeId n) { return given(n, c) || tied(n.index()); });
    }
    return both;
  }

  [[nodiscard]] static bool same_law(const fe::ConstitutiveLaw& a, const fe::ConstitutiveLaw& b) {
    const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
    return close(a.lambda, b.lambda) && close(a.mu, b.mu) && close(a.thickness, b.thickness);
  }

  // The slices from `first` on, anticlockwise, as far as elements go.
  [[nodiscard]] static std::vector<Slice> fan(const std::vector<Slice>& all, std::size_t first) {
    std::vector<Slice> list{all[first]};
    while (list.size() < all.size()) {
      const auto next = std::ranges::find(all, list.back().in, &Slice::out);
      if (next == all.end() || next->element == list.front().element) {
        break;
      }
      list.push_back(*next);
    }
    return list;
  }

  [[nodiscard]] MultiMaterialWedge wedge_of(const std::vector<Slice>& list, bool whole) const {
    MultiMaterialWedge wedge;
    wedge.whole = whole;
    double at = list.front().from;
    for (const Slice& slice : list) {
      const fe::ConstitutiveLaw law = fe::constitutive_law(set_.model, set_.mesh, slice.element);
      // Angles are added up, so that they ascend past pi.
      const double to = at + slice.to - slice.from;
      if (!wedge.sectors.empty() && same_law(wedge.sectors.back().law, law)) {
        wedge.sectors.back().to = to;
      } else {
        wedge.sectors.push_back({at, to, law});
      }
      at = to;
    }
    if (!whole) {
      wedge.held = {held(list.front().out), held(list.back().in)};
    }
    return wedge;
  }

  // Smooth sides and borders, and convex corners that nothing holds, need no eigenvalues.
  [[nodiscard]] static bool surely_regular(const MultiMaterialWedge& wedge) {
    const double angle = wedge.sectors.back().to - wedge.sectors.front().from;
    if (wedge.whole) {
      // round the start there may be one material in two parts
      const std::size_t parts = wedge.sectors.size();
      const bool split = parts == 3 && same_law(wedge.sectors[0].law, wedge.sectors[2].law);
      const double second = parts < 2 ? pi : wedge.sectors[1].to - wedge.sectors[1].from;
      return parts == 1 || ((parts == 2 || split) && std::abs(second - pi) < bend);
    }
    if (wedge.sectors.size() > 1 || wedge.held[0] != wedge.held[1]) {
      return false;
    }
    const bool is_free = !wedge.held[0][0] && !wedge.held[0][1];
    return std::abs(angle - pi) < bend || (is_free && angle < pi);
  }

  // The elements, and then all that share a node with them.
  [[nodiscard]] std::vector<base::ElementId>
  neighbourhood(const std::vector<base::ElementId>& elements) const {
    const model::Mesh& mesh = set_.mesh;
    std::vector<base::NodeId> nodes;
    for (const base::ElementId e : elements) {
      nodes.insert(nodes.end(), mesh.element_nodes(e).begin(), mesh.element_nodes(e).end());
    }
    std::ranges::sort(nodes);
    std::vector<base::ElementId> all = elements;
    for (std::size_t i = 0; i < mesh.element_count(); ++i) {
      const base::ElementId e(i);
      const bool touches = std::ranges::any_of(mesh.element_nodes(e), [&](base::NodeId n) {
        return std::ranges::binary_search(nodes, n);
      });
      if (touches && std::ranges::find(elements, e) == elements.end()) {
        all.push_back(e);
      }
    }
    return all;
  }

  void add(base::NodeId node, const std::vector<Slice>& list, bool whole,
           std::vector<SingularCorner>& found) const {
    const MultiMaterialWedge wedge = wedge_of(list, whole);
    if (surely_regular(wedge)) {
      return;
    }
    const double exponent = singularity_exponent(wedge);
    if (exponent >= nearly_regular) {
      return;
    }
    SingularCorner corner{.node = node, .exponent = exponent, .elements = {}, .around = {}};
    for (const Slice& slice : list) {
      corner.elements.push_back(slice.element);
    }
    corner.around = neighbourhood(corner.elements);
    found.push_back(std::move(corner));
  }

  void look_at(base::NodeId node, std::vector<SingularCorner>& found) const {
    const std::vector<Slice>& all = slices_[node.index()];
    bool inside = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      // An outer side begins a fan: a body that meets itself at a node has two there.
      if (outside(all[i].out)) {
        inside = false;
        add(node, fan(all, i), false, found);
      }
    }
    const bool one_material = std::ranges::all_of(all, [&](const Slice& slice) {
      return set_.mesh.property[slice.element.index()] ==
             set_.mesh.property[all.front().element.index()];
    });
    if (inside && !one_material) {
      add(node, fan(all, 0), true, found);
    }
  }

  const CornerSearchInput& set_;
  std::vector<std::vector<Slice>> slices_; ///< [node]
  std::vector<bool> left_out_;             ///< [node]
};

} // namespace

std::vector<SingularCorner> find_singular_corners(const CornerSearchInput& setting) {
  return CornerFinder(setting).corners();
}

} // namespace spricka::estimate
