// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

namespace spricka::crack {

/// Adds what the elements of the fields give: energy-momentum where q varies (manual, crack.4 and
/// crack.10), forces per volume (crack.19) and the temperature's gradient (crack.22) wherever q is
/// not zero.
void add_domain_terms(const TipSetting& set, const std::vector<ExtensionField>& fields,
                      const base::Vector& u, ConfigurationalForces& out);

} // namespace spricka::crack
