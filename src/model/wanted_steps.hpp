// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"

#include <vector>

namespace spricka::model {

/// The steps of an increment that an output card wants, by index.
std::vector<std::size_t> output_step_indices(const Model& model, const OutputFileRequest& output,
                                             bool last_increment);

} // namespace spricka::model
