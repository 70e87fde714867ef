// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"
#include "shape/shape.hpp"

#include <array>
#include <vector>

/// What contact surfaces consist of, whatever the dimension: sides of elements.
namespace spricka::contact {

using base::Vec2;

/// One side of an element. Its reference coordinates r have two places; a line uses the first.
struct ContactFacet {
  model::Face face;
  shape::ReferenceDomain domain = shape::ReferenceDomain::line; ///< that r runs over
  std::vector<base::NodeId> nodes; ///< corners first; with the domain they tell the shape
};

ContactFacet make_facet(const model::Mesh& mesh, const model::Face& face);

/// One number for each node of a facet; those behind its last node are zero.
using FacetValues = std::array<double, 3>;

/// Shape functions of a facet at r; lines of two and three nodes.
FacetValues facet_N(const ContactFacet& facet, const Vec2& r);

/// Hats on half edges: piecewise linear, non-negative, sum 1; lines of two and three nodes.
/// Pressures of SEGMENT pairs are sums of these.
FacetValues facet_hats(const ContactFacet& facet, const Vec2& r);

/// The same by the number of nodes on a line.
FacetValues line_hats(int count, double xi);

} // namespace spricka::contact
