// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// Contact between the faces of cracks in space (crack_face_contact.hpp).
namespace spricka::analysis {

/// The faces of a crack line as a pair, with what supports make of its rows.
contact::PairConstraints solid_face_pair(const model::Model& model, const Discretisation& scene,
                                         std::size_t line, bool friction);

/// By how much the faces of a crack lie in one another in u [3 * node], as rows between them weigh
/// it, over the largest displacement of one against the other.
double measure_relative_solid_overlap(const model::Model& model, const Discretisation& scene,
                                      std::size_t line, const base::Vector& u);

/// What the faces of a crack do at a point of its front.
struct FrontFaceContact {
  bool closed = false;   ///< they touch behind it
  bool held = false;     ///< closed, and they have not slipped
  double pressure = 0.0; ///< between them there [stress]
};

/// [point of the front] the row of its pair that holds the faces together behind it, if there is
/// one; empty: the faces are no pair.
std::vector<std::optional<std::size_t>>
find_solid_face_row_by_front_point(const Discretisation& scene, const mesh::CrackFront& front);

/// [point of the front]; empty: the faces are no pair.
std::vector<FrontFaceContact> front_face_contact(const Discretisation& scene,
                                                 const mesh::CrackFront& front,
                                                 const StepState& state);

} // namespace spricka::analysis
