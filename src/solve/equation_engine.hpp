// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/equation_engines.hpp"

namespace spricka::solve {

using base::EquationEngine;

} // namespace spricka::solve
