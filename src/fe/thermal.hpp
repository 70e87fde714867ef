// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::fe {

struct ConstitutiveLaw;
struct UnresolvedLoad;

/// Thermal strain alpha T. A quadratic element's strains are linear, so a temperature that varies
/// quadratically inside an element would leave stresses that are none: T is projected onto what
/// the strains can follow, linear functions on quadratic elements and constants on linear ones
/// (least squares at the integration points, or at those that follow it where these do not). A
/// linear temperature stays exact.

/// Temperature of one load case at the corners of the elements [connectivity index, as
/// Mesh::nodes; mid nodes hold zero]; empty without thermal loads. Elements in several sets take
/// the sum. What rules could not follow of it goes to `missed` and whether it jumps inside an
/// element to `jumps` [element], but for elements with a rest.
base::Vector corner_temperatures_of_case(const model::Model& model, const model::Mesh& mesh,
                                         const model::LoadCase& load_case,
                                         UnresolvedLoad* missed = nullptr,
                                         std::vector<bool>* jumps = nullptr);

/// Whether the rest of a temperature acts on an element by itself (heat.hpp).
bool has_residual_temperature(const ConstitutiveLaw& law, int dim, bool quadratic);

/// Consistent nodal forces [dim * node] of a temperature field as above: integral of
/// B^T D alpha T dV.
base::Vector thermal_load(const model::Model& model, const model::Mesh& mesh,
                          const base::Vector& temperature);

/// Adds to 1/2 u^T K u of every element what its temperatures make of it: its elastic energy.
void add_thermal_energy(const model::Model& model, const model::Mesh& mesh,
                        const base::Vector& temperature, const base::Vector& u,
                        std::vector<double>& energy);

} // namespace spricka::fe
