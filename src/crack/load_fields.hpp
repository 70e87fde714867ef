// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_loads.hpp"
#include "fe/set_shares.hpp"

#include <functional>
#include <vector>

/// Forces per volume round a front at the points that they are integrated at (fe/load_rule.hpp), so
/// that G and K see what the solution has seen.
namespace spricka::crack {

/// A force per volume with what its rule and its set need. Refers to the loads of a front.
struct BodyForceField {
  const ActingLoad* acting = nullptr;
  fe::ElementSetCoverage shares; ///< of sets that patches cut, in the plane
  fe::FieldMagnitude scale;
};

/// What the scale of a load is taken of: all elements of its set, or those near the front.
enum class LoadScaleScope { whole_set, near_front };
/// The forces per volume round a front.
std::vector<BodyForceField> body_force_fields(const model::Model& model, const model::Mesh& mesh,
                                              const FrontLoads& loads, LoadScaleScope scale);

/// Visits the points of an element with nodes X: reference point, weight and the forces per volume
/// b there [force/length^3].
template <int dim>
using BodyForceVisit =
    std::function<void(const shape::Point<dim>& r, double weight, const shape::Point<dim>& b)>;
/// Goes through the points of all body forces that act on element `e`, one force after the other,
/// each with its own rule; shares of cut sets and load factors are in b. In the plane and in space.
template <int dim>
void visit_body_force_points(const model::Mesh& mesh, const std::vector<BodyForceField>& fields,
                             base::ElementId e, const fe::AnyNodeVectors<dim>& X,
                             const BodyForceVisit<dim>& visit);

} // namespace spricka::crack
