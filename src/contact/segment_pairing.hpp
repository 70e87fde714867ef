// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <optional>

namespace spricka::contact {

/// Fills the rows of a SEGMENT pair whose two surfaces stand in `pair`.
void fill_mortar_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents);

} // namespace spricka::contact
