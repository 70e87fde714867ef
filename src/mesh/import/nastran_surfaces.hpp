// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_bulk.hpp"
#include "mesh/label_index.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// An element of one dimension less than the parts: a shell on a solid, a bar on an edge.
struct NastranSkin {
  base::Label label = 0, property = 0;
  std::vector<base::Label> corners;
  std::string name;
  InpLocation place;
  bool lies_on_side = false; ///< found by add_nastran_surfaces
};

/// Makes surfaces of the sides that skins lie on, "S<property>", and of the sides that PLOAD4 acts
/// on, "PLOAD4_<set>". Elements and nodes of `data` must be sound.
void add_nastran_surfaces(const NastranBulk& bulk, std::vector<NastranSkin>& skins,
                          const LabelIndex& nodes, InpData& data,
                          std::vector<InpIssue>& complaints);

} // namespace spricka::mesh
