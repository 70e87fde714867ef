// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "model/mesh.hpp"
#include "model/model.hpp"

#include <cstdint>
#include <vector>

/// Which freedom of which node is which unknown. Whole-model vectors ("nodal vectors") have
/// dim * node_count entries, component c of node n at dim * n + c; a body's own system numbers only
/// its unknowns, locals first, externals last.
namespace spricka::fe {

/// Class of each freedom of the whole mesh [dim * node]. Suppressed wins over prescribed, that
/// over external. Nodes behind a crack tip on a symmetry line must already be out of the sets.
std::vector<model::FreedomClass> classify_freedoms(const model::Model& model,
                                                   const model::Mesh& mesh);

/// A connected piece of the mesh.
struct Body {
  base::NetId net;
  std::vector<base::ElementId> elements; ///< ascending
  std::vector<base::NodeId> nodes;       ///< ascending
};

/// Splits the mesh into bodies by shared nodes, in the order of their first element.
std::vector<Body> find_bodies(const model::Mesh& mesh);

/// Numbering of one system of equations.
struct DofMap {
  std::vector<std::int32_t> row;     ///< [dim * node] row of the system, or -1
  std::vector<std::int32_t> freedom; ///< [row] back to dim * node + c
  std::int64_t locals = 0;           ///< rows before the first external

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(freedom.size()); }
  [[nodiscard]] std::int64_t externals() const { return size() - locals; }
};

/// Numbers the free freedoms of some nodes: locals in node order, then externals in node order.
/// `cls` is by freedom of the whole mesh [dim * node].
DofMap number_freedoms(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes,
                       const std::vector<model::FreedomClass>& cls);

/// Rigid modes of some nodes, orthonormal over the nodes given and centred there:
/// translations, then rotations; [dim * node_count, 3 in 2D or 6 in 3D], zero elsewhere.
base::Matrix rigid_modes(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes);

/// The part of the rigid modes that suppressed and prescribed freedoms leave free: columns
/// [modes, free] that combine rigid_modes; empty when the body is held. A combination counts as
/// free when its largest held freedom is below 1e-9 of its largest freedom.
base::Matrix free_modes(const model::Mesh& mesh, const base::Matrix& modes,
                        const std::vector<base::NodeId>& nodes,
                        const std::vector<model::FreedomClass>& cls);

} // namespace spricka::fe
