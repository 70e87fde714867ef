// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"
#include "mesh/surface/surface_trace.hpp"

#include <array>
#include <vector>

namespace spricka::mesh {

/// A part of a front that lies in the body: from length s[0] to s[1] > s[0] of the curve, with the
/// places of the surface there. Of a closed curve s[1] may exceed its length (FrontCurve::at counts
/// on). An open curve may go on straight a little to reach the surface: s[0] < 0, s[1] > length.
struct InteriorFrontArc {
  std::array<double, 2> s{0.0, 0.0};
  std::array<SurfacePlace, 2> place;
  bool whole = false; ///< a closed curve inside of the body: no places, s = 0 and its length
};

struct InteriorFrontArcs {
  std::vector<InteriorFrontArc> arcs; ///< ascending by s[0]
  SurfaceFailure trouble; ///< if an open front ends in the body, or none of it is inside
};

/// How far an open front may end below the surface and still be prolonged to it, in parts of its
/// length: a bore of coarse facets lies off the true one.
inline constexpr double front_reach = 0.1;

/// Which parts of a front the body has.
InteriorFrontArcs find_interior_front_arcs(const SurfaceGeometry& surface, const FrontCurve& front);

} // namespace spricka::mesh
