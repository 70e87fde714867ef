// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/stress.hpp"

namespace spricka::fe {

/// What a mesh is estimated to miss, element by element [element].
struct ErrorEstimate {
  /// 1/2 integral of (s* - s) C (s* - s) [force * length]: s the element's stress, s* the smoothed
  /// one, C the compliance.
  std::vector<double> energy;
  /// Energies below this are round-off beside the displacements [force * length].
  std::vector<double> noise;
};

/// Error energy after Zienkiewicz and Zhu (1987), with stresses smoothed by patches (the same,
/// 1992): round every corner node a polynomial of the elements' own degree is fitted to the
/// stresses at their superconvergent points, and the polynomials of an element's corners are
/// blended by its linear shape functions (Blacker and Belytschko 1994). Means of nodal values will
/// not do for quadratic elements: they err at the ends of an element by as much on either side, and
/// the estimate would tend to nothing. Patches end where properties or bodies do.
ErrorEstimate estimate_error(const model::Model& model, const model::Mesh& mesh,
                             const DisplacementTemperatureField& field);

} // namespace spricka::fe
