// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "crack/front_rows.hpp"

#include <array>
#include <optional>
#include <vector>

/// K of the fronts of a scene as linear functions, by its KLayout: rows^T u, what contact forces
/// add on sides that the domains move and between faces of cracks, and what loads add.
namespace spricka::analysis {

/// K of one front as functions of displacements. [dim * node, K of its points]
crack::SparseLinearFunctionals front_displacement_K_functionals(const model::Model& model,
                                                                const Discretisation& scene,
                                                                std::size_t f);

/// K as functions of displacements. [dim * node, K]
crack::SparseLinearFunctionals displacement_K_functionals(const model::Model& model,
                                                          const Discretisation& scene);

/// The same, and K as functions of what multiplies other functions than those of the nodes, 3 *
/// function + direction; of fronts in space.
crack::IntensityFunctionals supplemented_K_functionals(const model::Model& model,
                                                       const Discretisation& scene,
                                                       const crack::SupplementaryFunctions& others);

/// What a unit of each row of the table adds to K by its traction on sides that domains move
/// (crack_space.9), in the plane by its forces between faces of cracks (crack.33). [K, row]
base::Matrix contact_force_K_functionals(const model::Model& model, const Discretisation& scene);

/// Both, found at first use and kept for all that ask: they cost about what K itself does.
class KFunctionals {
public:
  /// Both must outlive it.
  KFunctionals(const model::Model& model, const Discretisation& scene)
      : model_(model), scene_(scene) {}

  /// [dim * node, K]
  [[nodiscard]] const crack::SparseLinearFunctionals& of_displacements() const {
    if (!of_displacements_) {
      of_displacements_ = displacement_K_functionals(model_, scene_);
    }
    return *of_displacements_;
  }
  /// Of what multiplies other functions [3 * count, K], not kept; in the same visit of the domains
  /// as of_displacements(), if nobody has asked for that.
  [[nodiscard]] crack::SparseLinearFunctionals
  of_supplementary(const crack::SupplementaryFunctions& others) const {
    crack::IntensityFunctionals both = supplemented_K_functionals(model_, scene_, others);
    if (!of_displacements_) {
      of_displacements_.emplace().swap(both.of_nodes);
    }
    crack::SparseLinearFunctionals rows;
    rows.swap(both.of_others);
    return rows;
  }
  /// [K, row of the table]
  [[nodiscard]] const base::Matrix& of_contact_forces() const {
    if (!of_contact_forces_) {
      of_contact_forces_ = contact_force_K_functionals(model_, scene_);
    }
    return *of_contact_forces_;
  }

private:
  const model::Model& model_;
  const Discretisation& scene_;
  mutable std::optional<crack::SparseLinearFunctionals> of_displacements_;
  mutable std::optional<base::Matrix> of_contact_forces_;
};

/// K of displacements [dim * node] under the cases' factors [case], without contact forces and
/// without the SHIFT of $VCE: linear in both.
base::Vector evaluate_K_values(const model::Model& model, const Discretisation& scene,
                               const base::Vector& u, const base::Vector& case_factor);

/// What loads add to K by themselves, that at u = 0; zero where none acts on domains. [K]
base::Vector K_added_by_loads(const model::Model& model, const Discretisation& scene,
                              const base::Vector& case_factor);
/// The same of each load case. [K, case]
base::Matrix K_added_by_load_cases(const model::Model& model, const Discretisation& scene);

/// Whether cases act on what the domains of some front take.
bool loads_act_on_domains(const model::Model& model, const Discretisation& scene,
                          const base::Vector& case_factor);

/// Smooth values of K1, K2, K3 of the points of a front in space from those in `K` [K], of which
/// the front's begin at `first`; at the surface what points further in go on to (crack_space.15,
/// crack_space.16). Linear in K.
std::vector<std::array<double, 3>> smooth_K_along_front(const mesh::CrackFront& front,
                                                        const crack::FrontIntegralDomains& domains,
                                                        const base::Vector& K, Eigen::Index first);

} // namespace spricka::analysis
