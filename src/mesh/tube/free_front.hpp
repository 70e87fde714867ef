// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/crack_surface.hpp"
#include "mesh/tube/tube.hpp"

#include <set>

/// Fronts without a tube: edges of tetrahedra, where no tube fits or none is wanted.
namespace spricka::mesh {

/// Elements along a free front as long as those round it are large (mesh.13).
TubeSizes tubeless_front_sizes(TubeSizes sizes, const TubeMeshParameters& given);

/// The front alone, as a tube without elements.
Tube make_tubeless_front(const FrontCurve& curve, const TubeSizes& sizes,
                         const TubeMeshParameters& given);

/// Divides the edges of a crack's triangles that join two nodes of free fronts across the crack:
/// with no node between them that is there twice the crack could not open there.
void divide_front_chord_edges(const PlaneBasis& plane, const std::set<int>& front,
                              PatchMeshBuilder& net, CrackTriangulation& surface);

} // namespace spricka::mesh
