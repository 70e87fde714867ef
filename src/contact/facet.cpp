// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/facet.hpp"

#include "mesh/plane_edge.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spricka::contact {

namespace {

shape::ReferenceDomain domain_of(std::size_t corners) {
  return corners == 2   ? shape::ReferenceDomain::line
         : corners == 3 ? shape::ReferenceDomain::triangle
                        : shape::ReferenceDomain::quadrilateral;
}

} // namespace

ContactFacet make_facet(const model::Mesh& mesh, const model::Face& face) {
  const base::ElementType type = mesh.type[face.element.index()];
  const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
  ContactFacet facet{face, domain_of(shape::side_corners(type, face.side)), {}};
  for (const int local : shape::side_nodes(type, face.side)) {
    facet.nodes.push_back(nodes[static_cast<std::size_t>(local)]);
  }
  return facet;
}

FacetValues facet_N(const ContactFacet& facet, const Vec2& r) {
  assert(facet.domain == shape::ReferenceDomain::line);
  return mesh::edge_N(static_cast<int>(facet.nodes.size()), r[0]);
}

FacetValues facet_hats(const ContactFacet& facet, const Vec2& r) {
  assert(facet.domain == shape::ReferenceDomain::line);
  return line_hats(static_cast<int>(facet.nodes.size()), r[0]);
}

FacetValues line_hats(int count, double xi) {
  if (count == 2) {
    return {0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0};
  }
  return {std::max(0.0, -xi), std::max(0.0, xi), 1.0 - std::abs(xi)};
}

} // namespace spricka::contact
