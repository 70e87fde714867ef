// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/section.hpp"

#include "mesh/boundary.hpp"
#include "mesh/cut/mouth.hpp"
#include "mesh/plane.hpp"
#include "mesh/side_index.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace spricka::sense {

namespace {

using base::Vec3;

constexpr double flatness =
    1e-6;                       // of the thickness or a radian: what is nearer lies in a flat face
constexpr double slant = 0.05;  // of a unit normal along the axis: curved sides of tetrahedra wave
constexpr double uneven = 1e-2; // of volumes and areas: flat sides of round bodies

enum class Flat { first, last, none };

// Sums f(point, area vector of a weight) over a side.
template <class F> void over_side(const model::Mesh& mesh, const model::Face& face, F&& f) {
  constexpr int degree = 4;
  const geometry::ElementSide side = model::element_side(mesh, face);
  side.for_quadrature_points(degree, [&](const base::Vec2& r, double weight) {
    f(side.position(r), Vec3(weight * side.area_vector(r)));
  });
}

/// Cuts one solid mesh across one axis.
class SectionCutter {
public:
  SectionCutter(const model::Mesh& mesh, const SectionPlane& plane) : mesh_(mesh), plane_(plane) {}

  std::optional<PlaneSectionMesh> run() {
    if (!sort_faces()) {
      return std::nullopt;
    }
    measure();
    if (!fills()) {
      return std::nullopt;
    }
    make_mesh();
    take_sets();
    return PlaneSectionMesh{plane_, std::move(made_), std::move(whole_),
                            std::move(whole_elements_)};
  }

private:
  [[nodiscard]] bool lies_at(const Vec3& x, double at) const {
    const double unit = plane_.round ? 1.0 : plane_.depth();
    double away = std::abs(plane_.normal_coordinate(x) - at);
    if (plane_.round) {
      away = std::min(away, std::abs(away - 2.0 * std::numbers::pi));
    }
    return away <= flatness * unit;
  }

  [[nodiscard]] Flat flat(const model::Face& face) const {
    bool first = true;
    bool last = true;
    for (const base::NodeId n : model::side_nodes(mesh_, face)) {
      const std::size_t i = n.index();
      first = first && first_[i];
      last = last && last_[i];
    }
    return first ? Flat::first : last ? Flat::last : Flat::none;
  }

  // Faces of the first end; false where a side runs neither along the axis nor across it.
  bool sort_faces() {
    for (const Vec3& x : mesh_.x) {
      const bool axis = plane_.round && plane_.section_coordinates(x).x() <= plane_.reach;
      first_.push_back(axis || lies_at(x, plane_.first));
      last_.push_back(axis || lies_at(x, plane_.last));
    }
    for (const model::Face& face : mesh::boundary_faces(mesh_)) {
      const Flat side = flat(face);
      if (side == Flat::first) {
        faces_.push_back(face);
      }
      bool runs_along = true;
      over_side(mesh_, face, [&](const Vec3& x, const Vec3& area) {
        runs_along = runs_along && std::abs(plane_.normal(x).dot(area)) <= slant * area.norm();
      });
      if (side == Flat::none && !runs_along) {
        return false;
      }
    }
    return !faces_.empty();
  }

  // Volumes of all elements, and what those in the section sweep along its whole depth.
  void measure() {
    volume_.assign(mesh_.element_count(), 0.0);
    swept_.assign(mesh_.element_count(), 0.0);
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (int s = 0; s < base::element_info(mesh_.type[e]).sides; ++s) {
        over_side(mesh_, {base::ElementId(e), s},
                  [&](const Vec3& x, const Vec3& area) { volume_[e] += x.dot(area) / 3.0; });
      }
    }
    for (const model::Face& face : faces_) {
      over_side(mesh_, face, [&](const Vec3& x, const Vec3& area) {
        const double radius = plane_.round ? plane_.section_coordinates(x).x() : 1.0;
        swept_[face.element.index()] += plane_.depth() * radius * area.norm();
      });
    }
  }

  /// Of some elements together.
  struct Filled {
    double volume = 0.0;
    double swept = 0.0;

    void add(const SectionCutter& cut, base::ElementId e) {
      volume += cut.volume_[e.index()];
      swept += cut.swept_[e.index()];
    }
    [[nodiscard]] bool wholly() const { return std::abs(volume - swept) <= uneven * volume; }
  };

