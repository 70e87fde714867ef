// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/slide_record.hpp"

#include <span>

/// Whether displacements are still as small as contact needs: it pairs the bodies as drawn.
namespace spricka::contact {

/// Measures the slide of a pair under multipliers lambda [normal rows, then tangents] [stress] with
/// displacements u [dim * node] [length]; `motions` [dim * node, n] are those by which
/// the places have relative motions.
SlideMeasures measure_slide(const PairConstraints& pair, const base::Vector& lambda,
                            const base::Vector& u,
                            std::span<const base::Matrix* const> motions = {});

} // namespace spricka::contact
