// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <vector>

/// What results have in them for those who look at them: stresses, surfaces, nodes of sets.
namespace spricka::analysis {

/// Stresses at nodes and of elements, from the step's own displacements.
void add_stress_fields(const model::Model& model, const model::Mesh& mesh,
                       results::LoadStepResult& step);

/// Face sets that outputs name become node sets of the results' mesh, once.
void add_face_sets_as_node_sets(const model::Model& model, model::Mesh& mesh);

/// The outer faces of a solid mesh by their nodes; none in the plane.
std::vector<results::OuterSurfaceFace> outer_faces_by_nodes(const model::Mesh& mesh);

/// Moves the mesh of a scene that is solved into its results, with its surface, and with results at
/// the places of nodes that patches have cut out.
void add_shown_results(const model::Model& model, Discretisation& scene,
                       results::CrackLengthResult& increment);

} // namespace spricka::analysis
