// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <map>

namespace spricka::contact {

/// Collects the weights of one row; a map keeps the nodes in order whatever the order of adding.
struct ConstraintRowBuilder {
  std::map<base::NodeId, base::Vec3> weight;
  double gap = 0.0;
  double round_gap = 0.0;
  double area = 0.0;

  void add_contribution(base::NodeId node, const base::Vec3& w) {
    weight.try_emplace(node, base::Vec3::Zero()).first->second += w;
  }
  void add_contribution(const ConstraintRowBuilder& other) {
    for (const auto& [node, w] : other.weight) {
      weight.try_emplace(node, base::Vec3::Zero()).first->second += w;
    }
    gap += other.gap;
    round_gap += other.round_gap;
    area += other.area;
  }
  /// The row of a contact node; a tangential one has the place of its normal row.
  [[nodiscard]] ConstraintRow make_row(base::NodeId node, int normal = -1, int along = 0) const {
    ConstraintRow row;
    for (const auto& [n, w] : weight) {
      row.entries.push_back({n, w});
    }
    row.gap = gap;
    row.round_gap = round_gap;
    row.area = area;
    row.node = node;
    row.tangential = normal >= 0;
    row.normal = normal;
    row.along = along;
    return row;
  }
};

} // namespace spricka::contact
