// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/state_field.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::fe {

/// Stress at the nodes of every element, evaluated there from the element's own displacements
/// [connectivity index, as Mesh::nodes]; infinite values at quarter-point tips are replaced by the
/// element's centroid value.
std::vector<Stress> element_node_stress(const model::Model& model, const model::Mesh& mesh,
                                        const DisplacementTemperatureField& field);

/// Mean over the elements that meet at a node and share its body and property: a value for each of
/// the mesh's property points (model/property_points.hpp), so that nothing is averaged across a
/// material's boundary. [point]
std::vector<Stress> nodal_stress(const model::Model& model, const model::Mesh& mesh,
                                 const std::vector<Stress>& element_stress);

/// Mean over the volume of every element. [element]
std::vector<Stress> element_mean_stress(const model::Model& model, const model::Mesh& mesh,
                                        const DisplacementTemperatureField& field);

/// Stress at a point inside the body (the element is searched); empty outside. On a side or a node
/// the mean of the elements there that hang together and share a property. A point of the true
/// boundary that lies off the mesh by less than 5 % of an element (the sagitta of an arc) belongs
/// to the nearest element.
std::optional<Stress> stress_at_body_point(const model::Model& model, const model::Mesh& mesh,
                                           const DisplacementTemperatureField& field,
                                           const base::Vec3& point);

} // namespace spricka::fe
