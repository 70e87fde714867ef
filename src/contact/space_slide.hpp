// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/slide_record.hpp"

#include <span>

namespace spricka::contact {

/// measure_slide() between solids; u [3 * node]. Lengths of the pressed part and of faces are roots
/// of their areas.
SlideMeasures measure_space_slide(const PairConstraints& pair, const base::Vector& lambda,
                                  const base::Vector& u,
                                  std::span<const base::Matrix* const> motions);

} // namespace spricka::contact
