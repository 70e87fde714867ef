// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::archive {

/// "spricka 0.1.0" and a line for each library.
std::string version_text();

} // namespace spricka::archive