  // Whether each property, in each net, is the same all along.
  [[nodiscard]] bool fills() const {
    std::map<std::pair<std::int32_t, std::int32_t>, Filled> parts;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      parts[{mesh_.property[e].value, mesh_.element_net[e].value}].add(*this, base::ElementId(e));
    }
    return std::ranges::all_of(parts, [](const auto& part) { return part.second.wholly(); });
  }

  void make_mesh() {
    made_.dim = 2;
    made_.first.assign(1, 0);
    new_node_.assign(mesh_.node_count(), base::NodeId());
    std::vector<bool> used(mesh_.node_count(), false);
    for (const model::Face& face : faces_) {
      for (const base::NodeId n : model::side_nodes(mesh_, face)) {
        used[n.index()] = true;
      }
    }
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (used[n]) {
        new_node_[n] = model::add_node(made_, plane_.section_coordinates(mesh_.x[n]),
                                       mesh_.node_label[n], mesh_.node_net[n]);
      }
    }
    for (const model::Face& face : faces_) {
      const std::size_t e = face.element.index();
      std::vector<base::NodeId> nodes;
      for (const base::NodeId n : model::side_nodes(mesh_, face)) {
        nodes.push_back(new_node_[n.index()]);
      }
      turn_left(nodes, shape::side_corner_count(mesh_.type[e], face.side));
      new_element_[face.element] =
          model::add_element(made_, shape::solid_side_type(mesh_.type[e], face.side), nodes,
                             mesh_.element_label[e], mesh_.element_net[e]);
      made_.property.back() = mesh_.property[e];
    }
  }

  // Corners run counter-clockwise in the section; mid nodes s lie between corners s and s + 1.
  void turn_left(std::vector<base::NodeId>& nodes, std::size_t corners) const {
    const auto at = [&](std::size_t k) -> base::Vec2 {
      return made_.x[nodes[k].index()].head<2>();
    };
    double area = 0.0;
    for (std::size_t k = 1; k + 1 < corners; ++k) {
      area += mesh::cross(at(k) - at(0), at(k + 1) - at(0));
    }
    if (area > 0.0) {
      return;
    }
    const auto begin = nodes.begin();
    const auto n = static_cast<std::ptrdiff_t>(corners);
    std::reverse(begin + 1, begin + n);
    if (nodes.size() >= 2 * corners) {
      std::reverse(begin + n, begin + 2 * n);
    }
  }

  void take_sets() {
    for (const model::ElementSet& set : mesh_.element_sets) {
      model::ElementSet& taken = made_.element_sets.emplace_back();
      taken.name = set.name;
      Filled filled;
      for (const base::ElementId e : set.elements) {
        filled.add(*this, e);
        if (const auto found = new_element_.find(e); found != new_element_.end()) {
          taken.elements.push_back(found->second);
        }
      }
      whole_elements_.push_back(filled.wholly());
    }
    const mesh::SideIndex sides(made_);
    for (const model::FaceSet& set : mesh_.face_sets) {
      take_faces(set, sides);
    }
    for (const model::NodeSet& set : mesh_.node_sets) {
      model::NodeSet& taken = made_.node_sets.emplace_back();
      taken.name = set.name;
      for (const base::NodeId n : set.nodes) {
        if (new_node_[n.index()].valid()) {
          taken.nodes.push_back(new_node_[n.index()]);
        }
      }
    }
  }

  void take_faces(const model::FaceSet& set, const mesh::SideIndex& sides) {
    model::FaceSet taken{set.name, {}, {}};
    double area = 0.0;
    bool flat_faces = false;
    for (const model::Face& face : set.faces) {
      flat_faces = flat_faces || flat(face) != Flat::none;
      over_side(mesh_, face, [&](const Vec3& /*x*/, const Vec3& part) { area += part.norm(); });
      const std::vector<base::NodeId> nodes = model::side_nodes(mesh_, face);
      const std::size_t corners =
          shape::side_corner_count(mesh_.type[face.element.index()], face.side);
      for (std::size_t c = 0; c < corners; ++c) {
        const base::NodeId a = new_node_[nodes[c].index()];
        const base::NodeId b = new_node_[nodes[(c + 1) % corners].index()];
        const auto found =
            a.valid() && b.valid() ? sides.find(std::array{a, b}) : std::span<const model::Face>();
        if (found.size() == 1) {
          taken.faces.push_back(found.front());
        }
      }
    }
    std::ranges::sort(taken.faces);
    taken.faces.erase(std::unique(taken.faces.begin(), taken.faces.end()), taken.faces.end());
    double swept = 0.0;
    for (const model::Face& face : taken.faces) {
      over_side(made_, face, [&](const Vec3& x, const Vec3& part) {
        swept += plane_.depth() * (plane_.round ? x.x() : 1.0) * part.norm();
      });
    }
    whole_.push_back(!flat_faces && std::abs(swept - area) <= uneven * area);
    made_.face_sets.push_back(std::move(taken));
  }

  const model::Mesh& mesh_;
  SectionPlane plane_;
  std::vector<bool> first_, last_; ///< [node] lies in that end
  std::vector<model::Face> faces_; ///< of the first end
  std::vector<base::NodeId> new_node_;
  std::map<base::ElementId, base::ElementId> new_element_;
  model::Mesh made_;
  std::vector<bool> whole_, whole_elements_;
  std::vector<double> volume_, swept_; ///< [element]
};

} // namespace

