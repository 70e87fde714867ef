// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

namespace spricka::mesh {

/// Divides a line, from length s0 to s1, into elements of the size that is wanted at each s: the
/// lengths of their ends, s0 and s1 included.
std::vector<double> divide_line_by_size(double s0, double s1,
                                        const std::function<double(double)>& size);

} // namespace spricka::mesh
