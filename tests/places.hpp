// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

/// Where tests find what they read and run, and how much of it.
namespace spricka::test {

/// The folder of the whole project.
std::string source_folder();

/// The decks that ship.
std::string decks_folder();

/// The program as it was built beside the tests.
std::string program_file();

/// Whether tests run at full size (SPRICKA_FULL in the environment), not at that of every day.
bool full_size();

} // namespace spricka::test
