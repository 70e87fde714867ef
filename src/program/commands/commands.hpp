// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/commands/program_text.hpp"

#include <filesystem>
#include <string>

/// The commands behind the command line but for run and check (run_deck.hpp): each prints its data
/// to stdout, its messages to stderr and returns how it ended. They know nothing of CLI11.
namespace spricka::program {

struct HelpOptions {
  std::string topic; ///< a card, key, result, error code, word of the field, list; or empty
  bool markdown = false;
};
base::Outcome help_command(const HelpOptions& options, const ProgramText& program);

struct FormatOptions {
  std::filesystem::path deck; ///< "-": standard input
  bool in_place = false;
  bool check = false;
};
base::Outcome format_command(const FormatOptions& options);

base::Outcome schema_command();

/// `editor` is "vim" or "vscode".
base::Outcome editor_command(const std::string& editor);

} // namespace spricka::program
