// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/heat.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <vector>

/// What acts on the elements and faces round a tip.
namespace spricka::crack {

/// A load of the deck with the factor it has: TRACTION and PRESSURE act on `faces`, the others on
/// `elements` (force per volume; a temperature is in TipLoads). The load must outlive it.
struct ActingLoad {
  const model::Load* load = nullptr;
  double factor = 0.0;
  std::vector<base::ElementId> elements; ///< ascending
  std::vector<model::Face> faces;
};

struct TipLoads {
  std::vector<ActingLoad> loads;
  base::Vector temperature; ///< of elements [connectivity index], see fe/thermal.hpp; or empty
  std::vector<fe::ScaledTemperature> heat = {}; ///< of the same; empty: elements take all of it

  /// Whether some element feels a force per volume or a temperature.
  [[nodiscard]] bool has_element_loads() const;
};

/// Force per area of one load on a face whose outer normal is n [stress].
base::Vec2 traction(const ActingLoad& acting, const base::Vec2& x, const base::Vec2& n);

} // namespace spricka::crack
