// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/hidden_search.hpp"
#include "shape/quadrature.hpp"

#include <array>
#include <functional>
#include <vector>

/// Quadrature rules that follow a field which bends, kinks or jumps within an element: for loads
/// and temperatures given as expressions of the place.
namespace spricka::fe {

/// Sizes of a field as a whole, of which one element may hold little; 0: not known.
struct FieldScale {
  double largest = 0.0; ///< magnitude anywhere
  double mean = 0.0;    ///< magnitude, over all elements
};

struct AdaptiveSettings {
  double tolerance = 1e-9; ///< of the integral over an element: of the mean times its size
  FieldScale scale;
  bool smooth = false; ///< nothing in it can jump or kink, so that little has to be doubted
};

template <int dim> struct AdaptedRule {
  std::vector<shape::QuadraturePoint<dim>> points;
  double missed = 0.0;  ///< estimate of the integral's error, where that is beyond the tolerance,
                        ///< over the reference element
  double largest = 0.0; ///< magnitude of the field at its points
  double amount = 0.0;  ///< integral of the magnitude over the reference element
};

/// Part of the largest value below which what hides between points is no peak.
constexpr double little_peak = 0.002;
/// The same on the inner lines of a plane or a solid, which cut the tails of peaks.
constexpr double little_tail = 1e-4;
/// Part of the mean value that may stay open as to what hides in an element.
constexpr double little_open = 1e-5;

/// A point t of the unit cube as a point of a reference domain, and the factor of the volumes:
/// triangles and tetrahedra are collapsed (Stroud 1971).
template <int dim>
shape::QuadraturePoint<dim> unit_cube_point(shape::Domain domain, const std::array<double, 3>& t) {
  using shape::Domain;
  shape::QuadraturePoint<dim> p;
  p.weight = 1.0;
  for (int k = 0; k < dim; ++k) {
    p.r[k] = 2.0 * t[static_cast<std::size_t>(k)] - 1.0;
    p.weight *= 2.0;
  }
  if constexpr (dim > 1) {
    const double left = 1.0 - t[0];
    if (domain == Domain::triangle || domain == Domain::prism) {
      p.r.template head<2>() << t[0], t[1] * left;
      p.weight = domain == Domain::prism ? 2.0 * left : left;
    }
    if constexpr (dim == 3) {
      if (domain == Domain::tetrahedron) {
        p.r << t[0], t[1] * left, t[2] * left * (1.0 - t[1]);
        p.weight = left * left * (1.0 - t[1]);
      }
    }
  }
  return p;
}

/// Size of the unit cube's image per that of the cube, at most.
constexpr double reference_size(shape::Domain domain) {
  using shape::Domain;
  return domain == Domain::quadrilateral ? 4.0 : domain == Domain::hexahedron ? 8.0 : 2.0;
}

/// A field [3] at a reference point, in any units.
template <int dim> using ReferenceField = std::function<base::Vec3(const shape::Point<dim>& r)>;

/// The rule of `usual_degree` where it agrees with a second one (of degree 15) as to the integrals
/// of the field and its first moments, and where nothing can hide between its points; else a rule
/// by pieces. `hidden` is 0 where nothing can leave the values seen. Compiled in adaptive_rule.cpp
/// for each dimension.
template <int dim>
AdaptedRule<dim> adapted_rule(shape::Domain domain, int usual_degree,
                              const ReferenceField<dim>& value, const HiddenBound& hidden,
                              const AdaptiveSettings& settings);

} // namespace spricka::fe
