// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/inp_data.hpp"

#include <filesystem>
#include <vector>

namespace spricka::mesh {

/// Reads a file with its includes; complaints leave the data incomplete. With `skip_loads`
/// supports, loads and steps are passed over.
InpData read_inp_data(const std::filesystem::path& file, std::vector<InpIssue>& complaints,
                      bool skip_loads = false);

} // namespace spricka::mesh
