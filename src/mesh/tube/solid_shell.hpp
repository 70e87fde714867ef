// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/patch_net.hpp"
#include "mesh/tube/solid_cavity.hpp"
#include "mesh/tube/tube.hpp"

#include <vector>

/// Shells of a cavity and the outsides of tubes as triangles, from which the fill begins.
namespace spricka::mesh {

/// A shell of a cavity as triangles; edges have the host's middle nodes. A quadrilateral of a
/// quadratic element that stays becomes four triangles round its middle, tied so that linear
/// stresses pass (quadrilateral_tie_weights). Others become two, on the diagonal that bulges into
/// the cavity (else a flat tetrahedron might lie on it); the node in the middle of the diagonal is
/// that of the face, or has its place: tied to the face where a linear element stays behind it.
/// Middles of the edges of linear elements that stay are tied to these.
std::vector<PatchTriangle> triangulate_cavity_shell(const SolidHostMesh& host,
                                                    const std::vector<bool>& removed,
                                                    const std::vector<CavityFace>& faces,
                                                    PatchMeshBuilder& net,
                                                    std::vector<HostFaceReplacement>& pieces);

/// Puts a tube into a patch: returns its nodes there; its outside is added to `shell`, two
/// triangles for each quadrilateral, the middle of the diagonal tied. A free front has none.
std::vector<int> add_tube_to_patch(const Tube& tube, PatchMeshBuilder& net,
                                   std::vector<PatchTriangle>& shell);

} // namespace spricka::mesh
