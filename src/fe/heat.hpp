// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression_range.hpp"
#include "fe/host_places.hpp"
#include "fe/thermal_kernel.hpp"
#include "model/model.hpp"

#include <memory>
#include <span>
#include <vector>

/// Temperatures as the deck gives them. Elements take a linear part (thermal.hpp); what a
/// temperature has beyond that, a kink, a jump, a root at a tip, the rim of a heated set within an
/// element, acts on their displacements as well, and is known at points (manual, fe.38 and fe.39).
namespace spricka::fe {

/// The stress that a degree takes out, beta of manual fe.21.
inline double heat_modulus(const Law& law) {
  return law.expansion * (law.heated_directions() * law.lambda + 2.0 * law.mu);
}

/// Temperature of one load case anywhere in a mesh, whose patches know what host they stand in.
class HeatField {
public:
  HeatField() = default; ///< of nothing
  HeatField(const PatchedMesh& patched, const model::LoadCase& load_case);

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  /// Whether an element may be heated at all, by a temperature that may be more than a constant.
  [[nodiscard]] bool varies(base::ElementId e) const;
  /// At x in element e. Elements of a patch are heated where the host is.
  [[nodiscard]] double operator()(base::ElementId e, const base::Vec2& x) const;
  /// Bounds over a cell, which a rim of a heated set does not cross.
  [[nodiscard]] base::ValueRange range(base::ElementId e, const base::PlaceCell& cell) const;
  /// Whether the rim of a heated set crosses the patches.
  [[nodiscard]] bool cut() const;

private:
  struct Part {
    base::Expression value;
    std::vector<bool> member; ///< [element]
    bool by_place = false;    ///< of new elements the place decides, not the element
  };
  [[nodiscard]] bool acts(std::size_t part, base::ElementId e, const base::Vec2& x) const;
  std::vector<Part> parts_;
  std::vector<std::vector<bool>> host_member_; ///< [part][host element], of those by place
  std::vector<bool> is_new_;                   ///< [element] of a patch
  std::shared_ptr<const HostPlaces> places_;
};

/// A point of an element, and how far its temperature is from what the element takes.
struct HeatPoint {
  base::ElementId element;
  shape::Point<2> r = shape::Point<2>::Zero();
  double area = 0.0; ///< weight times det J [length^2]
  double T = 0.0;
};

/// Temperatures of one load case on a mesh.
struct CaseHeat {
  HeatField field;
  base::Vector temperature;       ///< what elements take [connectivity index]; empty: no heat
  std::vector<HeatPoint> points;  ///< the rest, by element; plane quadratic elements only
  std::vector<std::size_t> first; ///< [element + 1] into points; empty: there are none
  std::vector<bool> rough;        ///< [element] it jumps inside; empty: nowhere

  [[nodiscard]] std::span<const HeatPoint> of(base::ElementId e) const {
    return first.empty() ? std::span<const HeatPoint>()
                         : std::span(points).subspan(first[e.index()],
                                                     first[e.index() + 1] - first[e.index()]);
  }
};

struct Unresolved;

/// Rules that differ subdivide an element until they agree (heat_points.hpp). What they could not
/// follow goes to `missed`.
CaseHeat case_heat(const model::Model& model, const PatchedMesh& patched,
                   const model::LoadCase& load_case, Unresolved* missed = nullptr);

/// Part of a temperature's total magnitude that no rule could follow, 1 at most.
double unresolved_heat(const model::Model& model, const model::Mesh& mesh, const model::Load& load);

/// A case with the factor it has.
struct ActingHeat {
  const CaseHeat* heat = nullptr;
  double factor = 0.0;
};

/// What an element takes at a point; X and x belong to r.
template <shape::PlaneShape S>
double taken_temperature(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T,
                         const shape::Point<2>& r) {
  if constexpr (plane_quadratic<S>) {
    if (FreeExpansion<S>::wanted(X, law)) {
      return FreeExpansion<S>(X, law, T).temperature(X * S::N(r));
    }
  }
  return T.dot(Linear<S>::N(r));
}

/// Adds `factor` times the nodal forces of the rest to f [dim * node]; of one material, or all.
void add_rest_load(const model::Model& model, const model::Mesh& mesh, const ActingHeat& acting,
                   base::MaterialId only, base::Vector& f);

/// Adds what the rest makes of the elastic energy of the elements, see add_thermal_energy.
void add_rest_energy(const model::Model& model, const model::Mesh& mesh,
                     std::span<const ActingHeat> acting, const base::Vector& u,
                     std::vector<double>& energy);

} // namespace spricka::fe
