// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "growth/crack_kinematics.hpp"
#include "model/forward.hpp"
#include "results/growth.hpp"

#include <memory>
#include <string>
#include <vector>

/// What a growth by a law must have, and what its life must not look like.
namespace spricka::analysis {

/// The cracks of $GROW as they are at first, in the plane or in space; null: they cannot grow.
std::unique_ptr<growth::CrackKinematics> make_crack_kinematics(const model::Model& model,
                                                               base::Diagnostics& diagnostics);

/// Doubts about the cycles as a whole: none or next to none, growth too fast for a law.
std::vector<std::string> describe_life_concerns(const results::GrowthResult& growth);

/// How many cycles lie outside the data behind the law of $GROW, and which way it goes on there;
/// empty: none.
std::string describe_use_outside_data(const results::GrowthResult& growth,
                                      const model::Model& model);

} // namespace spricka::analysis
