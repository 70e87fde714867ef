// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace spricka::program {

/// The command line in words, from which completion and man page are made.
struct OptionText {
  std::vector<std::string> names; ///< "-D", "--out"; one plain name for a positional argument
  std::string value;              ///< what follows it, "FILE"; empty for a flag
  std::string doc;
  bool positional = false;
  bool required = false;
};

struct CommandText {
  std::string name;
  std::string doc;
  std::vector<OptionText> options;
  std::string examples; ///< lines of a shell
};

struct ProgramText {
  std::string version;
  std::string doc;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;
};

/// The bash completion script for all commands and their options.
std::string bash_completion(const ProgramText& program);

/// The man page spricka.1 in roff: commands, options, prompt and exit statuses.
std::string man_page(const ProgramText& program);

} // namespace spricka::program
