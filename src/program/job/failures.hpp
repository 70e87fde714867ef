// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/log.hpp"

#include <exception>
#include <functional>
#include <string>

/// What went wrong outside of the deck, and what can be done about it.
namespace spricka::program {

/// Does `work` and gives its outcome. A failure of a file that it throws (FileFailure with its own
/// code, std::system_error as E530) goes to the log and gives file_trouble.
base::ProgramOutcome run_reporting_file_failures(const Log& log,
                                                 const std::function<base::ProgramOutcome()>& work);

/// Whether an exception says that memory is at its end: no defect of the program, but
/// ProgramOutcome::not_solvable.
bool is_out_of_memory(const std::exception& trouble);

/// "out of memory: 480 MiB were in use, 488 MiB are allowed (..); .."
std::string out_of_memory_message();

/// What can be done about a model that cannot be solved (E510, E520), for the line below the
/// message; empty where the message says it.
std::string failure_remedy(const base::OperationFailure& answer);

} // namespace spricka::program
