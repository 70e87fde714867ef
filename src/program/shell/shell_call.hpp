// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/shell/reply.hpp"
#include "program/shell/session.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// A line of the shell whose first word is a command, and what that command works on.
struct ShellCall {
  ShellSession& session;
  const ShellHistory& history;
  const std::vector<std::string>& words; ///< the command first
  const std::string& line;               ///< as typed
  const std::string& usage;
  ShellReply& reply;
};

} // namespace spricka::program
