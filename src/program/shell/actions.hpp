// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/shell_call.hpp"

#include <string>
#include <vector>

/// What the commands of the shell do with a session.
namespace spricka::program {

/// A line of $CHECK without its value: the value and its unit.
base::OptionalFailure evaluate_result_line(ShellSession& session, const std::string& line,
                                           ShellReply& reply);
/// A card with other keys, or a parameter with another value; then the state.
base::OptionalFailure apply_deck_change(ShellSession& session, const std::string& line,
                                        bool is_card, ShellReply& reply);
/// What `list` can show, beside what is set.
std::vector<std::string> topics_of_list_command();

// Commands of the table but help and quit.

/// LOAD, FIT, MOUNT and DISMOUNT: the line is one of $STEP.
base::OptionalFailure do_add_step_action(const ShellCall& call);
/// Solves what is pending, with friction in as many substeps as the line says.
base::OptionalFailure do_solve(const ShellCall& call);
/// Goes to the end of a step of the deck.
base::OptionalFailure do_go_to_step(const ShellCall& call);
/// Lists what is set, a table of results, or cards.
base::OptionalFailure do_list(const ShellCall& call);
/// Grows the cracks by the law of $GROW: stations, end and life.
base::OptionalFailure do_grow(const ShellCall& call);
/// Solves a load path of the deck, or a load case from one factor to another.
base::OptionalFailure do_follow_load_path(const ShellCall& call);
/// Writes a picture.
base::OptionalFailure do_plot(const ShellCall& call);
/// Writes the deck with what is set.
base::OptionalFailure do_save(const ShellCall& call);
/// Takes the last change back.
base::OptionalFailure do_undo(const ShellCall& call);
/// Reads the deck again and forgets all changes.
base::OptionalFailure do_reset(const ShellCall& call);

} // namespace spricka::program
