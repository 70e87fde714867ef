// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/frozen_step.hpp"
#include "analysis/adjoint/parameter_derivatives.hpp"
#include "analysis/scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

/// What a longer semi-axis of an ellipse does to the equations and to K along its front, the
/// contact kept as it is.
namespace spricka::analysis {

enum class EllipseAxis : char { a, c };

/// A scene with the mesh round the fronts of one crack stretched along an axis by a small step: its
/// mesh, its fronts and the pairs that have nodes there.
class VirtualAxisExtension {
public:
  VirtualAxisExtension(const model::Model& model, const Discretisation& scene, base::CrackId crack,
                       EllipseAxis axis);

  [[nodiscard]] const std::string& crack_name() const; ///< of the crack
  /// The scene that is moved, and by how much its axis is longer.
  [[nodiscard]] const Discretisation& extended_discretisation() const { return moved_; }
  [[nodiscard]] double axis_increment() const { return step_; }
  /// Why there is no derivative in this step; empty: there is one.
  [[nodiscard]] std::string why_no_derivative(const FrozenContactStep& step) const;
  /// d/da of loads, gaps and K, u and contact forces kept; K at an angle phi (sensitivity.15).
  [[nodiscard]] ParameterPartialDerivatives axis_partial_derivatives(const FrozenContactStep& step,
                                                                     const KFunctionals& K) const;

private:
  void shift_mesh();
  [[nodiscard]] std::vector<bool> resting() const;
  [[nodiscard]] std::vector<base::Vec3> motion_of(std::size_t f) const;
  void move();
  void move_pairs();
  [[nodiscard]] base::Vector loads(const Discretisation& side, const StepState& state) const;
  [[nodiscard]] base::Vector openings(const Discretisation& side,
                                      const FrozenContactStep& step) const;
  [[nodiscard]] base::Vector change(const FrozenContactStep& step, const KFunctionals& K) const;

  const model::Model& model_;
  const Discretisation& scene_;
  base::CrackId crack_;
  EllipseAxis axis_;
  base::Vec3 direction_ = base::Vec3::Zero(); ///< of the axis
  double size_ = 0.0;                         ///< its length
  std::vector<base::Vec3> velocity_;          ///< [node] of the mesh, by the length of the axis
  std::vector<base::ElementId> strained_;     ///< elements with a node that moves
  double step_ = 0.0;                         ///< [length] of the axis
  Discretisation moved_;
  crack::SparseLinearFunctionals rows_; ///< K of the moved scene by displacements
  base::Matrix of_force_;               ///< the same by contact forces; empty: no pair moves
  std::vector<std::size_t> pairs_;      ///< that have nodes which move
  std::string why_never_;
};

} // namespace spricka::analysis
