// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"

#include <string>

/// Answers of a session as text, from the tables of quantities that files and listing have.
namespace spricka::program {

/// Size and K of all fronts, in space the range of K1, and the contacts, a line for each.
std::string K_and_contact_state_reply(const ShellSession& session);
/// What the last solution has to say: warnings, and notes that were not given before.
std::string warnings_and_new_notes(ShellSession& session);

/// The present state alone, with the fronts of one crack, tip or front, or of all for an empty
/// name: for the tables of the listing.
results::CrackLengthResult present_state_of_crack(const ShellSession& session,
                                                  const std::string& only);
/// Tables of K as the listing has them, a row for each tip or point of a front.
std::string k_reply(const ShellSession& session, const std::string& only);
/// What a reader of these K must not miss, one line each.
std::string k_notes(const ShellSession& session, const std::string& only);
/// Derivatives of K, without a title.
std::string sensitivity_reply(const ShellSession& session);
/// The points of a contact with the quantities of pressure.csv and the gap.
std::string contact_reply(const ShellSession& session, const results::ContactResult& contact);
/// K at the breakpoints of the path that was followed last.
std::string K_along_load_path_reply(const ShellSession& session);
/// Stations, end and life of the growth that was made last, as the listing of a run has them.
std::string growth_reply(const ShellSession& session);
/// What fronts it took, and what its reader must not miss, one line each.
std::string growth_notes(const ShellSession& session);
/// The step that the state began with, what was changed since, and the state.
std::string changes_and_state_reply(const ShellSession& session);
/// The cards of a name (upper case, without $) as they are now, with the steps typed; empty: none.
std::string cards_reply(const ShellSession& session, const std::string& name);

} // namespace spricka::program
