// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/supplementary_functions.hpp"
#include "shape/quadrature_point.hpp"
#include "shape/side_place.hpp"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace spricka::crack {

/// The slopes of functions beside those of the nodes at the points of rules, each made once.
class SupplementarySlopes {
public:
  /// By the reference coordinates of the element [function, 3], at each point of a rule.
  using AtPoints = std::vector<Eigen::MatrixX3d>;

  /// `others` must outlive it.
  explicit SupplementarySlopes(const SupplementaryFunctions& others) : others_(others) {}

  [[nodiscard]] const SupplementaryFunctions& functions() const { return others_; }
  /// How many an element has.
  [[nodiscard]] Eigen::Index count(base::ElementId e) const {
    return others_.count == 0 ? 0 : static_cast<Eigen::Index>(others_.of_element(e).size());
  }
  /// At the points of a rule over elements of a type.
  template <int dim>
  const AtPoints& in_element(base::ElementType type,
                             std::span<const shape::QuadraturePoint<dim>> rule) {
    AtPoints& table = in_element_[{type, rule.data()}];
    for (std::size_t p = table.size(); p < rule.size(); ++p) {
      base::Vec3 r = base::Vec3::Zero();
      r.head<dim>() = rule[p].r;
      table.push_back(others_.slopes(type, r));
    }
    return table;
  }
  /// At the points of a rule over a side of elements of a type, the same for all that ask.
  const AtPoints& on_side(base::ElementType type, int side,
                          std::span<const shape::QuadraturePoint<2>> rule) {
    AtPoints& table = on_side_[{type, side}];
    for (std::size_t p = table.size(); p < rule.size(); ++p) {
      table.push_back(others_.slopes(type, shape::side_to_solid_point(type, side, rule[p].r)));
    }
    return table;
  }

private:
  const SupplementaryFunctions& others_;
  std::map<std::pair<base::ElementType, const void*>, AtPoints> in_element_; ///< [type, rule]
  std::map<std::pair<base::ElementType, int>, AtPoints> on_side_;            ///< [type, side]
};

} // namespace spricka::crack