std::vector<PlaneSectionMesh> find_extruded_sections(const model::Mesh& mesh) {
  const std::vector<bool> used = model::mark_nodes_in_use(mesh);
  std::vector<PlaneSectionMesh> found;
  for (const int axis : {2, 1, 0}) {
    SectionPlane plane{false, axis};
    plane.first = std::numeric_limits<double>::max();
    plane.last = std::numeric_limits<double>::lowest();
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      if (used[n]) {
        plane.first = std::min(plane.first, mesh.x[n][axis]);
        plane.last = std::max(plane.last, mesh.x[n][axis]);
      }
    }
    if (std::optional<PlaneSectionMesh> section = SectionCutter(mesh, plane).run()) {
      found.push_back(std::move(*section));
    }
  }
  return found;
}

std::vector<PlaneSectionMesh> find_revolved_sections(const model::Mesh& mesh) {
  const std::vector<bool> used = model::mark_nodes_in_use(mesh);
  std::vector<PlaneSectionMesh> found;
  for (const int axis : {2, 1, 0}) {
    SectionPlane plane{true, axis};
    double size = 0.0;
    for (const Vec3& x : mesh.x) {
      size = std::max(size, plane.section_coordinates(x).x());
    }
    plane.reach = flatness * size;
    std::vector<double> angles;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      if (used[n] && plane.section_coordinates(mesh.x[n]).x() > plane.reach) {
        angles.push_back(plane.normal_coordinate(mesh.x[n]));
      }
    }
    std::ranges::sort(angles);
    // The bodies leave out the largest gap.
    constexpr double turn = 2.0 * std::numbers::pi;
    double widest = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const bool ends = i + 1 == angles.size();
      const double next = ends ? angles.front() + turn : angles[i + 1];
      if (next - angles[i] > widest) {
        widest = next - angles[i];
        plane.first = ends ? angles.front() : angles[i + 1];
      }
    }
    plane.last = plane.first + turn - widest;
    if (!(widest > 0.25 * turn)) {
      continue; // a whole turn, or nearly
    }
    if (std::optional<PlaneSectionMesh> section = SectionCutter(mesh, plane).run()) {
      found.push_back(std::move(*section));
    }
  }
  return found;
}

std::vector<base::NodeId> project_nodes_onto_section(const PlaneSectionMesh& section,
                                                     const model::Mesh& space,
                                                     const std::vector<base::NodeId>& nodes) {
  const std::vector<Vec3>& x = section.mesh.x;
  std::vector<std::size_t> order(x.size());
  double size = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    order[i] = i;
    size = std::max(size, x[i].lpNorm<Eigen::Infinity>());
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return x[i].x(); });
  std::vector<base::NodeId> found;
  for (const base::NodeId n : nodes) {
    const Vec3 at = section.plane.section_coordinates(space.x[n.index()]);
    auto it = std::ranges::lower_bound(order, at.x() - flatness * size, {},
                                       [&](std::size_t i) { return x[i].x(); });
    for (; it != order.end() && x[*it].x() <= at.x() + flatness * size; ++it) {
      const bool same_net = section.mesh.node_net[*it] == space.node_net[n.index()];
      if (same_net && std::abs(x[*it].y() - at.y()) <= flatness * size) {
        found.emplace_back(*it);
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::optional<Vec3> find_line_exit_from_net(const model::Mesh& section, base::NetId net,
                                            const Vec3& from, const Vec3& through) {
  const mesh::HostMesh host(section);
  const base::Vec2 way = (through - from).head<2>();
  double nearest = std::numeric_limits<double>::infinity();
  for (const model::Face& face : host.boundary()) {
    if (!mesh::is_face_element_in_net(section, face, net)) {
      continue;
    }
    const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(section, face);
    constexpr int pieces = 8; // of a curved edge
    for (int k = 0; k < pieces; ++k) {
      const auto at = [&](int i) -> base::Vec2 {
        return mesh::point_on_edge(section, edge, 2.0 * i / pieces - 1.0).head<2>();
      };
      const base::Vec2 a = at(k) - from.head<2>();
      const base::Vec2 chord = at(k + 1) - at(k);
      const double turn = mesh::cross(way, chord);
      const double t = mesh::cross(a, chord) / turn; // on the way
      const double u = mesh::cross(a, way) / turn;   // on the chord
      constexpr double room = 1e-9;
      if (std::isfinite(t) && t > room && u >= -room && u <= 1.0 + room) {
        nearest = std::min(nearest, t);
      }
    }
  }
  if (!std::isfinite(nearest)) {
    return std::nullopt;
  }
  const Vec3 out = from + nearest * Vec3(way.x(), way.y(), 0.0);
  return mesh::find_crack_mouth(host, out, net).at;
}

} // namespace spricka::sense
