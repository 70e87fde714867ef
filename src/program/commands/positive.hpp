// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/CLI.hpp>

namespace spricka::program {

/// An option's value is a finite number above 0.
CLI::Validator positive_validator();

} // namespace spricka::program
