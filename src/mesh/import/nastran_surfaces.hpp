// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_model.hpp"
#include "mesh/label_index.hpp"

#include <vector>

namespace spricka::mesh {

/// Makes surfaces of the sides that skins lie on, "S<property>", of those in lists of elements,
/// "SET<number>" or its name, and of the sides that PLOAD4 acts on, "PLOAD4_<set>". Elements and
/// nodes of `model` must be sound.
void add_nastran_surfaces(const NastranBulk& bulk, std::vector<NastranSkin>& skins,
                          const LabelIndex& nodes, NastranModel& model,
                          std::vector<NastranIssue>& complaints);

} // namespace spricka::mesh
