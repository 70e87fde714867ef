// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/messages.hpp"
#include "base/outcome.hpp"

#include <string>
#include <utility>

/// Why a command of the shell has no answer; its outcome is the one a run would end with.
namespace spricka::program {

/// What was typed cannot be done so.
inline base::OperationFailure invalid_input(std::string why, std::string hint = {}) {
  return {.kind = base::ProgramOutcome::usage, .why = std::move(why), .hint = std::move(hint)};
}

/// Mistakes with their places, as a run shows them.
inline base::OperationFailure located_failure(base::ProgramOutcome kind,
                                              const base::SourceTexts& sources,
                                              const base::Diagnostics& diagnostics) {
  return {.kind = kind, .why = base::format_messages(sources, diagnostics), .complete = true};
}

} // namespace spricka::program
