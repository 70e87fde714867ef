// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/reply.hpp"
#include "program/shell/reply_text.hpp"
#include "program/shell/session.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What the commands of the shell do with a session.
namespace spricka::program {

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

// What commands share.
ShellTrouble wrong(const ShellCall& call);
std::string name_at(const ShellCall& call, std::size_t i); ///< upper case
/// The rest of the line from a word on, an = at its beginning left out.
std::string rest_from(const ShellCall& call, std::size_t i);
/// The same as a number.
ShellResult number_from(const ShellCall& call, std::size_t i, grammar::Quantity quantity,
                        double& value);
/// Solves what is pending before a question; its notes are told.
ShellResult settle(ShellSession& session, ShellReply& reply);

// Questions, in a file of their own.
ShellResult do_k(const ShellCall& call);
ShellResult do_pressure(const ShellCall& call);
ShellResult do_arc(const ShellCall& call);
ShellResult do_reaction(const ShellCall& call);
ShellResult do_displacement(const ShellCall& call);
ShellResult do_stress(const ShellCall& call);
ShellResult do_map(const ShellCall& call);
ShellResult do_sensitivity(const ShellCall& call);

} // namespace spricka::program
