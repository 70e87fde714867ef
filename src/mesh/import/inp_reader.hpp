// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/import_request.hpp"
#include "mesh/import/inp_data.hpp"

#include <filesystem>
#include <vector>

namespace spricka::mesh {

/// Reads a file with its includes; complaints leave the data incomplete.
InpData read_inp_data(const std::filesystem::path& file, std::vector<InpIssue>& complaints,
                      InpSkip skip = InpSkip::nothing);

} // namespace spricka::mesh
