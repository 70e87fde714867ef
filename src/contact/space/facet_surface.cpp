// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/facet_surface.hpp"

#include "base/by_dimension.hpp"
#include "contact/space/patches.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

std::optional<AnalyticShape> shape_of(const model::Mesh& mesh, const FacetSurface& surface,
                                      std::size_t part, std::size_t deck_nodes) {
  std::set<base::NodeId> nodes;
  std::vector<PointNormal> normals;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.part[f] == part) {
      const geometry::ElementSide& face = surface.facets[f];
      nodes.insert(face.nodes.begin(), face.nodes.end());
      const geometry::SidePoint centre = face.point(face.domain_centre());
      normals.push_back({centre.x, centre.area_vector().normalized()});
    }
  }
  const auto is_deck_node = [&](base::NodeId n) { return n.index() < deck_nodes; };
  const bool few =
      2 * static_cast<std::size_t>(std::ranges::count_if(nodes, is_deck_node)) < nodes.size();
  std::vector<Vec3> points;
  points.reserve(nodes.size());
  for (const base::NodeId n : nodes) {
    if (few || is_deck_node(n)) {
      points.push_back(mesh.x[n.index()]);
    }
  }
  return fit_analytic_shape(points, normals, surface.extent);
}

} // namespace

FacetSurface make_facet_surface(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                std::size_t deck_nodes) {
  FacetSurface surface;
  geometry::Box<3> box;
  double size = 0.0;
  for (const model::Face& face : faces) {
    const geometry::ElementSide& own = surface.facets.emplace_back(model::element_side(mesh, face));
    box.extend({own.X.rowwise().minCoeff(), own.X.rowwise().maxCoeff()});
    size += facet_length_or_area(own);
    for (const HatNodes& nodes : hat_elements(own)) {
      surface.elements.push_back({surface.facets.size() - 1, nodes});
    }
  }
  if (surface.facets.empty()) {
    return surface;
  }
  surface.dim = mesh.dim;
  size /= static_cast<double>(surface.facets.size());
  surface.extent = box.diagonal();
  surface.mean_size = std::pow(size, 1.0 / surface.facets.front().local_dim());
  if (surface.facets.front().is_edge()) {
    surface.part.assign(surface.facets.size(), 0);
    surface.rounds.resize(1);
    return surface;
  }
  surface.part = smooth_part_numbers(surface.facets);
  const std::size_t parts = *std::ranges::max_element(surface.part) + 1;
  for (std::size_t p = 0; p < parts; ++p) {
    surface.rounds.push_back(shape_of(mesh, surface, p, deck_nodes));
  }
  return surface;
}

std::vector<SmoothPartNode> smooth_part_nodes(const FacetSurface& surface) {
  constexpr base::ByDimension along_edges{true, false};
  std::set<SmoothPartNode> seen;
  std::vector<SmoothPartNode> nodes;
  for (const HatElement& element : surface.elements) {
    for (std::size_t i = 0; i < element.node_count(); ++i) {
      if (seen.insert(surface.part_node(element, i)).second) {
        nodes.push_back(surface.part_node(element, i));
      }
    }
  }
  return along_edges.at(surface.dim) ? nodes
                                     : std::vector<SmoothPartNode>(seen.begin(), seen.end());
}

double facet_length_or_area(const geometry::ElementSide& facet) {
  constexpr int edge_degree = 5; // 1e-8 of the length of arcs of 30 degrees
  return facet.is_edge() ? facet.area(edge_degree) : facet.area();
}

std::vector<HatElement> corner_triangles(const FacetSurface& surface) {
  std::vector<HatElement> triangles;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    for (const HatNodes& nodes : corner_hat_elements(surface.facets[f])) {
      triangles.push_back({f, nodes});
    }
  }
  return triangles;
}

Vec3 surface_normal(const FacetSurface& surface, std::size_t facet, const geometry::SidePoint& at) {
  Vec3 n = at.area_vector().normalized();
  const std::optional<AnalyticShape>& round = surface.analytic_shape(facet);
  if (!round) {
    return n;
  }
  const Vec3 exact = outer_normal(*round, at.x);
  // On an axis or in a centre the shape has no normal; a facet turned inside out keeps its own.
  return exact.dot(n) > 0.5 ? exact : n;
}

} // namespace spricka::contact
