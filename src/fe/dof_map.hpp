// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "fe/dependence.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Which freedom of which node is which unknown. Whole-model vectors ("nodal vectors") have
/// dim * node_count entries, component c of node n at dim * n + c; a body's own system numbers only
/// its unknowns, locals first, externals last.
namespace spricka::fe {

/// Class of each freedom of the whole mesh [dim * node]. Suppressed wins over prescribed, that
/// over external. Nodes behind a crack tip on a symmetry line must already be out of the sets.
/// About an axis the nodes on it are suppressed along x.
std::vector<model::FreedomRole> classify_freedoms(const model::Model& model,
                                                  const model::Mesh& mesh);

/// What is connected by elements: a piece of the mesh, or a node that has none.
struct Body {
  base::NetId net;
  std::vector<base::ElementId> elements; ///< ascending
  std::vector<base::NodeId> nodes;       ///< ascending
};

/// Splits the mesh into bodies by shared nodes, in the order of their first element.
std::vector<Body> find_bodies(const model::Mesh& mesh);

/// Puts bodies together that ties join [joined body][piece], in the order of their first piece.
/// Nodes without elements that take part in ties are pieces of their own. Ties to freedoms that are
/// suppressed or prescribed join nothing.
std::vector<std::vector<Body>> join_tied_bodies(const model::Mesh& mesh, std::vector<Body> bodies,
                                                const ConstraintTransformation& ties,
                                                const std::vector<model::FreedomRole>& cls);

/// Numbering of one system of equations.
struct DofMap {
  std::vector<std::int32_t> row;     ///< [dim * node] row of the system, or -1
  std::vector<std::int32_t> freedom; ///< [row] back to dim * node + c
  std::int64_t locals = 0;           ///< rows before the first external
  /// Dependent freedoms, which have no row, act on those of their masters; null: there are none, or
  /// they are unknowns of this system like others.
  std::shared_ptr<const ConstraintTransformation> ties;

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(freedom.size()); }
  [[nodiscard]] std::int64_t external_count() const { return size() - locals; }
};

/// Numbers the free freedoms of some nodes: locals in node order, then externals in node order.
/// `cls` is by freedom of the whole mesh [dim * node].
DofMap number_freedoms(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes,
                       const std::vector<model::FreedomRole>& cls);

/// How many ways a body of this model can move rigidly: 3 in the plane, 6 in space, 1 about an
/// axis.
int rigid_mode_count(const model::Model& model);

/// Rigid modes of the pieces of a body, side by side: of each piece its translations and rotations,
/// orthonormal over its nodes and centred there [dim * node_count, modes], zero elsewhere. About an
/// axis there is only the translation along it, and a single node has no rotations.
base::Matrix rigid_modes(const model::Model& model, const model::Mesh& mesh,
                         std::span<const Body> pieces);

/// The part of the rigid modes that suppressed and prescribed freedoms and ties leave free: columns
/// [modes, free] that combine rigid_modes; empty when the body is held. A combination counts as
/// free when its largest held freedom is below 1e-9 of its largest freedom.
base::Matrix free_rigid_modes(const model::Mesh& mesh, const base::Matrix& modes,
                              std::span<const Body> pieces, const ConstraintTransformation& ties,
                              const std::vector<model::FreedomRole>& cls);

} // namespace spricka::fe
