// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/swept_solid.hpp"
#include "mesh/generate/lattice.hpp"
#include "mesh/generate/solid_points.hpp"
#include "mesh/numbering.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;
using base::Vec3;

/// A point of the swept body: the middle of two corners of a plane element (or one, twice) at a
/// level; two levels are a layer.
struct SweptPoint {
  int a = 0, b = 0;
  int level = 0;
};

class PlaneSweep {
public:
  PlaneSweep(model::Mesh& mesh, base::NetId net, const model::Mesh& plane, const SweepSpec& spec)
      : mesh_(mesh), net_(net), plane_(plane), spec_(spec),
        known_(plane.node_count() * static_cast<std::size_t>(2 * spec.layers + 1)),
        next_node_(next_node_label(mesh, net)), next_element_(next_element_label(mesh, net)) {
    assert(spec.depth > 0.0 && spec.layers >= 1);
    for (std::size_t s = 0; s < plane.face_sets.size(); ++s) {
      for (const model::Face& side : plane.face_sets[s].faces) {
        sets_of_edge_[side].push_back(s);
      }
    }
    faces_.resize(plane.face_sets.size());
  }

  void build(const std::string& prefix) {
    mesh_.dim = 3;
    const std::size_t first = mesh_.element_count();
    for (std::size_t e = 0; e < plane_.element_count(); ++e) {
      for (layer_ = 0; layer_ < spec_.layers; ++layer_) {
        sweep(ElementId(e));
      }
    }
    append_body_set(mesh_, prefix, first);
    for (std::size_t s = 0; s < faces_.size(); ++s) {
      add_set(prefix + plane_.face_sets[s].name, faces_[s]);
    }
    add_set(prefix + "ZMIN", low_);
    add_set(prefix + "ZMAX", high_);
  }

private:
  void add_set(std::string name, std::vector<model::Face>& faces) {
    std::ranges::sort(faces);
    mesh_.face_sets.push_back({std::move(name), std::move(faces), {}});
  }

  void sweep(ElementId e) {
    plane_element_ = e;
    corners_ = base::element_info(plane_.type[e.index()]).corners;
    if (base::element_info(spec_.type).corners == 4) {
      sweep_tetrahedra();
      return;
    }
    std::vector<SweptPoint> corner;
    for (const int level : {2 * layer_, 2 * layer_ + 2}) {
      for (int c = 0; c < corners_; ++c) {
        corner.push_back({c, c, level});
      }
    }
    add(corners_ == 4 ? spec_.type : pentahedron(), corner);
  }

  [[nodiscard]] ElementType pentahedron() const {
    return base::element_info(spec_.type).quadratic ? ElementType::pentac15 : ElementType::penta6;
  }

  /// Diagonals go up from the node of the lower number, so that neighbours agree on them, and down
  /// in every other layer, so that neither way is preferred.
  void sweep_tetrahedra() {
    std::array<int, 3> v{0, 1, 2};
    const auto nodes = plane_.element_nodes(plane_element_);
    std::ranges::sort(v, {}, [&](int c) { return nodes[static_cast<std::size_t>(c)]; });
    const bool up = layer_ % 2 == 0;
    const int from = 2 * layer_ + (up ? 0 : 2);
    const int to = 2 * layer_ + (up ? 2 : 0);
    for (std::size_t turn = 0; turn < 3; ++turn) {
      std::vector<SweptPoint> corner;
      for (std::size_t k = 0; k <= turn; ++k) {
        corner.push_back({v[k], v[k], from});
      }
      for (std::size_t k = turn; k < 3; ++k) {
        corner.push_back({v[k], v[k], to});
      }
      if (signed_volume(corner) < 0.0) {
        std::swap(corner[2], corner[3]);
      }
      add(spec_.type, corner);
    }
  }

  [[nodiscard]] double signed_volume(const std::vector<SweptPoint>& corner) const {
    const Vec3 origin = place(corner[0]);
    return (place(corner[1]) - origin)
        .cross(place(corner[2]) - origin)
        .dot(place(corner[3]) - origin);
  }

