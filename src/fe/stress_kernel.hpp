// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/state_field.hpp"
#include "fe/thermal_kernel.hpp"

namespace spricka::fe {

/// One element, ready for stresses at its points. Compiled in stress_kernel.cpp for each element.
template <shape::ElementShape S> struct ElementStressEvaluator {
  NodeVectors<S> X;
  NodeVectors<S> U;
  ConstitutiveLaw law;
  VolumeChangeField<S> change;
  ThermalStress<S::dim> thermal;

  ElementStressEvaluator(const model::Model& model, const model::Mesh& mesh, base::ElementId e,
                         const DisplacementTemperatureField& field);
  ElementStressEvaluator(const ElementStressEvaluator&) = delete; // its members point at its law
  ElementStressEvaluator& operator=(const ElementStressEvaluator&) = delete;

  /// By the map at r, whose gradients are finite.
  [[nodiscard]] Stress stress_from_map(const Jacobian<S>& at, const shape::Point<S::dim>& r) const;

  /// Stress at reference coordinates r; where the map is singular or folds over (a corner that
  /// mesh/quality.hpp lets pass), and gradients are without meaning, that of the centre.
  [[nodiscard]] Stress at(const shape::Point<S::dim>& r) const;

private:
  CornerValues<S::dim> held_temperature(const model::Mesh& mesh, base::ElementId e,
                                        const DisplacementTemperatureField& field);
  [[nodiscard]] double hoop_strain(const Eigen::Matrix<double, S::dim, S::dim>& H,
                                   const shape::Point<S::dim>& r) const;
};

} // namespace spricka::fe
