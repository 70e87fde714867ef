// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "fe/element.hpp"

namespace spricka::fe {

namespace {

// Calls use(e, U, F) with the displacements U and internal forces F of each element.
template <class Use>
void for_element_forces(const model::Model& model, const model::Mesh& mesh,
                        std::span<const base::ElementId> elements, const base::Vector& u,
                        Use&& use) {
  for_shape_blocks(mesh, elements,
                   [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                     for (const base::ElementId e : block) {
                       const NodeVectors<S> U = gather_element_values<S>(mesh, e, u);
                       const NodeVectors<S> F = element_force<S>(
                           element_coordinates<S>(mesh, e), constitutive_law(model, mesh, e), U);
                       use(e, U, F);
                     }
                   });
}

} // namespace

void add_internal_force(const model::Model& model, const model::Mesh& mesh,
                        std::span<const base::ElementId> elements, const base::Vector& u,
                        base::Vector& r, std::vector<double>* energy) {
  for_element_forces(model, mesh, elements, u,
                     [&](base::ElementId e, const auto& U, const auto& F) {
                       if (energy != nullptr) {
                         (*energy)[e.index()] = 0.5 * U.cwiseProduct(F).sum();
                       }
                       add_at_nodes(mesh, e, F, r);
                     });
}

double strain_energy(const model::Model& model, const model::Mesh& mesh,
                     std::span<const base::ElementId> elements, const base::Vector& u) {
  double energy = 0.0;
  for_element_forces(model, mesh, elements, u,
                     [&](base::ElementId /*e*/, const auto& U, const auto& F) {
                       energy += 0.5 * U.cwiseProduct(F).sum();
                     });
  return energy;
}

std::vector<double> element_energy(const model::Model& model, const model::Mesh& mesh,
                                   const base::Vector& u) {
  std::vector<double> energy(mesh.element_count(), 0.0);
  for_element_forces(model, mesh, model::all_elements(mesh), u,
                     [&](base::ElementId e, const auto& U, const auto& F) {
                       energy[e.index()] = 0.5 * U.cwiseProduct(F).sum();
                     });
  return energy;
}

} // namespace spricka::fe
