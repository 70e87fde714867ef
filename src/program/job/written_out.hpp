// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/log_format.hpp"

namespace spricka::program {

/// Whether all that was written to stdout and stderr has got there; what stdout lacks is told.
bool check_streams_written(LogFormat format);

} // namespace spricka::program
