// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/import_request.hpp"
#include "mesh/import/inp_data.hpp"
#include "mesh/import/inp_words.hpp"
#include "mesh/label_index.hpp"
#include "model/mesh.hpp"

#include <string>
#include <unordered_map>
#include <vector>

namespace spricka::mesh {

/// What becomes of the elements of a file: those that are taken stay in its data. Faces count
/// elements from 0 among them.
struct InpElementsTaken {
  /// Bars and facets that lie on sides, by their numbers.
  std::unordered_map<base::Label, model::Face> faces;
  /// Others that are not taken: no side has them, or they join points, or are of another set.
  std::unordered_map<base::Label, bool> left;    ///< whether it is a bar or facet
  std::vector<model::Face> free_sides;           ///< ascending; where a surface asks for them
  std::vector<InpData::InpElementKind> on_sides; ///< bars and facets, by type
  std::vector<InpData::InpElementKind> idle;     ///< bars and plane elements on no side
};

/// Sorts the elements: solids, or elements of the plane where there are none; what lies on sides of
/// them; the rest. With request.element_set elements of this set alone are taken. `place` [entry
/// of the connectivity] is a node's place in the file's list; it is shortened as the data are.
/// Shells and membranes beside the solids, and sets that are not there, are errors.
InpElementsTaken take_inp_elements(InpData& data, std::vector<std::size_t>& place,
                                   const LabelIndex& nodes, const ImportRequest& request,
                                   InpMessages& words);

} // namespace spricka::mesh
