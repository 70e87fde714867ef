// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace spricka::solve {

/// Names and versions of the numerical libraries that the program is running with.
std::vector<std::pair<std::string, std::string>> library_versions();

} // namespace spricka::solve
