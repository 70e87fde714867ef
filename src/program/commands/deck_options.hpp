// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/job/run_options.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

/// Options of all commands that read a deck. What they set must live as long as the command.
namespace spricka::program {

/// DECK, -D, --log-format and the limits of meshing.
void add_deck_options(CLI::App& command, RunOptions& options);

/// -D NAME=EXPR, which may be given again; `doc` is what the help says of it.
void add_define_option(CLI::App& command, std::vector<std::pair<std::string, std::string>>& defines,
                       const std::string& doc);

/// --engine, what solves the equations: its word, which engine_of_word() knows.
void add_engine_option(CLI::App& command, std::string& engine);

/// --threads, a whole number from 0.
void add_threads_option(CLI::App& command, int& threads, const std::string& doc);

/// --array and --collect, of commands whose runs the tasks of a job array can share.
void add_array_options(CLI::App& command, std::optional<ArrayTask>& array, bool& collect);

} // namespace spricka::program
