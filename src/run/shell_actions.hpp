// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "run/shell_commands.hpp"
#include "run/shell_text.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What the commands of the shell do with a session.
namespace spricka::run {

struct ShellCall {
  ShellSession& session;
  const std::vector<ShellWord>& words; ///< the command first
  const std::string& line;             ///< as typed
  std::string usage;
  ShellReply& reply;
};

/// A command of the table but help, history and quit.
ShellResult carry_out(std::string_view command, const ShellCall& call);

/// A quantity of $CHECK, its value and unit.
ShellResult answer_quantity(ShellSession& session, const std::string& text, ShellReply& reply);

} // namespace spricka::run
