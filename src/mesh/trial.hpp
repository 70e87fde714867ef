// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>

namespace spricka::mesh {

/// Does work in a child process first and tells whether it came to its end: libraries that abort or
/// crash on damaged files take only the child with them. The child is silent, may take `memory`
/// bytes beyond what the program has, and leaves nothing behind. True where no child can be made.
bool ends_well(const std::function<void()>& work, std::size_t memory);

} // namespace spricka::mesh
