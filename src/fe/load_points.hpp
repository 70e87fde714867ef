// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <functional>
#include <span>

/// Distributed loads as forces at integration points, for any functions that they shall work on.
namespace spricka::fe {

/// What rules could not follow of a load, and its magnitude, over all sides or elements.
struct UnresolvedLoad {
  double missed = 0.0;
  double amount = 0.0;

  /// Of one, by its reference size; `unit`: the size of that.
  void add(double missed_here, double amount_here, double unit) {
    missed += missed_here * unit;
    amount += amount_here * unit;
  }
  [[nodiscard]] double missed_share() const {
    return missed > 0.0 ? missed / std::max(missed, amount) : 0.0;
  }
};

/// A force at a point of a side or an element.
struct LoadPoint {
  base::Vec3 r = base::Vec3::Zero(); ///< reference coordinates, as many as there are
  base::Vec3 force = base::Vec3::Zero();
};

/// What shall be done with the points of each side and of each element, one after the other.
struct LoadVisit {
  std::function<void(const model::Face&, std::span<const LoadPoint>)> on_face;
  std::function<void(base::ElementId, std::span<const LoadPoint>)> on_body;
};

/// Visits the points of a load that is spread over faces or elements; others (at nodes, given
/// displacements, temperatures, bearings in space) have none. The points follow the load's values
/// (load_rule); of elements that the rim of a set cuts their share counts (set_shares.hpp). What
/// the rules could not follow goes to `missed`.
void for_load_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     const LoadVisit& visit, UnresolvedLoad* missed = nullptr);

} // namespace spricka::fe
