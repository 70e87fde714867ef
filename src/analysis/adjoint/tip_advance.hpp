// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/parameter_derivatives.hpp"
#include "analysis/scene/scene.hpp"
#include "estimate/tip_motion.hpp"

#include <memory>
#include <string>
#include <vector>

/// What the advance of a tip does to the equations and to K, the contact kept as it is.
namespace spricka::analysis {

/// Scenes with one tip moved on and back by a small step: meshes, tips and loads only.
class VirtualTipExtension {
public:
  VirtualTipExtension(const model::Model& model, const Discretisation& scene, std::size_t tip);

  [[nodiscard]] const std::string& tip_name() const { return name_; }
  /// Why dK/da is not given while these rows of the table are closed; empty: it is.
  [[nodiscard]] std::string why_no_derivative(const std::vector<bool>& closed) const;
  /// d/da of loads and K of all tips, u and contact forces kept.
  [[nodiscard]] ParameterPartialDerivatives
  length_partial_derivatives(const StepState& state) const;

private:
  void find_hindrances(const std::vector<bool>& moves);
  [[nodiscard]] std::unique_ptr<Discretisation> moved_by(double steps) const;
  [[nodiscard]] base::Vector load_rate(const model::LoadCase& load_case, std::size_t c,
                                       const Discretisation& ahead, const Discretisation& behind,
                                       double distance) const;
  void move_loads(const std::vector<bool>& moves);
  /// d(f - K u)/da with f of all cases [dim * node], u kept (manual, sensitivity.9).
  [[nodiscard]] base::Vector load_derivative(const base::Vector& u,
                                             const base::Vector& case_factor) const;
  /// dK/da [K] at u kept: of the rows of all tips and of what their loads add.
  [[nodiscard]] base::Vector explicit_derivative(const base::Vector& u,
                                                 const base::Vector& case_factor) const;

  const model::Model& model_;
  const Discretisation& scene_;
  std::string name_; ///< of the tip
  double a_ = 0.0;   ///< its crack's length
  estimate::TipMeshMotion motion_;
  std::unique_ptr<Discretisation> ahead_, behind_;
  std::vector<base::ElementId> strained_; ///< elements whose stiffness changes
  base::Matrix load_rate_;                ///< [dim * node, case]; empty: no load moves
  std::vector<base::Matrix> row_rate_;    ///< [tip][dim * node, 2]; empty: they move as one
  std::vector<std::size_t> rows_;         ///< of the table, on nodes that move
  bool tied_ = false;                     ///< ties hold nodes that move
  bool discontinuous_ = false;            ///< a temperature jumps within elements that move
  bool singular_ = false;                 ///< loads have no rate where the tip is
};

} // namespace spricka::analysis
