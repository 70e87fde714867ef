// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/hat_elements.hpp"
#include "contact/space/round.hpp"
#include "model/mesh.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::contact {

/// A piece of a facet between its nodes, which hats of the pressure are linear on: in the plane an
/// edge or half of one, in space a triangle.
struct HatElement {
  std::size_t facet = 0;
  HatNodes node{}; ///< of the facet

  [[nodiscard]] std::size_t node_count() const { return node[2] < 0 ? 2 : 3; }
};

/// A node on a smooth part of a surface: at a ridge one node is one of each part.
using SmoothPartNode = std::pair<std::size_t, base::NodeId>;

/// A surface: its facets, in space the smooth parts they belong to and the shapes of these.
struct FacetSurface {
  int dim = 2;                               ///< of the bodies; of a surface without facets 2
  std::vector<geometry::ElementSide> facets; ///< edges of plane elements or faces of solids
  std::vector<std::size_t> part;             ///< [facet]; in the plane all are of one part
  std::vector<std::optional<AnalyticShape>> rounds; ///< [part] in space; in the plane none
  /// Facet by facet; all nodes belong to some, or only the corners of faces.
  std::vector<HatElement> elements;
  double extent = 0.0;    ///< diagonal of the bounding box [length]
  double mean_size = 0.0; ///< mean length of edges, root of the mean area of faces [length]

  [[nodiscard]] SmoothPartNode part_node(const HatElement& element, std::size_t i) const {
    return {part[element.facet],
            facets[element.facet].nodes[static_cast<std::size_t>(element.node[i])]};
  }
  [[nodiscard]] const std::optional<AnalyticShape>& analytic_shape(std::size_t facet) const {
    return rounds[part[facet]];
  }
};

/// The nodes of a surface's elements, one for each of their parts: in the plane in the order of the
/// edges, mid nodes between their ends, in space by part and node.
std::vector<SmoothPartNode> smooth_part_nodes(const FacetSurface& surface);

/// The surface that faces of elements make up, in their order. Its shapes are those of the first
/// `deck_nodes` nodes of the mesh, where they are half of a part at least: the nodes of patches lie
/// off the shape by 1e-9 of its size, and others each time a crack is cut.
FacetSurface make_facet_surface(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                std::size_t deck_nodes);

/// Length of an edge, area of a face.
double facet_length_or_area(const geometry::ElementSide& facet);

/// The triangles of a surface in space between corners only, face by face.
std::vector<HatElement> corner_triangles(const FacetSurface& surface);

/// Unit normal of the surface at a point x of a facet, given what the facet itself has there: that
/// of its shape where it has one.
Vec3 surface_normal(const FacetSurface& surface, std::size_t facet, const geometry::SidePoint& at);

} // namespace spricka::contact
