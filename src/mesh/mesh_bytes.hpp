// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/mesh.hpp"

#include <string>
#include <string_view>

namespace spricka::mesh {

/// Sizes of a mesh, to tell what was added since.
struct MeshEnd {
  std::size_t nodes, elements, node_sets, element_sets, face_sets;

  explicit MeshEnd(const model::Mesh& mesh)
      : nodes(mesh.node_count()), elements(mesh.element_count()), node_sets(mesh.node_sets.size()),
        element_sets(mesh.element_sets.size()), face_sets(mesh.face_sets.size()) {}
};

/// What was added to a mesh behind `end`, and messages, as bytes for the same program.
std::string to_bytes(const model::Mesh& mesh, const MeshEnd& end,
                     const base::Diagnostics& diagnostics);

/// Adds what the bytes hold; false, with nothing added, if they do not fit the mesh. Sets get
/// `span`, as messages do.
bool from_bytes(std::string_view bytes, base::Span span, model::Mesh& mesh,
                base::Diagnostics& diagnostics);

} // namespace spricka::mesh
