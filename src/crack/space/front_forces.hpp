// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/space/front_setting.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace spricka::crack {

/// Configurational forces along a front: how much energy is released as nodes move, of the solution
/// with each auxiliary field [force]. Assembled once for all points and domains.
class FrontConfigurationalForces {
public:
  explicit FrontConfigurationalForces(std::size_t nodes) : slot_(nodes, -1) {}

  using OfNode = std::array<base::Vec3, front_auxiliary_field_count>;
  OfNode& operator[](base::NodeId n);
  /// Sum over nodes of their motion times P, of each auxiliary field.
  [[nodiscard]] std::array<double, front_auxiliary_field_count>
  released_energies(const ExtensionField& field) const;

private:
  std::vector<std::int32_t> slot_; ///< [node] into at_, or -1
  std::vector<OfNode> at_;
};

/// Terms that tests leave out one by one to see that they are needed.
struct FrontTermSwitches {
  bool divergence = true; ///< of the auxiliary fields' stress (crack_space.8)
  bool tractions = true;  ///< of the auxiliary fields on free sides
};

/// What the elements of the domains give: energy-momentum, the divergence of the auxiliary fields'
/// stress, forces per volume and the temperature's gradient (crack_space.6, crack_space.8).
void add_element_forces(const FrontSetting& set, const FrontExtensions& fields,
                        const TipLoads& loads, const base::Vector& u,
                        FrontConfigurationalForces& out, const FrontTermSwitches& terms = {});

} // namespace spricka::crack
