// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::program {

/// Messages for people, or one JSON object a line for programs.
enum class LogFormat { text, json };

} // namespace spricka::program
