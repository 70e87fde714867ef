// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_bulk.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// Bulk data as a model part.
struct NastranModel {
  InpData data;
  /// What lies on sides of the parts and carries load in the file: "CQUAD4 of property 5".
  std::vector<std::string> skins_with_stiffness;
  std::vector<InpIssue> stray_skins;  ///< those on no side: one for each property and entry
  std::vector<std::string> load_sets; ///< where supports and loads act
};

/// Elements in our order of nodes and right-handed, points in the basic system, a set "P<number>"
/// for each property and one with its name where comments give it, surfaces, sets of supports and
/// loads, materials "M<number>". What is wrong goes to `complaints`; the model is not to be used
/// then.
NastranModel make_nastran_model(const NastranBulk& bulk, std::vector<InpIssue>& complaints);

} // namespace spricka::mesh
