// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
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
base::Trouble run_shell_command(std::string_view command, const ShellCall& call);

/// A quantity of $CHECK, its value and unit.
base::Trouble answer_quantity(ShellSession& session, const std::string& text, ShellReply& reply);

// What commands share.
base::OperationFailure wrong_usage(const ShellCall& call);
/// Word i of a command in upper case, as names of the deck are.
std::string name_argument(const ShellCall& call, std::size_t i); ///< upper case
/// The rest of the line from a word on, an = at its beginning left out.
std::string remaining_text(const ShellCall& call, std::size_t i);
/// The rest of the line from word i on as a number of a quantity, with its unit and the deck's
/// parameters. Without a rest: wrong usage.
base::Trouble number_argument(const ShellCall& call, std::size_t i, grammar::Quantity quantity,
                              double& value);
/// Solves what is pending before a question; its notes are told.
base::Trouble solve_pending_changes(ShellSession& session, ShellReply& reply);

// Questions, in a file of their own.
base::Trouble do_k(const ShellCall& call);
/// Answers `pressure`: the table along a contact, or the pressure at an angle or near a point.
base::Trouble do_pressure(const ShellCall& call);
/// Answers `arc`: where a contact is closed.
base::Trouble do_arc(const ShellCall& call);
/// Answers `reaction`: the force of the supports on a set, by axis.
base::Trouble do_reaction(const ShellCall& call);
/// Answers `displacement`: its components at a point.
base::Trouble do_displacement(const ShellCall& call);
/// Answers `stress`: components, first principal and von Mises stress at a point.
base::Trouble do_stress(const ShellCall& call);
/// Answers `map`: solves a load path of the deck, or a load case from one factor to another.
base::Trouble do_map(const ShellCall& call);
/// Answers `sensitivity`: the derivatives of K, with the notes why some are missing.
base::Trouble do_sensitivity(const ShellCall& call);

} // namespace spricka::program