  void add(ElementType type, const std::vector<SweptPoint>& corner) {
    const std::array<SweptPoint, 27> points = solid_element_points<SweptPoint>(
        type, corner, [](const SweptPoint& p, const SweptPoint& q) {
          return SweptPoint{p.a, q.a, (p.level + q.level) / 2};
        });
    const auto count = static_cast<std::size_t>(base::element_info(type).nodes);
    std::array<NodeId, 27> nodes;
    std::transform(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                   nodes.begin(), [&](const SweptPoint& p) { return find_or_add_node(p); });
    const ElementId e =
        model::add_element(mesh_, type, std::span(nodes).first(count), next_element_++, net_);
    note_sides(e, corner);
  }

  void note_sides(ElementId e, const std::vector<SweptPoint>& corner) {
    const ElementType type = mesh_.type[e.index()];
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const auto local = shape::side_nodes(type, s).first(shape::side_corner_count(type, s));
      const auto all = [&](const auto& holds) {
        return std::ranges::all_of(
            local, [&](int c) { return holds(corner[static_cast<std::size_t>(c)]); });
      };
      if (all([](const SweptPoint& p) { return p.level == 0; })) {
        low_.push_back({e, s});
      } else if (all([&](const SweptPoint& p) { return p.level == 2 * spec_.layers; })) {
        high_.push_back({e, s});
      }
      for (int edge = 0; edge < corners_; ++edge) {
        const auto sets = sets_of_edge_.find({plane_element_, edge});
        if (sets != sets_of_edge_.end() &&
            all([&](const SweptPoint& p) { return p.a == edge || p.a == (edge + 1) % corners_; })) {
          for (const std::size_t set : sets->second) {
            faces_[set].push_back({e, s});
          }
        }
      }
    }
  }

  /// The node of the plane mesh between two corners of its element, or at one.
  [[nodiscard]] NodeId plane_node(int a, int b) const {
    const auto nodes = plane_.element_nodes(plane_element_);
    int local = a;
    if (a != b) {
      const int low = std::min(a, b);
      const int high = std::max(a, b);
      const bool opposite = corners_ == 4 && high - low == 2;
      local = opposite ? 8 : corners_ + (high - low == 1 ? low : high);
    }
    return nodes[static_cast<std::size_t>(local)];
  }

  [[nodiscard]] Vec3 place(const SweptPoint& p) const {
    const Vec3& x = plane_.x[plane_node(p.a, p.b).index()];
    const double z = p.level == 2 * spec_.layers
                         ? spec_.z0 + spec_.depth
                         : spec_.z0 + spec_.depth * p.level / (2.0 * spec_.layers);
    return {x.x(), x.y(), z};
  }

  NodeId find_or_add_node(const SweptPoint& p) {
    NodeId& known = known_[plane_node(p.a, p.b).index() +
                           plane_.node_count() * static_cast<std::size_t>(p.level)];
    if (!known.valid()) {
      known = model::add_node(mesh_, place(p), next_node_++, net_);
    }
    return known;
  }

  model::Mesh& mesh_;
  base::NetId net_;
  const model::Mesh& plane_;
  const SweepSpec& spec_;
  std::map<model::Face, std::vector<std::size_t>> sets_of_edge_; ///< of the plane mesh
  std::vector<NodeId> known_;                                    ///< [plane node + nodes * level]
  base::Label next_node_;
  base::Label next_element_;
  std::vector<std::vector<model::Face>> faces_; ///< [face set of the plane mesh]
  std::vector<model::Face> low_, high_;
  ElementId plane_element_; ///< that is being swept, its number of corners and the layer
  int corners_ = 0;
  int layer_ = 0;
};

} // namespace

ElementType swept_plane_type(ElementType solid) {
  const base::ElementInfo& info = base::element_info(solid);
  if (info.corners != 8) {
    return info.quadratic ? ElementType::trimc6 : ElementType::trim3;
  }
  return solid == ElementType::hexec27 ? ElementType::quamc9
         : info.quadratic              ? ElementType::quamc8
                                       : ElementType::quam4;
}

void sweep_plane_mesh(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                      const model::Mesh& plane, const SweepSpec& spec) {
  PlaneSweep(mesh, net, plane, spec).build(prefix);
}

} // namespace spricka::mesh
