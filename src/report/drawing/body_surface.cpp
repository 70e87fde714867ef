// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/body_surface.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace spricka::report {
namespace {

constexpr double kink_cosine = 0.9; // 26 degrees

using EdgeEnds = std::pair<base::NodeId, base::NodeId>;

/// Outlines of faces of second order have a node in the middle of each edge.
std::size_t nodes_of_edge(const model::Mesh& mesh, const results::OuterSurfaceFace& face) {
  return base::element_info(mesh.type[face.element.index()]).quadratic ? 2 : 1;
}

/// Normals of the faces that meet at each edge of the surface, by its ends.
std::map<EdgeEnds, std::vector<base::Vec3>>
normals_at_edges(const results::CrackLengthResult& increment, base::NetId net) {
  const model::Mesh& mesh = increment.mesh;
  std::map<EdgeEnds, std::vector<base::Vec3>> normals;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    if (net.valid() && mesh.element_net[face.element.index()] != net) {
      continue;
    }
    const std::size_t n = face.outline.size();
    const std::size_t step = nodes_of_edge(mesh, face);
    const base::Vec3 normal = doubled_area_vector(mesh, face.outline).normalized();
    for (std::size_t i = 0; i < n; i += step) {
      normals[std::minmax(face.outline[i], face.outline[(i + step) % n])].push_back(normal);
    }
  }
  return normals;
}

bool is_ridge(const std::vector<base::Vec3>& normals) {
  return normals.size() != 2 || normals[0].dot(normals[1]) < kink_cosine;
}

/// Light comes over the left shoulder.
double light_on(const base::Vec3& normal, const PictureViewpoint& eye) {
  const base::Vec3 lamp = (0.8 * eye.towards - 0.35 * eye.right + 0.5 * eye.up).normalized();
  return std::clamp(0.6 + 0.4 * std::max(0.0, normal.dot(lamp)), 0.0, 1.0);
}

} // namespace

std::vector<DrawnFacet> facets_towards_eye(const results::CrackLengthResult& increment,
                                           const SurfaceViewpoint& view) {
  const model::Mesh& mesh = increment.mesh;
  const auto normals = normals_at_edges(increment, view.net);
  const auto place = [&](base::NodeId n) {
    base::Vec3 x = mesh.x[n.index()];
    if (view.u != nullptr && view.magnify > 0.0) {
      x += view.magnify * view.u->segment<3>(static_cast<Eigen::Index>(3 * n.index()));
    }
    return x;
  };
  std::vector<DrawnFacet> facets;
  for (const results::OuterSurfaceFace& face : increment.surface) {
    if (view.net.valid() && mesh.element_net[face.element.index()] != view.net) {
      continue;
    }
    const std::size_t n = face.outline.size();
    DrawnFacet facet{.face = &face, .outline = {}, .ridges = {}};
    base::Vec3 area = base::Vec3::Zero();
    base::Vec3 centre = base::Vec3::Zero();
    const base::Vec3 origin = place(face.outline.front());
    for (std::size_t i = 0; i < n; ++i) {
      const base::Vec3 x = place(face.outline[i]);
      area += (x - origin).cross(place(face.outline[(i + 1) % n]) - origin);
      centre += x / static_cast<double>(n);
      facet.outline.push_back(view.eye(x));
    }
    if (area.dot(view.eye.towards) <= 0.0) {
      continue;
    }
    const std::size_t step = nodes_of_edge(mesh, face);
    for (std::size_t i = 0; i < n; i += step) {
      if (is_ridge(normals.at(std::minmax(face.outline[i], face.outline[(i + step) % n])))) {
        std::vector<DrawingPoint>& ridge = facet.ridges.emplace_back();
        for (std::size_t k = 0; k <= step; ++k) {
          ridge.push_back(facet.outline[(i + k) % n]);
        }
      }
    }
    facet.depth = centre.dot(view.eye.towards);
    facet.light = light_on(area.normalized(), view.eye);
    facets.push_back(std::move(facet));
  }
  std::ranges::stable_sort(facets, {}, &DrawnFacet::depth);
  return facets;
}

SurfaceSides::SurfaceSides(const results::CrackLengthResult& increment, const PictureViewpoint& eye)
    : towards_(eye.towards) {
  for (const results::OuterSurfaceFace& face : increment.surface) {
    const bool seen = doubled_area_vector(increment.mesh, face.outline).dot(towards_) > 0.0;
    for (const base::NodeId n : face.outline) {
      const base::Vec3& x = increment.mesh.x[n.index()];
      bool& at = at_node_[{x[0], x[1], x[2]}];
      at = at || seen;
    }
  }
}

bool SurfaceSides::faces_eye(const base::Vec3& x, const base::Vec3& normal) const {
  const auto node = at_node_.find({x[0], x[1], x[2]});
  return node != at_node_.end() ? node->second : normal.isZero() || normal.dot(towards_) > 0.0;
}

PictureViewpoint slanted_viewpoint() {
  return PictureViewpoint::looking_from(base::Vec3(0.5, -0.75, 0.45).normalized(),
                                        base::Vec3::UnitZ());
}

std::string shaded_colour(std::string_view colour, double light) {
  std::string shaded = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string part(colour.substr(1 + 2 * c, 2));
    const double full = static_cast<double>(std::strtol(part.c_str(), nullptr, 16));
    shaded += fmt::format("{:02x}", static_cast<int>(std::lround(light * full)));
  }
  return shaded;
}

void draw_axes(SvgDrawing& svg, const PictureViewpoint& eye, DrawingPoint at) {
  constexpr double length = 24.0;
  for (int c = 0; c < 3; ++c) {
    const DrawingPoint way = eye(base::Vec3::Unit(c));
    if (std::hypot(way.x, way.y) < 0.15) { // it points to the eye
      continue;
    }
    svg.line(at, {at.x + length * way.x, at.y - length * way.y}, {"#000", 1.1, "none", ""});
    svg.text({at.x + 1.35 * length * way.x, at.y - 1.35 * length * way.y + 4.0},
             std::string(1, "xyz"[c]), {TextAnchor::middle, 11.0});
  }
}

} // namespace spricka::report
