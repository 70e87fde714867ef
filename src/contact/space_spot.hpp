// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <set>
#include <vector>

namespace spricka::contact {

/// Normal rows of a solid pair whose pressures meet on a triangle of its surface [row].
std::vector<std::set<std::size_t>> neighbouring_normal_rows(const PairConstraints& pair);

/// How many elements of its surface lie across the spot where a solid pair presses most: across the
/// largest disc of closed nodes that holds its largest pressure. Infinite where the contact has no
/// open edge, or its largest pressure stands at an edge of one surface, where it has no bound.
double count_elements_across_peak(const PairConstraints& pair, const base::Vector& lambda,
                                  const std::vector<bool>& closed);

} // namespace spricka::contact
