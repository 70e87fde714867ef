// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <string>
#include <utility>

/// Why a command of the shell has no answer; its outcome is the one a run would end with.
namespace spricka::program {

/// What was typed cannot be done so.
inline base::OperationFailure invalid_input(std::string why, std::string hint = {}) {
  return {.kind = base::Outcome::usage, .why = std::move(why), .hint = std::move(hint)};
}

/// Mistakes as base::format() gives them, with their places.
inline base::OperationFailure located_failure(base::Outcome kind, std::string messages) {
  return {.kind = kind, .why = std::move(messages), .complete = true};
}

} // namespace spricka::program
