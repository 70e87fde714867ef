// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::program {

/// What times were measured on: "Intel(R) Xeon(R) CPU @ 2.20GHz, 2 cores, 24 GB".
std::string machine_description();

/// Cores that this process may use.
int core_count();

/// What was measured: "spricka 0.1.0 (4f1d22c8)", the digits from the bytes of the program's file,
/// so that two builds of one version are told apart.
std::string program_version_and_build();

} // namespace spricka::program
