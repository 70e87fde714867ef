// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

/// What a temperature that is not linear within elements, or not in the same way in all of them,
/// adds to G, K and T.
namespace spricka::crack {

/// The linear temperature that comes nearest to that of the domains and has its value at the tip;
/// empty where elements take all of the temperature and the rim of no heated set is in the domains.
std::optional<AffineTemperature>
fit_affine_temperature(const TipContext& set, const mesh::CrackFront& front,
                       const std::vector<VirtualExtensionField>& fields);

/// Whether a temperature jumps within elements of a domain.
bool has_temperature_jump_in_element(const TipContext& set, const VirtualExtensionField& field);

/// Of one domain, by auxiliary field: to K and T what the temperature less the affine one makes of
/// them, by parts, so that it needs no gradient (manual, crack.34); to G what the temperature less
/// that of the elements does, its jumps between elements included (crack.35).
std::array<double, auxiliary_field_count<2>>
nonlinear_temperature_term(const TipContext& set, const mesh::CrackFront& front,
                           const VirtualExtensionField& field, const base::Vector& u);

} // namespace spricka::crack
