// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <exception>
#include <string>

/// Too little memory is no defect of the program: Outcome::not_solvable, with the amounts.
namespace spricka::program {

/// Whether an exception says that memory is at its end.
bool is_out_of_memory(const std::exception& trouble);

/// "out of memory: 480 MiB were in use, 488 MiB are allowed (..); .."
std::string out_of_memory_message();

} // namespace spricka::program
