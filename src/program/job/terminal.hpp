// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/messages.hpp"

#include <cstddef>

namespace spricka::program {

/// Whether messages may be coloured: stderr is a terminal that is not dumb, and NO_COLOR (see
/// no-color.org) is unset or empty.
base::MessageColour message_colour();

/// Columns of text on stdout: those of the terminal, at most 110; 100 where it is none.
std::size_t text_columns();

} // namespace spricka::program
