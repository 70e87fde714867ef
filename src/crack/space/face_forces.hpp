// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/space/front_forces.hpp"
#include "model/mesh_side.hpp"

namespace spricka::crack {

/// Work of forces on sides in the field that the extension carries along, - t_i u_i,k N_n, and the
/// same of the auxiliary fields (crack_space.9). Forces on sides that no domain moves add nothing.
void add_face_forces(const FrontSetting& set, const FrontExtensions& fields,
                     const std::vector<FacePointForces>& forces, const base::Vector& u,
                     FrontConfigurationalForces& out);

/// Of the auxiliary fields' own tractions on free sides, - t_aux_i u_i,k N_n: those of a front that
/// turns are not zero on the crack's faces, and those of a plane strain are not where the front
/// leaves the body (crack_space.8).
void add_auxiliary_tractions(const FrontSetting& set, const FrontExtensions& fields,
                             const base::Vector& u, FrontConfigurationalForces& out);

/// Derivatives of the functions of a side along it as gradients in space. [node, 3]
using SurfaceGradients = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, shape::most_nodes<2>, 3>;
/// Gradients in space of a side's shape functions at a reference point, tangent to the side
/// [1/length].
SurfaceGradients surface_gradients(const geometry::ElementSide& side, const shape::Point<2>& r);

} // namespace spricka::crack
