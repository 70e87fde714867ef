// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/run_options.hpp"

#include <string>

#include <CLI/CLI.hpp>

/// Options of all commands that read a deck. What they set must live as long as the command.
namespace spricka::program {

/// DECK, -D, --log-format and the limits of meshing.
void add_deck_options(CLI::App& command, RunOptions& options);

/// --threads, a whole number from 0.
void add_threads_option(CLI::App& command, int& threads, const std::string& doc);

} // namespace spricka::program
