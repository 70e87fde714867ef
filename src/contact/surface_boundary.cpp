// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/surface_boundary.hpp"

#include "base/by_dimension.hpp"
#include "base/index.hpp"
#include "contact/space/hat_elements.hpp"
#include "model/mesh_side.hpp"

namespace spricka::contact {

using base::index;

namespace {

constexpr int parts = 4; // straight pieces for a quadratic edge

// Points along a chain, its last one too where it is open.
std::vector<Vec3> points_along(std::span<const Edge> edges, bool closed, const base::Vector& u) {
  std::vector<Vec3> points;
  const auto add = [&](const Vec2& x) { points.emplace_back(x.x(), x.y(), 0.0); };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    Edge edge = edges[e];
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count) && u.size() > 0; ++i) {
      edge.x[i] += u.segment<2>(2 * index(edge.nodes[i].index()));
    }
    const int n = edge.count == 3 ? parts : 1;
    for (int k = 0; k < n; ++k) {
      add(point_on_edge(edge, -1.0 + 2.0 * k / n));
    }
    if (!closed && e + 1 == edges.size()) {
      add(edge.x[1]);
    }
  }
  return points;
}

geometry::BodyBoundary boundary_of_edges(const model::Model& model, const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces,
                                         const base::Vector& u) {
  return make_displaced_plane_boundary(make_contact_surface(model, mesh, faces), u);
}

geometry::BodyBoundary boundary_of_faces(const model::Model& /*model*/, const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces,
                                         const base::Vector& u) {
  std::vector<geometry::FlatBoundaryFacet> facets;
  for (const model::Face& side : faces) {
    const geometry::ElementSide face = model::element_side(mesh, side);
    for (const HatNodes& t : hat_elements(face)) {
      geometry::FlatBoundaryFacet& facet = facets.emplace_back();
      for (std::size_t i = 0; i < t.size(); ++i) {
        const std::size_t node = face.nodes[static_cast<std::size_t>(t[i])].index();
        facet.vertex[i] = node;
        facet.x[i] = mesh.x[node];
        if (u.size() > 0) {
          facet.x[i] += u.segment<3>(3 * index(node));
        }
      }
    }
  }
  return {3, facets};
}

} // namespace

geometry::BodyBoundary make_displaced_plane_boundary(const ContactSurface& surface,
                                                     const base::Vector& u) {
  std::vector<geometry::FlatBoundaryFacet> facets;
  std::size_t first = 0; // vertex of a chain: chains that touch do not hang together
  for (const EdgeChain& chain : surface.plane.chains) {
    const std::vector<Vec3> points =
        points_along(surface.plane.edges_of_chain(chain), chain.closed, u);
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      facets.push_back({{points[i], points[next], points[next]}, {first + i, first + next, 0}});
    }
    first += points.size();
  }
  return {2, facets};
}

geometry::BodyBoundary make_displaced_body_boundary(const model::Model& model,
                                                    const model::Mesh& mesh,
                                                    const std::vector<model::Face>& faces,
                                                    const base::Vector& u) {
  constexpr base::ByDimension make{boundary_of_edges, boundary_of_faces};
  return make.at(mesh.dim)(model, mesh, faces, u);
}

} // namespace spricka::contact
