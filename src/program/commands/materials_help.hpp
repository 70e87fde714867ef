// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>

namespace spricka::program {

/// The growth laws that ship, for $GROW MATERIAL=, in lines of at most `width` columns: law, form,
/// orientation, toughness, range of the data, source; what is not known is said.
std::string list_shipped_growth_laws(std::size_t width);

} // namespace spricka::program
