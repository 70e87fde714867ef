// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/model.hpp"
#include "tests/convergence/error_norm.hpp"

/// Manufactured problems: smooth displacements that no element represents, on curved meshes, with
/// the body force that belongs to them and values prescribed all round.
namespace spricka::test {

/// A problem solved.
struct Manufactured {
  model::Model model;
  base::Vector u; ///< [dim * node]
  ExactField exact;
};

/// u = (sin x sin y, 2 cos x cos y) on a quarter ring, n x n cells; plane stress or strain or, with
/// x as radius, about the axis.
Manufactured manufactured_plane(base::ElementType type, model::StressState state, int n);

/// u_i = a_i e_i with e = (sin x cos y cos z, cos x sin y cos z, cos x cos y sin z) on a sector of
/// a thick spherical shell, n^3 cells.
Manufactured manufactured_solid(base::ElementType type, double nu, const base::Vec3& a, int n);

} // namespace spricka::test
