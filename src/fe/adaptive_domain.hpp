// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "shape/quadrature.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

/// Where and how finely a field that bends, kinks or jumps within an element is to be integrated.
namespace spricka::fe {

/// Sizes of a field as a whole, of which one element may hold little; 0: not known.
struct FieldMagnitude {
  double largest = 0.0; ///< magnitude at the usual points
  double mean = 0.0;    ///< magnitude, over all elements
};

struct AdaptiveSettings {
  double tolerance = 1e-9; ///< of the integral over an element: of the mean times its size
  FieldMagnitude scale;
  bool smooth = false; ///< nothing in it can jump or kink, so that little has to be doubted
};

/// What a rule may cost, as a line, an area or a volume takes the more points the more directions
/// it has.
struct AdaptiveRuleLimits {
  /// Of a load's integrals over an element or a side, of its mean value times the size: jumps of
  /// plane and solid fields cost more than those along an edge.
  double load_tolerance;
  /// Of a smooth field, as a part of its integral: so much the usual rule, and the finer one, may
  /// differ; of plane and solid loads the usual rule is far better than the elements.
  double usual_enough, finer_enough;
  int places;        ///< that a field which is not smooth is looked at
  int evaluations;   ///< that no more halves are made after
  int panels;        ///< of a line to begin with, where nothing is known
  int across_degree; ///< of the rule across the lines
  int grid, layers;  ///< of lines that tell in which direction a field changes: grid^2 layers
  int bisections;    ///< to a jump: to 1e-15 of a panel, in space to 1e-11
  bool ends;         ///< are looked at: a line's, where many a field has its peak
  /// Of an additive recurrence, across the first direction: golden section, plastic number.
  std::array<double, 2> recurrence;
};
/// By the dimension, less 1.
inline constexpr std::array<AdaptiveRuleLimits, 3> adaptive_rule_limits_by_dim{
    {{1e-9, 0.0, 0.0, 64, 20000, 8, 7, 4, 1, 50, true, {0.6180339887498949, 0.0}},
     {1e-7, 1e-5, 3e-3, 256, 40000, 8, 7, 8, 1, 50, false, {0.6180339887498949, 0.0}},
     {1e-4,
      1e-5,
      3e-3,
      256,
      80000,
      4,
      5,
      4,
      4,
      36,
      false,
      {0.7548776662466927, 0.5698402909980532}}}};
template <int dim>
inline constexpr AdaptiveRuleLimits adaptive_rule_limits = adaptive_rule_limits_by_dim[dim - 1];

template <int dim> struct FieldAdaptedRule {
  std::vector<shape::QuadraturePoint<dim>> points;
  double missed = 0.0; ///< estimate of the integral's error, where that is beyond the tolerance,
                       ///< over the reference element
  double amount = 0.0; ///< integral of the magnitude over the reference element
  bool jumps = false;  ///< by more than 1e-6 of the largest value
};

/// A point of the unit cube.
using UnitPoint = std::array<double, 3>;

/// A point of the unit cube as a point of a reference domain, and the factor of the volumes:
/// triangles and tetrahedra are collapsed (Stroud 1971).
template <int dim>
shape::QuadraturePoint<dim> map_from_unit_cube(shape::ReferenceDomain domain, const UnitPoint& t) {
  const auto simplex = static_cast<std::size_t>(shape::simplex_coordinate_count(domain));
  shape::QuadraturePoint<dim> p;
  p.weight = 1.0;
  for (std::size_t k = 0; k < dim; ++k) {
    double& r = p.r[static_cast<Eigen::Index>(k)];
    if (k >= simplex) {
      r = 2.0 * t[k] - 1.0;
      p.weight *= 2.0;
      continue;
    }
    r = t[k];
    for (std::size_t j = 0; j < k; ++j) {
      r *= 1.0 - t[j];
      p.weight *= 1.0 - t[j];
    }
  }
  return p;
}

/// Where a field is to be integrated: an image of the unit cube, or all of a reference element.
template <int dim> struct AdaptiveDomain {
  /// A point of the cube as one of the reference element, and the factor of the volumes.
  std::function<shape::QuadraturePoint<dim>(const UnitPoint& t)> map;
  /// The rule for fields that are smooth, and one that it has to agree with.
  std::span<const shape::QuadraturePoint<dim>> usual, finer;
};

/// All of a reference element; `usual_degree`: of its usual rule.
template <int dim>
AdaptiveDomain<dim> whole_element_domain(shape::ReferenceDomain domain, int usual_degree) {
  constexpr int finer_degree = 15;
  return {[domain](const UnitPoint& t) { return map_from_unit_cube<dim>(domain, t); },
          shape::quadrature<dim>(domain, usual_degree),
          shape::quadrature<dim>(domain, finer_degree)};
}

/// A field [3] at a reference point, in any units.
template <int dim> using ReferenceField = std::function<base::Vec3(const shape::Point<dim>& r)>;

} // namespace spricka::fe
