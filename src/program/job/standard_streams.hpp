// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/messages.hpp"

#include <cstddef>
#include <string_view>

/// stdout and stderr, which can be a terminal, a full disk, a pipe that nobody reads, or closed.
namespace spricka::program {

/// To be called before anything is opened: a standard stream that is closed is opened on nothing,
/// so that no file of results takes its number. What is written to it fails, as it should.
void ensure_standard_streams_open();

/// Writes to stdout, as far as it goes: what is lost is told at the end by check_streams_written.
void write_to_stdout(std::string_view text);

/// Writes to stderr; that it cannot is told by the exit code (check_streams_written), as there is
/// no other place to say so.
void write_to_stderr(std::string_view text);

/// Whether messages may be coloured: stderr is a terminal that is not dumb, and NO_COLOR (see
/// no-color.org) is unset or empty.
base::MessageColour message_colour();

/// Columns of text on stdout: those of the terminal, at most 110; 100 where it is none.
std::size_t text_columns();

} // namespace spricka::program
