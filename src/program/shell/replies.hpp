// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"

#include <string>

/// Answers of a session as text, but for those about K (k_replies.hpp).
namespace spricka::program {

/// K of all fronts and the contacts, a line for each.
std::string state_reply(const ShellSession& session);
/// Table of the points of a contact: place, pressure, shear traction, gap and state. The recovery
/// of the pressure is the one that $CONTACT asks for.
std::string pressure_reply(const ShellSession& session, const results::ContactResult& contact);
/// Where a contact is closed.
std::string arc_reply(const ShellSession& session, const results::ContactResult& contact);
/// Table of the derivatives of K at the present state, without a title.
std::string sensitivity_reply(const ShellSession& session);
/// Loads, fits, lengths, parameters, steps.
std::string settings_reply(const ShellSession& session);
/// What the last solution has to say: warnings, and notes that were not given before.
std::string state_notes(ShellSession& session);

} // namespace spricka::program
