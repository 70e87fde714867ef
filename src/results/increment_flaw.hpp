// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>

namespace spricka::results {

/// What is wrong with a whole increment that was read from a file: an index that names nothing, an
/// array that is not as long as its mesh asks for, a word that does not exist. Empty: nothing, all
/// of it may be looked up.
std::string describe_increment_corruption(const CrackLengthResult& increment);

} // namespace spricka::results
