// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/load_visit.hpp"
#include "model/forward.hpp"

#include <algorithm>

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
  [[nodiscard]] double missed_fraction() const {
    return missed > 0.0 ? missed / std::max(missed, amount) : 0.0;
  }
};

/// Visits the points of a load that is spread over faces or elements; others (at nodes, given
/// displacements, temperatures) have none. The points follow the load's values
/// (load_rule); of elements that the rim of a set cuts their share counts (set_shares.hpp). What
/// the rules could not follow goes to `missed`.
void for_load_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     const LoadPointVisitor& visit, UnresolvedLoad* missed = nullptr);

} // namespace spricka::fe
