// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_table.hpp"
#include "crack/front_rule.hpp"
#include "model/mesh_side.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace spricka::crack {

/// The domains of a front in space and the auxiliary fields at their points, as the terms of K read
/// them (crack/interaction_terms.hpp); those at the points of elements from a table, made when they
/// are asked for first.
class FrontAuxiliaryFields {
public:
  static constexpr int dim = 3;
  using Place = FrontAxesDerivatives;

  FrontAuxiliaryFields(const FrontContext& set, const FrontIntegralDomains& fields)
      : set_(set), fields_(fields), strained_(fields.elements()) {
    for (const MovedFreeSide& side : fields.sides) {
      moved_.emplace(side.face, side.on);
    }
  }

  [[nodiscard]] const FrontContext& context() const { return set_; }
  /// All elements of all domains, ascending.
  [[nodiscard]] const std::vector<base::ElementId>& strained_elements() const { return strained_; }
  /// Elements that a domain moves as one are among the others.
  [[nodiscard]] static std::span<const base::ElementId> rigid_elements() { return {}; }
  [[nodiscard]] static bool contracts_rigid_elements() { return false; }
  /// Free sides with a node that some domain moves.
  [[nodiscard]] const std::vector<MovedFreeSide>& moved_free_sides() const { return fields_.sides; }
  /// Degree of the rule over an element.
  [[nodiscard]] int quadrature_degree(base::ElementId e) const { return fields_.degree.at(e); }

  /// The points of an element of a domain.
  [[nodiscard]] std::span<const shape::QuadraturePoint<3>>
  element_quadrature(base::ElementId e) const {
    return table().quadrature_rule(shape::reference_element<3>(set_.mesh.type[e.index()]), e);
  }
  /// Of an element at a point of the rule.
  [[nodiscard]] const shape::ShapeFunctionValues<3>&
  shape_functions(base::ElementId e, std::size_t number, const base::Vec3& /*r*/) const {
    return table().shape_functions(e, number);
  }
  /// The body, which is one in all domains.
  [[nodiscard]] const FrontBody& elasticity(base::ElementId /*e*/) const { return set_.body; }
  /// The auxiliary fields at a point of the rule.
  [[nodiscard]] AuxiliaryFields<3> auxiliary_fields(base::ElementId e, std::size_t number,
                                                    const base::Vec3& x,
                                                    const FrontBody& /*body*/) const {
    return table().at(set_, e, number, x);
  }
  [[nodiscard]] Place locate_in_element(const base::Vec3& x) const {
    return Place(set_.axes.locate_point(x));
  }
  /// Gradient of an auxiliary field at a place.
  [[nodiscard]] Tensor<3> auxiliary_gradient(const Place& at, std::size_t auxiliary) const {
    return front_auxiliary_gradient(auxiliary, at, set_.body);
  }

  /// Which face of the crack a side is that a domain moves; nothing: none moves it.
  [[nodiscard]] std::optional<UpperOrLowerFace>
  crack_face_of_element_side(const model::Face& face) const {
    const auto known = moved_.find(face);
    return known == moved_.end() ? std::nullopt : std::optional(known->second);
  }
  [[nodiscard]] static std::span<const shape::QuadraturePoint<2>>
  side_quadrature(const geometry::ElementSide& side) {
    return shape::quadrature<2>(side.domain(), front_degree);
  }
  /// A point of a side; nothing on the front itself.
  [[nodiscard]] std::optional<Place> locate_on_side(const geometry::ElementSide& side,
                                                    const base::Vec2& r,
                                                    UpperOrLowerFace on) const {
    const FrontCoordinates at = set_.axes.locate_point(side.position(r), on);
    return at.r > 0.0 ? std::optional(Place(at)) : std::nullopt;
  }
  /// Gradient of an auxiliary field on a side.
  [[nodiscard]] Tensor<3> auxiliary_side_gradient(const Place& at, std::size_t auxiliary) const {
    return auxiliary_gradient(at, auxiliary);
  }
  /// Force of an auxiliary field's stress on a side; `area`: normal as long as the area.
  [[nodiscard]] base::Vec3 auxiliary_traction(const Place& at, std::size_t auxiliary,
                                              const base::Vec3& area) const {
    return isotropic_stress(set_.body, auxiliary_gradient(at, auxiliary)) * area;
  }

private:
  [[nodiscard]] const AuxiliaryFieldTable& table() const {
    if (!table_) {
      table_ = cached_auxiliary_table(set_, fields_);
    }
    return *table_;
  }

  const FrontContext& set_;
  const FrontIntegralDomains& fields_;
  std::vector<base::ElementId> strained_;
  std::map<model::Face, UpperOrLowerFace> moved_;
  mutable std::shared_ptr<const AuxiliaryFieldTable> table_;
};

} // namespace spricka::crack
