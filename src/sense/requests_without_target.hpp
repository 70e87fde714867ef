// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

#include <set>
#include <string>

/// Requests for what a model no longer has.
namespace spricka::sense {

/// Names of contacts, cracks and sets that there are something of.
std::set<std::string> existing_entity_names(const model::Model& model);

/// Warns (W366) of outputs and checks of named things that were there `before` and are gone; the
/// outputs go, too: a sum over nothing would be zero.
void drop_requests_without_target(model::Model& model, const std::set<std::string>& before,
                                  base::Diagnostics& list);

} // namespace spricka::sense
