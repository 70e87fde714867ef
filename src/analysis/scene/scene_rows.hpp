// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"

namespace spricka::analysis {

/// Strings the rows of all pairs into the table and reduces them to independent freedoms.
void make_row_table(Discretisation& scene);

} // namespace spricka::analysis
