// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"

/// What supports, ties and loads mean where a crack opens in one of their nodes.
namespace spricka::analysis {

/// A support, a force or a tie that names a node which a crack has doubled must tell by a side of
/// its set which face it means: E437, and false.
bool check_nodes_split_by_crack(const model::Model& model, const Discretisation& scene,
                                base::Diagnostics& diagnostics);

/// On a symmetry line the nodes behind the tip become free to open; what supports that go on beside
/// the line hold (a clamped side that the crack starts from) stays held. Changes scene.cls.
void free_symmetry_nodes_behind_tip(const model::Model& model,
                                    const std::vector<mesh::CrackLine>& lines,
                                    Discretisation& scene);

/// A load on the face of a crack that its body does not have (the crack lies on a symmetry line):
/// E438, and false.
bool check_loaded_crack_faces_exist(const model::Model& model, const Discretisation& scene,
                                    base::Diagnostics& diagnostics);

} // namespace spricka::analysis
