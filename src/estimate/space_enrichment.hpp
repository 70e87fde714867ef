// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/space_tractions.hpp"
#include "estimate/space_modes.hpp"
#include "estimate/space_operator.hpp"
#include "fe/dependence.hpp"
#include "fe/heat.hpp"
#include "model/forward.hpp"
#include "model/freedoms.hpp"
#include "model/loads.hpp"
#include "model/mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// The cubic modes of a mesh of solids: numbers, products with their stiffness, loads.
namespace spricka::estimate {

/// Why a model of solids cannot be enriched; empty: it can.
std::string solid_enrichment_obstacle(const model::Model& model, const model::Mesh& mesh);

class SolidEnrichment {
public:
  /// Held are modes along freedoms that supports hold at all nodes of an edge or a face, and modes
  /// of edges and faces that ties join (manual, estimate.22). All must outlive it.
  SolidEnrichment(const model::Model& model, const model::Mesh& mesh,
                  const std::vector<model::FreedomRole>& cls,
                  const fe::ConstraintTransformation& ties);

  /// Three directions of each mode. [freedoms]
  [[nodiscard]] Eigen::Index freedoms() const { return free_mode_mask().size(); }
  /// Modes of an element in the order of SolidModes.
  [[nodiscard]] std::span<const std::int32_t> element_modes(base::ElementId e) const {
    const SolidModeNumbers& of = operator_.mode_numbers();
    return {of.mode.data() + of.first[e.index()], of.mode.data() + of.first[e.index() + 1]};
  }
  /// Whether the element's own function is the mode or its negative.
  [[nodiscard]] std::span<const double> element_mode_signs(base::ElementId e) const {
    const SolidModeNumbers& of = operator_.mode_numbers();
    return {of.sign.data() + of.first[e.index()], of.sign.data() + of.first[e.index() + 1]};
  }

  /// What displacements of nodes v [3 * node] and modes x [freedoms] load the modes with,
  /// K_ep v + K_ee x, on free ones; null: zero.
  [[nodiscard]] base::Vector stiffness_forces_on_modes(const base::Vector* v,
                                                       const base::Vector* x) const;
  /// Both: K_pe x on the nodes [3 * node] and K_ee x on the modes.
  void stiffness_product(const base::Vector& x, base::Vector& on_nodes,
                         base::Vector& on_modes) const;
  /// About K_ee^-1 r on free ones: a few steps of conjugate gradients, which take no solution of
  /// the nodes. Not linear in r: an iteration that uses it makes each direction conjugate to the
  /// last.
  [[nodiscard]] base::Vector apply_preconditioner(const base::Vector& r) const;
  /// Zero where held. [freedoms]
  [[nodiscard]] const base::Vector& free_mode_mask() const { return operator_.mode_numbers().free; }

  /// Forces on the modes of spread loads of a case, and what its temperature presses: all of it,
  /// also what elements do not take.
  [[nodiscard]] base::Vector distributed_load(const model::LoadCase& load_case,
                                              const fe::CaseTemperature& heat) const;
  /// Adds what forces at points of faces, as contacts have them, do.
  void add_tractions(const std::vector<contact::FaceTraction>& tractions, base::Vector& f) const;

private:
  /// The inverse of the 3 by 3 diagonal blocks of K_ee, times r on free ones.
  [[nodiscard]] base::Vector divide_by_diagonal(const base::Vector& r) const;
  void add_on_side(const model::Face& face, const base::Vec2& r, const base::Vec3& force,
                   base::Vector& f) const;
  void add_inside(base::ElementId e, const base::Vec3& r, const base::Vec3& force,
                  base::Vector& f) const;
  void add_thermal(base::ElementId e, const fe::CaseTemperature& heat, base::Vector& f) const;

  const model::Model& model_;
  const model::Mesh& mesh_;
  SolidModeStiffness operator_;
  std::vector<Eigen::Matrix3d> inverse_; ///< [mode]
};

} // namespace spricka::estimate
