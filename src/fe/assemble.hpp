// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "fe/dof_map.hpp"
#include "model/forward.hpp"

#include <span>
#include <vector>

namespace spricka::fe {

/// A condensed net that enters another net's assembly like one big element.
struct Superelement {
  std::vector<std::int32_t> freedom;       ///< [m] freedoms dim * node + c
  const base::Matrix* stiffness = nullptr; ///< [m, m]
};

/// The matrix of assemble_stiffness with all values zero; of superelements their freedoms
/// dim * node + c are enough.
base::SymmetricCsc stiffness_pattern(const model::Mesh& mesh,
                                     std::span<const base::ElementId> elements,
                                     std::span<const std::vector<std::int32_t>> super_freedoms,
                                     const DofMap& dofs);

/// Stiffness of some elements and superelements on the unknowns of `dofs` (lower triangle).
/// Suppressed and prescribed freedoms have no row and drop out. Every diagonal is stored.
/// Element matrices are made on the threads of the caller's share (base/parallel.hpp), and added in
/// the order of the elements.
base::SymmetricCsc assemble_stiffness(const model::Model& model, const model::Mesh& mesh,
                                      std::span<const base::ElementId> elements,
                                      std::span<const Superelement> supers, const DofMap& dofs);

/// Nodal vector [dim * node] of the consistent loads of one load case, displacement loads left
/// out. Sum over components equals the resultant of the case exactly. FORCE fields are taken at the
/// nodes, fields over faces and elements at integration points; totals (RESULTANT, BEARING) are
/// numbers, taken at the origin. Plane loads per area and volume include the thickness. Integrated
/// by rules that follow the fields (fe/load_rule.hpp); of elements that the rim of a set cuts their
/// share counts (fe/set_shares.hpp).
base::Vector consistent_load_vector(const model::Model& model, const model::Mesh& mesh,
                                    const model::LoadCase& load_case);

/// Nodal vector [dim * node] of the prescribed displacements of one load case (zero elsewhere).
/// Loads on one set add up. Where different sets share a node the same value counts once and zero
/// gives way; others, which the deck must not have, add up.
base::Vector prescribed_displacement_vector(const model::Model& model, const model::Mesh& mesh,
                                            const model::LoadCase& load_case);

/// Internal forces K u of some elements as a nodal vector [dim * node], added to `r`; the elements'
/// strain energy on its way too where `energy` [element] is given.
void add_internal_force(const model::Model& model, const model::Mesh& mesh,
                        std::span<const base::ElementId> elements, const base::Vector& u,
                        base::Vector& r, std::vector<double>* energy = nullptr);

/// 1/2 u^T K u over some elements [force * length].
double strain_energy(const model::Model& model, const model::Mesh& mesh,
                     std::span<const base::ElementId> elements, const base::Vector& u);

/// 1/2 u^T K u of every element [force * length]. [element]
std::vector<double> element_energy(const model::Model& model, const model::Mesh& mesh,
                                   const base::Vector& u);

} // namespace spricka::fe
