// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/growth.hpp"

#include <string>

namespace spricka::report {

/// Sentences on the law of $GROW: the toughness and threshold that it took, where its constants are
/// from, what is known of their data, and what it was asked for.
std::string growth_law_summary(const model::Model& model, const results::GrowthResult& growth);

} // namespace spricka::report
