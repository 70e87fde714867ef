// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/shown_surface.hpp"

#include "geometry/box.hpp"
#include "model/property_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace spricka::report {
namespace {

/// Corners and mid nodes in turn.
results::OuterSurfaceFace outline_of_plane_element(const model::Mesh& mesh, base::ElementId e) {
  const base::ElementInfo& info = base::element_info(mesh.type[e.index()]);
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  const auto corners = static_cast<std::size_t>(info.corners);
  results::OuterSurfaceFace face{.element = e, .outline = {}};
  for (std::size_t i = 0; i < corners; ++i) {
    face.outline.push_back(nodes[i]);
    if (info.quadratic) {
      face.outline.push_back(nodes[corners + i]);
    }
  }
  return face;
}

/// Places as whole numbers, the same for nodes that lie on each other.
class PlaceNumbers {
public:
  using Key = std::array<long long, 4>;

  explicit PlaceNumbers(const model::Mesh& mesh) : mesh_(mesh) {
    geometry::Box<3> box;
    for (const base::NodeId n : mesh.nodes) {
      box.extend({mesh.x[n.index()], mesh.x[n.index()]});
    }
    constexpr double one_place = 1e-9; // of the model's size
    step_ = std::max(one_place * box.diagonal(), 1e-300);
    low_ = box.low;
  }
  /// Of a node of a body.
  [[nodiscard]] Key key(base::NodeId n, std::uint32_t body) const {
    const base::Vec3 d = (mesh_.x[n.index()] - low_) / step_;
    return {std::llround(d[0]), std::llround(d[1]), std::llround(d[2]), body};
  }

private:
  const model::Mesh& mesh_;
  base::Vec3 low_;
  double step_ = 1.0;
};

/// Adds what points at one place are to each other, if just two nodes of a body are there: the
/// partner of a point is the first one of the other node.
void pair_points(const ShownSurface& surface, std::span<const std::uint32_t> points,
                 std::vector<std::uint32_t>& pairs) {
  const base::NodeId first = surface.node[points.front()];
  const auto is_first = [&](std::uint32_t p) { return surface.node[p] == first; };
  const auto other = std::ranges::find_if_not(points, is_first);
  if (other == points.end()) {
    return;
  }
  const base::NodeId second = surface.node[*other];
  if (std::ranges::all_of(
          points, [&](std::uint32_t p) { return is_first(p) || surface.node[p] == second; })) {
    for (const std::uint32_t p : points) {
      pairs.insert(pairs.end(), {p, is_first(p) ? *other : points.front()});
    }
  }
}

std::vector<std::uint32_t> pair_coincident(const model::Mesh& mesh, const ShownSurface& surface,
                                           const std::vector<std::uint32_t>& body_of_point) {
  const PlaceNumbers places(mesh);
  std::vector<std::pair<PlaceNumbers::Key, std::uint32_t>> sorted;
  sorted.reserve(surface.node.size());
  for (std::uint32_t p = 0; p < surface.node.size(); ++p) {
    sorted.emplace_back(places.key(surface.node[p], body_of_point[p]), p);
  }
  std::ranges::sort(sorted);
  std::vector<std::uint32_t> pairs;
  std::vector<std::uint32_t> here;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    here.push_back(sorted[i].second);
    if (i + 1 == sorted.size() || sorted[i + 1].first != sorted[i].first) {
      pair_points(surface, here, pairs);
      here.clear();
    }
  }
  return pairs;
}

} // namespace

ShownSurface make_shown_surface(const results::CrackLengthResult& increment) {
  const model::Mesh& mesh = increment.mesh;
  const model::FieldPointsByProperty sources = model::property_points(mesh);
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  std::vector<std::uint32_t> point_of(sources.node.size(), none);
  ShownSurface surface;
  std::vector<std::uint32_t> body_of_point;
  const auto add_face = [&](const results::OuterSurfaceFace& face) {
    const std::size_t e = face.element.index();
    const base::NetId net = mesh.element_net[e];
    const std::uint32_t body = net.valid() ? static_cast<std::uint32_t>(net.index()) : 0U;
    const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
    for (const base::NodeId n : face.outline) {
      const auto local = std::ranges::find(nodes, n) - nodes.begin();
      const auto source =
          static_cast<std::size_t>(sources.of[static_cast<std::size_t>(mesh.first[e] + local)]);
      if (point_of[source] == none) {
        point_of[source] = static_cast<std::uint32_t>(surface.node.size());
        surface.node.push_back(n);
        surface.source.push_back(source);
        body_of_point.push_back(body);
      }
      surface.outline.push_back(point_of[source]);
    }
    const bool curved = base::element_info(mesh.type[e]).quadratic;
    surface.kind.push_back(static_cast<std::uint32_t>(face.outline.size()) +
                           (curved ? ShownSurface::has_mid_nodes : 0U));
    surface.body.push_back(body);
  };
  if (increment.surface.empty()) {
    for (const base::ElementId e : model::all_elements(mesh)) {
      add_face(outline_of_plane_element(mesh, e));
    }
  } else {
    std::ranges::for_each(increment.surface, add_face);
  }
  surface.coincident = pair_coincident(mesh, surface, body_of_point);
  return surface;
}

} // namespace spricka::report
