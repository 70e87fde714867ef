// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_field.hpp"

#include <functional>
#include <map>
#include <vector>

/// K and T as functionals of any displacement.
namespace spricka::crack {

/// What a displacement is contracted with at a point: its gradient, and about an axis the strain
/// round it.
struct ContractionTensor {
  Eigen::Matrix2d M;
  double hoop = 0.0;
};
/// At the point r of an element, with the map there; the weight of the point is in it.
using ContractionVisit =
    std::function<void(base::ElementId e, const shape::Point<2>& r,
                       const fe::Jacobian<PlaneElement>& at, const ContractionTensor& contracted)>;

/// Visits the points of all elements of all domains, averaged over these, with one auxiliary field.
void for_contractions(const TipSetting& set, const std::vector<ExtensionField>& fields,
                      std::size_t auxiliary, const ContractionVisit& visit);

} // namespace spricka::crack
