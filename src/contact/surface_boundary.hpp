// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/surface.hpp"
#include "geometry/body_boundary.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::contact {

/// The boundary of a body of these sides, moved by u [dim * node] [length]; empty: as drawn. In the
/// plane quadratic edges become four straight ones; in space each face is cut into the triangles
/// between its nodes.
geometry::BodyBoundary make_displaced_body_boundary(const model::Model& model,
                                                    const model::Mesh& mesh,
                                                    const std::vector<model::Face>& faces,
                                                    const base::Vector& u);

/// The same of a surface in the plane.
geometry::BodyBoundary make_displaced_plane_boundary(const ContactSurface& surface,
                                                     const base::Vector& u);

} // namespace spricka::contact
