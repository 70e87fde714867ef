// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::report {

/// A number that a card $OUTPUT asks for at the end of a step.
struct RequestedValue {
  /// A node's or, of a front in space, a point's number and place; empty: of the whole set.
  std::optional<std::pair<base::Label, base::Vec3>> where;
  std::string component; ///< "XX", "Y", "K1_BAR"
  double value = 0.0;
  base::QuantityKind kind = base::QuantityKind::number;
};

/// The numbers of one request: K point by point, CPRESS, U and S node by node, REACTION as the sum
/// over the set. Empty where the step has nothing of the kind.
std::vector<RequestedValue> collect_requested_values(const results::CrackLengthResult& increment,
                                                     const results::LoadStepResult& step,
                                                     const model::RequestedQuantity& request);

/// Whether a request for K means a front: by its name or that of its crack.
bool request_names_front(const model::RequestedQuantity& request,
                         const results::FrontResult& front);

} // namespace spricka::report
