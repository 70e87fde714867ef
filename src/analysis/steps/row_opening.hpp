// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

namespace spricka::analysis {

/// sum weight . u of a row, from nodal displacements [dim * node].
double row_opening(const contact::ConstraintRow& row, int dim, const base::Vector& u);

} // namespace spricka::analysis
