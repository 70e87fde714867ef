// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_setting.hpp"
#include "fe/jacobian.hpp"
#include "shape/quadrature.hpp"

#include <memory>
#include <span>
#include <vector>

namespace spricka::crack {

/// Whether auxiliary fields are read once or more often from a table.
enum class AuxiliaryFieldReading { once, repeatedly };

/// The auxiliary fields' fields at the points of the rule of the domains' elements. They belong to
/// the mesh and the material: steps, rows of K and rows of other functions all read the same. Those
/// that are read once are made where they are read, without memory for all points.
class AuxiliaryFieldTable {
public:
  AuxiliaryFieldTable(const FrontContext& set, const FrontIntegralDomains& fields,
                      AuxiliaryFieldReading reading);

  /// The rule over an element.
  [[nodiscard]] std::span<const shape::QuadraturePoint<3>>
  quadrature_rule(const fe::AnyElement<3>& element, base::ElementId e) const {
    return shape::quadrature<3>(element.domain, degree_[slot_[e.index() - first_]]);
  }

  /// Of an element at a point of its rule.
  [[nodiscard]] const shape::ShapeFunctionValues<3>& shape_functions(base::ElementId e,
                                                                     std::size_t point) const {
    return functions_[slot_[e.index() - first_]][point];
  }

  /// The auxiliary fields of an element at a point of its rule, which is at x; `set`: as given.
  [[nodiscard]] AuxiliaryFields<3> at(const FrontContext& set, base::ElementId e, std::size_t point,
                                      const base::Vec3& x) const {
    return make_auxiliary_fields(fields_.empty()
                                     ? auxiliary_values_at(set, x)
                                     : fields_[start_[slot_[e.index() - first_]] + point],
                                 body_);
  }

  /// Whether it is of this body and of a mesh with nodes at the same places.
  [[nodiscard]] bool is_valid_for(const FrontContext& set) const;

private:
  static FrontAuxiliaryValues auxiliary_values_at(const FrontContext& set, const base::Vec3& x) {
    return front_auxiliary_values(FrontAxesDerivatives(set.axes.locate_point(x)), set.body);
  }

  FrontBody body_;
  std::vector<base::ElementId> elements_;
  std::size_t first_ = 0;                                                 ///< the lowest element
  std::vector<int> degree_;                                               ///< [slot] of the rule
  std::vector<std::span<const shape::ShapeFunctionValues<3>>> functions_; ///< [slot]
  std::vector<std::size_t> slot_;            ///< [element - first] into start_
  std::vector<std::size_t> start_;           ///< [slot] into fields_
  std::vector<base::Vec3> places_;           ///< [element] of its nodes, as a sum
  std::vector<FrontAuxiliaryValues> fields_; ///< [point]; empty: read once
};

/// Of the domains of a front, from their memory if they have one; else to be read once.
std::shared_ptr<const AuxiliaryFieldTable>
cached_auxiliary_table(const FrontContext& set, const FrontIntegralDomains& fields);

} // namespace spricka::crack
