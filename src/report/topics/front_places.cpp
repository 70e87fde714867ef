// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/front_places.hpp"

#include "geometry/box.hpp"
#include "model/mesh_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace spricka::report {
namespace {

/// Names of the sets of a crack's faces end so.
bool is_of_crack_faces(std::string_view name) {
  return name.ends_with(".LEFT") || name.ends_with(".RIGHT");
}

bool has_one_net(const model::Mesh& mesh) {
  return std::ranges::all_of(mesh.element_net,
                             [&](base::NetId net) { return net == mesh.element_net.front(); });
}

double size_of_elements_at(const model::Mesh& mesh, base::NodeId n) {
  double size = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    if (std::ranges::find(nodes, n) != nodes.end()) {
      for (const base::NodeId other : nodes) {
        size = std::max(size, (mesh.x[other.index()] - mesh.x[n.index()]).norm());
      }
    }
  }
  return size;
}

/// The nearest node, of the cracked body where several meet: of a crack's face.
base::NodeId node_at(const model::Mesh& mesh, const base::Vec3& x) {
  std::vector<base::NodeId> of_cracks;
  for (const model::FaceSet& set : mesh.face_sets) {
    for (const model::Face& face : set.faces) {
      if (is_of_crack_faces(set.name)) {
        const std::vector<base::NodeId> nodes = model::side_nodes(mesh, face);
        of_cracks.insert(of_cracks.end(), nodes.begin(), nodes.end());
      }
    }
  }
  return *std::ranges::min_element(
      of_cracks.empty() ? mesh.nodes : of_cracks, {},
      [&](base::NodeId n) { return (mesh.x[n.index()] - x).squaredNorm(); });
}

/// "z = 5" of a place at an end of the mesh along an axis; else empty.
std::string plane_of_end(const model::Mesh& mesh, const base::Vec3& x, double near) {
  geometry::Box<3> box;
  for (const base::NodeId n : mesh.nodes) {
    box.extend({mesh.x[n.index()], mesh.x[n.index()]});
  }
  for (const Eigen::Index c : {2, 1, 0}) {
    if (std::min(std::abs(x[c] - box.low[c]), std::abs(x[c] - box.high[c])) < near) {
      return fmt::format("{} = {:.4g}", "xyz"[c], std::abs(x[c]) < near ? 0.0 : x[c]);
    }
  }
  return {};
}

void add_place(std::vector<FrontPlace>& places, std::string name,
               const results::FrontPointResult& point) {
  const auto known = std::ranges::find(places, &point, &FrontPlace::point);
  if (known == places.end()) {
    places.push_back({std::move(name), &point});
  } else {
    known->name += ", " + name;
  }
}

std::string end_name(const FaceNames& faces, const results::FrontPointResult& end) {
  const std::string face = faces.at(end.x);
  return face.empty() ? "end" : "at " + face;
}

} // namespace

std::string FaceNames::at(const base::Vec3& x) const {
  if (mesh_.nodes.empty()) {
    return {};
  }
  const base::NodeId n = node_at(mesh_, x);
  const double near = 1e-6 * size_of_elements_at(mesh_, n);
  std::string best;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  const auto offer = [&](const std::string& name, std::size_t size, bool inside) {
    if (inside && size < fewest) {
      best = name;
      fewest = size;
    }
  };
  for (const model::FaceSet& set : mesh_.face_sets) {
    if (set.name.empty() || is_of_crack_faces(set.name)) {
      continue;
    }
    offer(set.name, set.faces.size(), std::ranges::any_of(set.faces, [&](const model::Face& face) {
            return std::ranges::any_of(model::side_nodes(mesh_, face), [&](base::NodeId other) {
              return other == n || (mesh_.node_net[other.index()] == mesh_.node_net[n.index()] &&
                                    (mesh_.x[other.index()] - x).norm() < near);
            });
          }));
  }
  for (const model::NodeSet& set : mesh_.node_sets) {
    if (best.empty() && !set.name.empty()) {
      offer(set.name, set.nodes.size(), std::ranges::find(set.nodes, n) != set.nodes.end());
    }
  }
  if (best.empty()) {
    return plane_of_end(mesh_, x, near);
  }
  const std::size_t dot = best.find('.');
  return dot != std::string::npos && has_one_net(mesh_) ? best.substr(dot + 1) : best;
}

const results::FrontPointResult& worst_point(const results::FrontResult& front) {
  const results::FrontPointResult* worst = nullptr;
  for (const results::FrontPointResult& point : front.points) {
    if (!point.at_surface && (worst == nullptr || point.K1 > worst->K1)) {
      worst = &point;
    }
  }
  return worst != nullptr
             ? *worst
             : *std::ranges::max_element(front.points, {}, &results::FrontPointResult::K1);
}

std::vector<FrontPlace> front_places(const results::FrontResult& front, const FaceNames& faces) {
  std::vector<FrontPlace> places;
  if (front.points.empty()) {
    return places;
  }
  if (front.is_tip()) {
    return {{.name = "", .point = &front.points.front()}};
  }
  if (front.is_loop) {
    add_place(places, "smallest",
              *std::ranges::min_element(front.points, {}, &results::FrontPointResult::K1));
  } else {
    add_place(places, end_name(faces, front.points.front()), front.points.front());
    add_place(places, "middle", *std::ranges::min_element(front.points, {}, [&](const auto& p) {
                return std::abs(p.s - 0.5 * front.points.back().s);
              }));
    add_place(places, end_name(faces, front.points.back()), front.points.back());
  }
  add_place(places, "largest", worst_point(front));
  std::ranges::sort(places, {}, [](const FrontPlace& place) { return place.point->number; });
  return places;
}

std::vector<std::size_t> reported_growth_points(const results::GrowthResult& growth) {
  constexpr std::size_t most = 4;
  std::vector<std::size_t> reported;
  const std::vector<std::string>& names = growth.point_names;
  const auto crack_of = [](const std::string& name) { return name.substr(0, name.rfind('.')); };
  for (std::size_t first = 0; first < names.size();) {
    std::size_t end = first + 1;
    while (end < names.size() && crack_of(names[end]) == crack_of(names[first])) {
      ++end;
    }
    const std::size_t count = end - first;
    for (std::size_t i = first; i < end; ++i) {
      if (count <= most || i == first || i + 1 == end || i == first + count / 2) {
        reported.push_back(i);
      }
    }
    first = end;
  }
  return reported;
}

} // namespace spricka::report
