// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <optional>

namespace spricka::program {

/// How many times as many elements `after` has as `before`, where sizes alone have changed: by more
/// than 15 %, in sets of the same names and extents. Else empty.
std::optional<double> element_count_ratio(const model::Mesh& before, const model::Mesh& after);

} // namespace spricka::program
