// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"
#include "model/mesh_side.hpp"
#include "shape/quadrature.hpp"

#include <optional>
#include <vector>

/// Partners of a solution in the plane and about an axis, as the terms of K read them
/// (crack/interaction_terms.hpp).
namespace spricka::crack {

/// Elastic constants of an element of a domain.
struct SectionElasticity {
  fe::Elasticity<2> D; ///< in the section
  fe::ConstitutiveLaw law;

  SectionElasticity(const TipContext& set, base::ElementId e)
      : D(set.elasticity(e)), law(fe::constitutive_law(set.model, set.mesh, e)) {}
  /// With the stress of a gradient.
  [[nodiscard]] GradientStressState<2> state_from_gradient(const Tensor<2>& H, double hoop) const;
  /// Sets the stresses of gradients.
  void set_stress(GradientStressStates<2>& of) const;
};

/// A point as seen from the tip; on a face with the unit tangent of that.
struct TipPlace {
  PolarCoordinates polar;
  base::Vec2 x = base::Vec2::Zero();
  base::Vec2 tangent = base::Vec2::Zero();
  base::ElementId element = {}; ///< of the face
};

/// The points of a side in the plane: products of auxiliary fields with derivatives of
/// displacements go with roots of the distance from the tip, and are polynomials of what is
/// integrated by on straight sides, with and without a quarter point.
std::vector<shape::QuadraturePoint<2>> tip_side_quadrature(const TipContext& set,
                                                           const geometry::ElementSide& side);

/// The domains of a tip and the auxiliary fields at their points. About an axis these fields are
/// carried round with the section (crack.38) and press on the faces of the crack with lambda v_x /
/// x, which does not come from the tip (crack.40).
class TipAuxiliaryFields {
public:
  static constexpr int dim = 2;
  using Place = TipPlace;

  TipAuxiliaryFields(const TipContext& set, const std::vector<VirtualExtensionField>& fields);

  [[nodiscard]] const TipContext& context() const { return set_; }
  /// Elements where q of some domain varies, ascending.
  [[nodiscard]] const std::vector<base::ElementId>& strained_elements() const { return strained_; }
  /// Others where q is not zero, ascending.
  [[nodiscard]] const std::vector<base::ElementId>& rigid_elements() const { return rigid_; }
  /// The sides that auxiliary fields press on, of the crack's faces.
  [[nodiscard]] const std::vector<MovedFreeSide>& moved_free_sides() const { return sides_; }

  /// Whether a displacement counts in rigid_elements() as well: about an axis these come to other
  /// radii.
  [[nodiscard]] bool contracts_rigid_elements() const { return set_.is_axisymmetric(); }

  /// The points of an element of a domain. About an axis the elements at the tip count as well
  /// (crack.37), where auxiliary fields are singular: by charts collapsed into it.
  [[nodiscard]] std::vector<shape::QuadraturePoint<2>> element_quadrature(base::ElementId e) const;
  /// Of an element at a point r; `number`: of the point.
  [[nodiscard]] shape::ShapeFunctionValues<2> shape_functions(base::ElementId e, std::size_t number,
                                                              const base::Vec2& r) const;
  [[nodiscard]] SectionElasticity elasticity(base::ElementId e) const { return {set_, e}; }
  /// The auxiliary fields at a point x of an element, off the tip, stress by the element's own
  /// elasticity; the divergence is zero in the plane (crack.39). `number`: of the point.
  [[nodiscard]] AuxiliaryFields<2> auxiliary_fields(base::ElementId e, std::size_t number,
                                                    const base::Vec2& x,
                                                    const SectionElasticity& k) const;
  [[nodiscard]] Place locate_in_element(const base::Vec2& x) const {
    return {polar_coordinates(set_.tip, x), x};
  }
  /// Gradient of an auxiliary field at a place.
  [[nodiscard]] Tensor<2> auxiliary_gradient(const Place& at, std::size_t auxiliary) const {
    return auxiliary_field_gradient(set_, at.polar, auxiliary);
  }

  /// Which face of the crack a loaded side is, as far as fields need it: its normal tells.
  [[nodiscard]] std::optional<UpperOrLowerFace>
  crack_face_of_element_side(const model::Face& /*face*/) const {
    return UpperOrLowerFace::none;
  }
  [[nodiscard]] std::vector<shape::QuadraturePoint<2>>
  side_quadrature(const geometry::ElementSide& side) const {
    return tip_side_quadrature(set_, side);
  }
  /// A point of a side; nothing at the tip itself and where the side has no length.
  [[nodiscard]] std::optional<Place> locate_on_side(const geometry::ElementSide& side,
                                                    const base::Vec2& r, UpperOrLowerFace on) const;
  /// The part of the gradient that is along a side: faces are straight.
  [[nodiscard]] Tensor<2> auxiliary_side_gradient(const Place& at, std::size_t auxiliary) const {
    return auxiliary_gradient(at, auxiliary) * at.tangent * at.tangent.transpose();
  }
  /// Force of an auxiliary field's stress on a face; `area`: normal as long as the face's length.
  [[nodiscard]] base::Vec2 auxiliary_traction(const Place& at, std::size_t auxiliary,
                                              const base::Vec2& area) const;

private:
  [[nodiscard]] AuxiliaryField<2> auxiliary_field(const base::Vec2& x, std::size_t auxiliary,
                                                  const SectionElasticity& k) const;

  const TipContext& set_;
  std::vector<base::ElementId> strained_;
  std::vector<base::ElementId> rigid_;
  std::vector<MovedFreeSide> sides_;
};

} // namespace spricka::crack
