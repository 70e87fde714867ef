// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/run_profile.hpp"

#include <string>

namespace spricka::program {

/// The run as a trace in the format of Chrome's viewer, JSON: complete events with `ts` and `dur`
/// in microseconds since the run began. Process 1 is the program, its thread 0 the main one;
/// process 2 the mesher. Memory after each stretch comes as a counter. Events of one thread lie
/// within each other or one after another.
std::string trace_json(const results::RunProfile& profile);

} // namespace spricka::program
