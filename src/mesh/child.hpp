// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace spricka::mesh {

/// Does work in a child process and returns the bytes it makes; empty if the child did not come to
/// its end: libraries that abort or crash on damaged files take only the child with them. The child
/// is silent and may take `memory` bytes beyond what the program has. Where no child can be made
/// the work is done here.
std::optional<std::string> in_child(const std::function<std::string()>& work, std::size_t memory);

} // namespace spricka::mesh
