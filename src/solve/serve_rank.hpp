// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/communicator.hpp"

namespace spricka::solve {

/// What a rank other than 0 does: condenses the nets that rank 0 sends, keeps their factors and
/// answers for them, until rank 0 ends it; returns the exit code that this one says. Writes
/// nothing.
int serve_rank(Communicator& communicator);

} // namespace spricka::solve
