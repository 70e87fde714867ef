// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_bulk.hpp"

#include <filesystem>
#include <vector>

namespace spricka::mesh {

/// Reads the bulk data of a file with its includes; complaints leave the data incomplete. Entries
/// that are not read, and have a say in the mechanics, are in `refused`, those of loads and
/// supports in `loads`.
NastranBulk read_nastran_bulk(const std::filesystem::path& file,
                              std::vector<NastranIssue>& complaints);

} // namespace spricka::mesh
