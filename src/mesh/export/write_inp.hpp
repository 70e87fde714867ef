// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// A static step as nodal values.
struct InpStep {
  struct PrescribedFreedom {
    base::NodeId node;
    int dof = 0; ///< 0 1 2
    double value = 0.0;
  };
  std::string name;
  std::vector<PrescribedFreedom> fixed;
  std::vector<base::Vec3> force;   ///< [node]; empty: none
  std::vector<double> temperature; ///< [node] above that of no strain; empty: none
};

/// Types of the model that Abaqus and CalculiX have no name for, as the deck calls them.
std::vector<std::string> types_without_inp_name(const model::Mesh& mesh);

/// The numbers that write_inp() gives to the nodes of a mesh. [node]
std::vector<base::Label> inp_node_numbers(const model::Mesh& mesh);

/// A model as the text of an Abaqus or CalculiX input file: nodes, elements, sets, faces as
/// *SURFACE, materials and sections, and, with a step, supports, nodal forces, nodal temperatures
/// and requests for displacements and stresses. Dots in names become underscores. Coordinates have
/// as many digits as it takes to read the same bits back, up to the 20 characters that CalculiX
/// reads. Nodes of no element are left out; deck numbers stay where they are unique. All types must
/// have a name there.
std::string write_inp(const model::Model& model, const InpStep* step);

} // namespace spricka::mesh
