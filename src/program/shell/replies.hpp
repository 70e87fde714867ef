// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"

#include <string>

/// Answers of a session as text.
namespace spricka::program {

/// K, error bars, energy release rate and T of the tips; of one crack or tip where `only` is not
/// empty.
std::string k_reply(const ShellSession& session, const std::string& only);
/// What a reader of these K must not miss, one line each.
std::string k_notes(const ShellSession& session, const std::string& only);
/// K of all tips and the contacts, a line for each.
std::string state_reply(const ShellSession& session);
/// Pressure along a contact.
std::string pressure_reply(const ShellSession& session, const results::ContactResult& contact);
/// Where a contact is closed.
std::string arc_reply(const ShellSession& session, const results::ContactResult& contact);
/// K at the breakpoints of the path that was followed last.
std::string map_reply(const ShellSession& session);
std::string sensitivity_reply(const ShellSession& session);
/// Loads, fits, lengths, parameters, steps.
std::string settings_reply(const ShellSession& session);
/// What the last solution has to say: warnings, and notes that were not given before.
std::string state_notes(ShellSession& session);

} // namespace spricka::program
