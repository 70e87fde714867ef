// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/log_format.hpp"

namespace spricka::program {

/// The exit code with which the program ends: `code`, or file_trouble where it would be success but
/// something written to stdout or stderr is lost.
int written_out(int code, LogFormat format);

} // namespace spricka::program
