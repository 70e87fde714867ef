// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

/// Partners that are carried round an axis press on the faces of the crack with lambda v_x / x:
/// what that does on the displacements does not come from the tip (manual, crack.40).
namespace spricka::crack {

/// Takes it from the forces of K and T on the faces of the crack in the elements of all fields.
/// Nothing in the plane.
void add_auxiliary_pressure(const TipSetting& set, const std::vector<ExtensionField>& fields,
                            const base::Vector& u, ConfigurationalForces& out);

/// The same with one auxiliary field and one field as a row, whose product with u it is: added to
/// `row`.
void add_auxiliary_pressure_row(const TipSetting& set, const ExtensionField& field,
                                std::size_t auxiliary, double factor, base::Vector& row);

} // namespace spricka::crack
