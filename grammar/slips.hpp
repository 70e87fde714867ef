// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace spricka::grammar {

/// What to write in place of a sign of other languages, or of a word processor, that stands at `p`;
/// empty for any other. `begin` is the start of the text that `p` lies in.
std::string_view foreign_syntax_hint(const char* begin, const char* p, const char* last);

} // namespace spricka::grammar
