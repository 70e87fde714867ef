// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "contact/plane_features.hpp"
#include "contact/space/facet_surface.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <vector>

/// Contact surfaces: facets and their parts (contact/space/facet_surface.hpp), in the plane
/// their order along curves (plane_features.hpp).
namespace spricka::contact {

/// A circle that all nodes of a surface lie on.
struct SurfaceCircle {
  Vec2 centre = Vec2::Zero();
  double radius = 0.0;
  bool exact = false; ///< all nodes lie on it within 1e-6 of the radius
};

struct ContactSurface : FacetSurface {
  PlanarEdgeChains plane; ///< order of the facets; none in space
  std::optional<SurfaceCircle> circle;
  double stiffness = 0.0; ///< Young's modulus behind the surface
  double thickness = 0.0; ///< of the thinnest element; 1 in space
  bool axial = false;     ///< a meridian: x is the radius, the surface goes round the axis
};

/// What a unit of length at a point of the section stands for: the smaller thickness, about an axis
/// the whole circumference there; in space 1.
double out_of_plane_depth(const ContactSurface& contact, const ContactSurface& target,
                          const Vec2& x);

/// In the plane strings the faces of a set into chains and looks whether they lie on one circle
/// (deviation below 1e-4 of the radius, radius below 1e3 extents); in space
/// make_facet_surface().
ContactSurface make_contact_surface(const model::Model& model, const model::Mesh& mesh,
                                    base::FaceSetId set);
ContactSurface make_contact_surface(const model::Model& model, const model::Mesh& mesh,
                                    const std::vector<model::Face>& faces);

/// Unit normal of the surface at a point of a facet: that of the circle or of the shape that its
/// part lies on, where there is one.
Vec3 surface_normal(const ContactSurface& surface, std::size_t facet,
                    const geometry::SidePoint& at);
/// The same at a point of an edge.
Vec2 surface_normal(const ContactSurface& surface, const Edge& edge, double xi);

} // namespace spricka::contact
