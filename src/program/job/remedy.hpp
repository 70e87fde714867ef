// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <string>

namespace spricka::program {

/// What can be done about a model that cannot be solved (E510, E520), for the line below the
/// message; empty where the message says it.
std::string failure_remedy(const base::OperationFailure& answer);

} // namespace spricka::program
