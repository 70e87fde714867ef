// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/slide_record.hpp"

#include <span>

/// Whether displacements are still as small as contact needs: it pairs the bodies as drawn.
namespace spricka::contact {

/// Measures the slide of a pair under multipliers lambda [normal rows, then tangents] [stress] with
/// displacements u [dim * node] [length]; places have the relative motions of `motions` [dim *
/// node, n].
SlideMeasures measure_slide(const PairConstraints& pair, const base::Vector& lambda,
                            const base::Vector& u,
                            std::span<const base::Matrix* const> motions = {});

} // namespace spricka::contact
