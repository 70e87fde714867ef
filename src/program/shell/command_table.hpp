// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/shell/shell_call.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The words of `spricka shell`: one table from which help, completion and the manual come. Nothing
/// here prints; what a command has to say is text in its reply.
namespace spricka::program {

/// What a command's arguments stand for, for completion; '.' is anything that cannot be listed.
/// Letters are those of candidate_argument_names, and w a command, q what is listed, k a kind of
/// picture, M a load path or case, f a file.
struct ShellCommand {
  std::string_view word;
  std::string_view arguments; ///< as a user reads them
  std::string_view letters;   ///< of the arguments in order
  std::string_view doc;       ///< one line
  std::string_view more;      ///< further lines; may be empty
  base::OptionalFailure (*act)(const ShellCall&);
};
/// All commands of the prompt in the order of its help; the table lives as long as the process.
const std::vector<ShellCommand>& shell_commands();
/// Their words.
std::vector<std::string> command_words();

/// Carries out one line; an empty one does nothing.
ShellReply run_shell_line(ShellSession& session, const ShellHistory& history,
                          const std::string& line);

/// The commands as a table of the manual.
std::string shell_commands_markdown();

/// "LOAD* a = 10.8> ": the step that the state began with, + where changes came after it, *
/// where some are pending; (path) where friction makes the order count.
std::string shell_prompt(const ShellSession& session);

} // namespace spricka::program
