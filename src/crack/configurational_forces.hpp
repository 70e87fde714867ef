// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_field.hpp"
#include "crack/extension.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace spricka::crack {

/// Configurational forces: how much energy is released as nodes move, of the solution with each
/// auxiliary field [force], in the plane per unit thickness. Terms add to them; G, K and T are
/// their product with a virtual extension. Assembled once for all points and domains of a front.
template <int dim> class InteractionConfigurationalForces {
public:
  explicit InteractionConfigurationalForces(std::size_t nodes) : slot_(nodes, -1) {}

  using OfNode = std::array<shape::Point<dim>, auxiliary_field_count<dim>>;
  /// Of a node; zero where no term has touched it yet.
  OfNode& operator[](base::NodeId n) {
    std::int32_t& slot = slot_[n.index()];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(at_.size());
      at_.emplace_back().fill(shape::Point<dim>::Zero());
    }
    return at_[static_cast<std::size_t>(slot)];
  }
  /// Sum over nodes of their motion times P, of each auxiliary field.
  [[nodiscard]] std::array<double, auxiliary_field_count<dim>>
  released_energies(const VirtualExtensionField& field) const {
    std::array<double, auxiliary_field_count<dim>> sum{};
    for (const NodeMotion& moved : field.motion) {
      const std::int32_t slot = slot_[moved.node.index()];
      if (slot >= 0) { // nodes that no term has touched release nothing
        for (std::size_t k = 0; k < sum.size(); ++k) {
          sum[k] += moved.q *
                    moved.along.template head<dim>().dot(at_[static_cast<std::size_t>(slot)][k]);
        }
      }
    }
    return sum;
  }

private:
  std::vector<std::int32_t> slot_; ///< [node] into at_, or -1
  std::vector<OfNode> at_;
};

} // namespace spricka::crack
