// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "mesh/front_curve.hpp"
#include "model/mesh.hpp"

/// How finely the integrals of K along a front are summed.
namespace spricka::crack {

/// Of elements at the front and of sides. Partners behave like r^-1/2 or r^-1 across the front and
/// are smooth along it.
inline constexpr int front_degree = 9;

/// Degree of the rule over an element of the domains: front_degree at the front, less where the
/// front is far away for the element's size (manual, crack_space.16).
int front_quadrature_degree(const model::Mesh& mesh, base::ElementId e,
                            const mesh::FrontCurve& curve);

} // namespace spricka::crack
