// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <cstdint>
#include <optional>
#include <string>

/// How an operation ends, and the one way to say that it has no answer. Mistakes of a deck go to
/// Diagnostics, of which there may be many. An exception is thrown for what comes from outside the
/// model and concerns no caller on the way, however deep it happens: files (std::system_error,
/// archive::FileFailure) and memory (std::bad_alloc). The command catches it.
namespace spricka::base {

/// How the program ends, from best to worst; what scripts see of it is in exit_codes.hpp.
enum class ProgramOutcome : std::uint8_t {
  done,
  check_failed,
  usage,
  deck_error,
  not_solvable,
  not_converged,
  stopped,
  file_trouble,
  defect,
};

/// Why there is no answer: of what kind, in words, and at which place of the deck.
struct OperationFailure {
  ProgramOutcome kind = ProgramOutcome::not_solvable;
  std::string why = {};
  SourceSpan span = {};  ///< may be no place
  std::string hint = {}; ///< what was probably meant; may be empty
  bool complete = false; ///< `why` is whole messages with their places, ended by a newline
};

/// Empty: there is an answer.
using OptionalFailure = std::optional<OperationFailure>;

} // namespace spricka::base
