// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <span>

/// What a temperature does to one element, which is known when run.
namespace spricka::fe {

/// Values at the corners of an element; between them its linear relative interpolates.
template <int dim>
using CornerValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, shape::most_corners<dim>, 1>;
/// Their derivatives. [corners, dim]
template <int dim>
using CornerGradients =
    Eigen::Matrix<double, Eigen::Dynamic, dim, 0, shape::most_corners<dim>, dim>;

/// Corner temperatures of an element out of a field by connectivity index.
template <int dim>
CornerValues<dim> gather_corner_temperatures(const AnyElement<dim>& element,
                                             const model::Mesh& mesh, base::ElementId e,
                                             const base::Vector& temperature) {
  return temperature.segment(mesh.first[e.index()], element.corners);
}

/// A temperature that is linear in x in a plane element, and the displacement it drives where
/// nothing holds the element, which strains it the same in all directions. Quadratic elements that
/// do not hold quadratic functions cannot follow it: in them it is taken out beforehand and the
/// nodes bear the rest, which leaves no stress of a linear temperature in any element.
class FreeExpansion {
public:
  FreeExpansion() = default; ///< of nothing
  /// Of corner values that lie on a plane, or of the plane nearest to them.
  FreeExpansion(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                const ConstitutiveLaw& law, const CornerValues<2>& T);
  /// Whether an element has to take it out beforehand.
  [[nodiscard]] static bool must_remove_beforehand(const AnyElement<2>& element,
                                                   const AnyNodeVectors<2>& X,
                                                   const ConstitutiveLaw& law);
  /// No solid has to: in it TemperatureFunctions follow linear temperatures.
  [[nodiscard]] static bool must_remove_beforehand(const AnyElement<3>& /*element*/,
                                                   const AnyNodeVectors<3>& /*X*/,
                                                   const ConstitutiveLaw& /*law*/) {
    return false;
  }
  /// Temperature of the plane at a place x.
  [[nodiscard]] double temperature(const base::Vec2& x) const {
    return plane_[0] + plane_.tail<2>().dot(x - centre_);
  }
  [[nodiscard]] base::Vec2 temperature_gradient() const { return plane_.tail<2>(); }
  /// Displacement [length] of the free expansion at a place, zero at the centre of the corners
  /// (fe.38).
  [[nodiscard]] base::Vec2 displacement(const base::Vec2& x) const;
  /// Its gradient du_i/dx_j: the same strain in all directions and a rotation.
  [[nodiscard]] Eigen::Matrix2d gradient(const base::Vec2& x) const;
  /// The displacement [2, nodes] at nodes with the coordinates X.
  [[nodiscard]] AnyNodeVectors<2> at_nodes(const AnyNodeVectors<2>& X) const;

private:
  base::Vec2 centre_ = base::Vec2::Zero();
  double strain_ = 0.0; ///< of a temperature of 1
  Eigen::Vector3d plane_ = Eigen::Vector3d::Zero();
};

/// Displacements [2, nodes] of the free expansion of an element that has to take it out beforehand;
/// empty for others.
std::optional<AnyNodeVectors<2>> free_expansion_displacements(const AnyElement<2>& element,
                                                              const AnyNodeVectors<2>& X,
                                                              const ConstitutiveLaw& law,
                                                              const CornerValues<2>& T);
/// No solid has to: empty.
inline std::optional<AnyNodeVectors<3>>
free_expansion_displacements(const AnyElement<3>& /*element*/, const AnyNodeVectors<3>& /*X*/,
                             const ConstitutiveLaw& /*law*/, const CornerValues<3>& /*T*/) {
  return std::nullopt;
}

/// Functions of the corner temperatures of an element: those of its linear relative, in quadratic
/// solids with what makes a temperature that is linear in x that in the element too, wherever the
/// nodes of its edges are (manual, fe.40).
template <int dim> class TemperatureFunctions {
public:
  TemperatureFunctions(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X);
  /// Values of the functions at a reference point. [corners]
  [[nodiscard]] CornerValues<dim> at(const shape::Point<dim>& r) const;
  /// Their gradients by x; J of the map at r. [corners, dim]
  [[nodiscard]] CornerGradients<dim> gradients(const Eigen::Matrix<double, dim, dim>& J,
                                               const shape::Point<dim>& r) const;

private:
  [[nodiscard]] bool bent() const { return dim == 3 && element_->quadratic; }

  const AnyElement<dim>* element_;
  AnyNodeVectors<dim> X_;
  CornerGradients<dim> slope_; ///< of a plane through corner values
};

/// What a temperature T takes out of the normal stresses of an element: a body held all round
/// carries -alpha (3 lambda T + 2 mu T); in plane stress, with the reduced lambda, two directions
/// are held. Where the volume change is projected, so is the temperature that drives it: a body
/// free to expand would keep stresses else.
template <int dim> class ThermalStress {
public:
  ThermalStress(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                const ConstitutiveLaw& law, const CornerValues<dim>& T);
  /// The temperature at a reference point, interpolated from the corners; zero where all of these
  /// are.
  [[nodiscard]] double temperature(const shape::Point<dim>& r) const {
    return cold_ ? 0.0 : T_.dot(functions_.at(r));
  }
  /// The temperature that drives the volume change.
  [[nodiscard]] double volumetric_temperature(const shape::Point<dim>& r) const {
    return law_->projected && !cold_
               ? ProjectedDilatation<AnyElement<dim>>::phi(*element_, r).dot(projected_)
               : temperature(r);
  }
  /// The stress that comes off each normal component at a reference point, positive under heat
  /// [stress].
  [[nodiscard]] double at(const shape::Point<dim>& r) const {
    return cold_ ? 0.0
                 : law_->expansion *
                       (law_->heated_direction_count() * law_->lambda * volumetric_temperature(r) +
                        2.0 * law_->mu * temperature(r));
  }

private:
  const AnyElement<dim>* element_;
  const ConstitutiveLaw* law_;
  CornerValues<dim> T_;
  bool cold_; ///< T is zero
  TemperatureFunctions<dim> functions_;
  typename ProjectedDilatation<AnyElement<dim>>::Modes projected_;
};

/// A temperature at a point of an element.
template <int dim> struct WeightedTemperature {
  shape::Point<dim> r = shape::Point<dim>::Zero();
  double weight = 0.0; ///< volume that it stands for, or a constant times that
  double T = 0.0;
};
/// Corner temperatures of what an element takes of a temperature: constant in linear elements,
/// linear in the reference coordinates of quadratic ones, and in x where plane ones do not hold
/// quadratic functions, in solids by TemperatureFunctions; the nearest to the samples by least
/// squares.
template <int dim>
CornerValues<dim> project_temperature(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                      const ConstitutiveLaw& law,
                                      std::span<const WeightedTemperature<dim>> samples);

/// Consistent forces of an element's temperatures.
template <int dim>
AnyNodeVectors<dim> thermal_forces(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                                   const ConstitutiveLaw& law, const CornerValues<dim>& T);

} // namespace spricka::fe
