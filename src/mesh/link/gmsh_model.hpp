// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Elements of one type on one entity, as gmsh has them.
struct GmshElementBlock {
  int entity = 0;
  int type = 0;                   ///< gmsh's number
  std::string type_name;          ///< in gmsh's words; empty for types we know
  std::vector<std::size_t> tags;  ///< of elements
  std::vector<std::size_t> nodes; ///< their nodes' tags, one element after the other
};

/// A physical group of a model.
struct GmshPhysicalGroup {
  int dim = 0;
  int tag = 0;
  std::string name; ///< empty if it has none
  std::vector<int> entities;
  std::vector<std::size_t> nodes; ///< tags; of groups that are neither of elements nor of sides
  std::string set;                ///< qualified name of our set, given later
};

/// All that is wanted of a model that gmsh has read and meshed.
struct GmshModel {
  int dim = 0; ///< of the elements; 0: there are none
  std::vector<std::size_t> node_tags;
  std::vector<double> x; ///< three for each tag
  std::vector<GmshElementBlock> elements;
  std::vector<GmshElementBlock> sides; ///< elements one dimension lower, of groups
  std::vector<GmshPhysicalGroup> groups;
  std::vector<std::pair<std::string, double>> constants; ///< those that were asked for
  std::vector<std::string> errors;                       ///< gmsh's words
  std::vector<std::string> warnings;
  bool gave_up = false; ///< gmsh threw something
};

} // namespace spricka::mesh
