// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_model.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// The name that a comment gives to a list of numbers, else "SET<number>".
std::string name_of_nastran_list(const NastranBulk& bulk, const NastranBulk::NastranList& list);

/// Makes node and element sets of lists of numbers. Elements that the model does not have, shells
/// on solids for instance, are passed over, and so are numbers of a range that are not there.
void add_nastran_lists(const NastranBulk& bulk, NastranModel& model);

/// Makes node sets of supports, "SPC<set>_<freedoms>" (of PS of a GRID: "PS_<freedoms>"), and of
/// forces, "FORCE_<set>". Freedoms that elements of so many dimensions do not have count for
/// nothing. Returns the names of all sets of supports and loads.
std::vector<std::string> add_nastran_load_sets(const NastranBulk& bulk, int dim,
                                               NastranModel& model,
                                               std::vector<NastranIssue>& complaints);

} // namespace spricka::mesh
