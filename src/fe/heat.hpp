// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/heat_field.hpp"
#include "fe/heat_points.hpp"
#include "fe/thermal_kernel.hpp"
#include "model/forward.hpp"

#include <span>
#include <vector>

/// Temperatures as the deck gives them. Elements take a linear part (thermal.hpp); what a
/// temperature has beyond that, a kink, a jump, a root at a tip, the rim of a heated set within an
/// element, acts on their displacements as well, and is known at points (manual, fe.38 and fe.39).
namespace spricka::fe {

/// The stress that a degree takes out, beta of manual fe.21.
inline double thermal_modulus(const ConstitutiveLaw& law) {
  return law.expansion * (law.heated_direction_count() * law.lambda + 2.0 * law.mu);
}

/// Temperatures of one load case on a mesh.
struct CaseTemperature {
  TemperatureField field;
  base::Vector temperature; ///< what elements take [connectivity index]; empty: no heat
  std::vector<ResidualTemperaturePoint>
      points;                      ///< the rest, by element; plane quadratic elements only
  std::vector<std::size_t> first;  ///< [element + 1] into points; empty: there are none
  std::vector<bool> discontinuous; ///< [element] it jumps inside; empty: nowhere

  /// Whether the temperature is known inside an element by the field: it varies there, and does not
  /// jump.
  [[nodiscard]] bool is_known_inside(base::ElementId e) const {
    return field.may_vary_inside(e) && (discontinuous.empty() || !discontinuous[e.index()]);
  }
  /// Points of the residual temperature inside an element; empty where it leaves no rest.
  [[nodiscard]] std::span<const ResidualTemperaturePoint>
  residual_points_in_element(base::ElementId e) const {
    return first.empty() ? std::span<const ResidualTemperaturePoint>()
                         : std::span(points).subspan(first[e.index()],
                                                     first[e.index() + 1] - first[e.index()]);
  }
};

struct UnresolvedLoad;

/// Rules that differ subdivide an element until they agree (heat_points.hpp). What they could not
/// follow goes to `missed`.
CaseTemperature make_case_temperature(const model::Model& model, const PatchedMesh& patched,
                                      const model::LoadCase& load_case,
                                      UnresolvedLoad* missed = nullptr);

/// Part of a temperature's total magnitude that no rule could follow, 1 at most.
double unresolved_temperature_fraction(const model::Model& model, const model::Mesh& mesh,
                                       const model::Load& load);

/// A case with the factor it has.
struct ScaledTemperature {
  const CaseTemperature* heat = nullptr;
  double factor = 0.0;
};

/// What an element takes at a point; X and x belong to r.
double projected_temperature(const AnyElement<2>& element, const AnyNodeVectors<2>& X,
                             const ConstitutiveLaw& law, const CornerValues<2>& T,
                             const shape::Point<2>& r);

/// Adds `factor` times the nodal forces of the rest to f [dim * node]; of one material, or all.
void add_residual_temperature_load(const model::Model& model, const model::Mesh& mesh,
                                   const ScaledTemperature& acting, base::MaterialId only,
                                   base::Vector& f);

/// Adds what the rest makes of the elastic energy of the elements, see add_thermal_energy.
void add_residual_temperature_energy(const model::Model& model, const model::Mesh& mesh,
                                     std::span<const ScaledTemperature> acting,
                                     const base::Vector& u, std::vector<double>& energy);

} // namespace spricka::fe
