// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/grading.hpp"
#include "mesh/link/region.hpp"

namespace spricka::mesh {

/// Fills a region with triangles by gmsh; with `trouble` there are none.
TriangleFill fill_triangles(const PlaneRegion& region, const Grading& size);

} // namespace spricka::mesh
