// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/label_index.hpp"
#include "mesh/link/gmsh_model.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Where gmsh's nodes and elements are in our mesh.
struct GmshNumbering {
  int dim = 0;                    ///< of the elements
  std::optional<LabelIndex> tags; ///< of gmsh's nodes
  std::vector<base::NodeId> node; ///< [gmsh's node]; none if no element has it
  std::size_t first_element = 0;  ///< of ours
  std::vector<int> entity;        ///< [our element - first_element]
  /// An element may stand in a file once for each group it belongs to, as gmsh writes format 2.2:
  /// further entities of elements that were met before.
  std::vector<std::pair<base::ElementId, int>> also;

  /// Our node of a gmsh node; invalid where the file or no element has it.
  [[nodiscard]] base::NodeId node_with_tag(std::size_t tag) const {
    const auto at = tags->find(tag);
    return at ? node[*at] : base::NodeId();
  }
};

/// Gives the physical groups the names of their sets; false after an error.
bool name_gmsh_sets(const ImportRequest& request, base::Diagnostics& diagnostics,
                    std::vector<GmshPhysicalGroup>& groups);

/// Sets of the groups: of elements, of faces one dimension lower, else of nodes.
void add_gmsh_sets(model::Mesh& mesh, const ImportRequest& request, const GmshModel& from,
                   const GmshNumbering& numbers, base::Diagnostics& diagnostics);

} // namespace spricka::mesh
