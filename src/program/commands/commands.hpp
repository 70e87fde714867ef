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
/// Prints the help on a topic, as plain text or markdown; on an unknown word where it stands in the
/// texts, else a hint.
base::ProgramOutcome help_command(const HelpOptions& options, const ProgramText& program);

struct FormatOptions {
  std::filesystem::path deck; ///< "-": standard input
  bool in_place = false;
  bool check = false;
};
/// Prints a deck in the standard layout, writes it in place, or checks that it has that layout.
base::ProgramOutcome format_command(const FormatOptions& options);

/// Prints all cards, keys and results of the language as JSON.
base::ProgramOutcome schema_command();

/// Prints the syntax file for an editor: `editor` is "vim" or "vscode".
base::ProgramOutcome editor_command(const std::string& editor);

} // namespace spricka::program
