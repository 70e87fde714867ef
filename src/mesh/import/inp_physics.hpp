// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/import_request.hpp"
#include "mesh/import/imported_physics.hpp"
#include "mesh/import/inp_data.hpp"
#include "mesh/import/inp_elements_taken.hpp"
#include "mesh/import/inp_words.hpp"
#include "mesh/label_index.hpp"

#include <map>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Where the names and numbers of a file stand in the mesh to be.
struct InpMeshNumbering {
  const LabelIndex& nodes;                               ///< place of a node label in the file
  const std::vector<base::NodeId>& node;                 ///< [place]; none if no element has it
  const std::map<std::string, std::size_t>& set_of_name; ///< element sets, names in upper case
  const InpElementsTaken& taken;
  std::size_t first_element = 0;
  int dim = 2;
};

/// Materials, properties and equations of a file whose sets are in the mesh already. What is wrong
/// goes to `words`; with SKIP=ALL materials without isotropic elasticity are left out with their
/// sections, and so are equations of nodes that are not there.
ImportedMaterialsAndEquations read_inp_materials_and_equations(const InpData& data,
                                                               const ImportRequest& request,
                                                               const model::Mesh& mesh,
                                                               const InpMeshNumbering& places,
                                                               InpMessages& words);

} // namespace spricka::mesh
