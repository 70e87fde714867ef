// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/import_request.hpp"
#include "mesh/import/inp_data.hpp"
#include "mesh/import/inp_elements_taken.hpp"
#include "mesh/import/inp_words.hpp"
#include "model/mesh.hpp"

#include <map>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Where the nodes and elements of a file that are taken will stand in the mesh.
struct InpSetPlaces {
  InpLabelFinder& nodes;
  InpLabelFinder& elements;              ///< those that are taken
  const std::vector<base::NodeId>& node; ///< [place]; none if no element has it
  std::size_t first_element = 0;
};

/// Appends the sets of a file to a mesh, names with the prefix of the request, and gives the place
/// of each element set by its name in upper case. Sets of what is not taken are left out; of bars
/// and facets on sides they are face sets. What is named and not there is an error, with SKIP=ALL a
/// word.
std::map<std::string, std::size_t> add_inp_sets(model::Mesh& mesh, const InpData& data,
                                                const InpElementsTaken& taken,
                                                const ImportRequest& request, InpSetPlaces places,
                                                InpMessages& words);

} // namespace spricka::mesh
