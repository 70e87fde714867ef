// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "crack/front_loads.hpp"

#include <vector>

/// Contact between the faces of cracks. A crack is solved without it first; only where its faces
/// would overlap they become a pair of the scene, and all steps are solved anew.
namespace spricka::analysis {

/// Crack lines whose faces overlap in u [dim * node] though they may touch, and that have no pair
/// yet.
std::vector<std::size_t> find_cracks_with_face_overlap(const model::Model& model,
                                                       const Discretisation& scene,
                                                       const base::Vector& u);

/// Adds the faces of these lines to the pairs of the scene, with the name CRACK.FACES; their
/// freedoms become external.
void add_crack_face_pairs(const model::Model& model, const std::vector<std::size_t>& lines,
                          Discretisation& scene);

/// What the faces of a crack do at one of its tips.
struct TipFaceContact {
  bool in_contact = false; ///< the crack's faces are a pair; else nothing below is known
  bool closed = false;     ///< the two nodes next to the tip touch
  bool held = false;       ///< closed, and they have not slipped
  bool lone = false;       ///< somewhere inside a single node touches, its neighbours do not
  double pressure = 0.0;   ///< largest between the faces [stress]
  int open_nodes = 0;      ///< open pairs from the tip to the first closed one; all open: 0
};
/// State of the crack faces at a tip in the plane, from the closed pairs and pressures of the step.
TipFaceContact tip_face_contact(const Discretisation& scene, const mesh::CrackFront& front,
                                const StepState& state);

/// The row of the table of the two nodes next to a tip; none where the faces are no pair.
std::optional<std::size_t> contact_row_at_tip(const Discretisation& scene,
                                              const mesh::CrackFront& front);

/// [point of a front] the row of the table that holds the faces together behind it, in the plane
/// that of the two nodes next to the tip, if there is one; empty: the faces are no pair.
std::vector<std::optional<std::size_t>> find_face_row_by_front_point(const Discretisation& scene,
                                                                     const mesh::CrackFront& front);

/// Forces between the faces of the tip's crack; none without a pair.
std::optional<crack::ForcesBetweenCrackFaces> crack_face_forces(const Discretisation& scene,
                                                                const mesh::CrackFront& front,
                                                                const StepState& state);

} // namespace spricka::analysis
