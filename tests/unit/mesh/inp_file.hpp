// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "imported_file.hpp"
#include "mesh/import/inp_import.hpp"

#include <algorithm>
#include <string>

namespace spricka::test {

class InpFile : public ImportedFile {
protected:
  InpFile() : ImportedFile("a.inp") {}

  [[nodiscard]] const model::NodeSet& nodes(const std::string& name) const {
    return *std::find_if(model_.mesh.node_sets.begin(), model_.mesh.node_sets.end(),
                         [&](const auto& s) { return s.name == name; });
  }
  [[nodiscard]] const model::ElementSet& elements(const std::string& name) const {
    return *std::find_if(model_.mesh.element_sets.begin(), model_.mesh.element_sets.end(),
                         [&](const auto& s) { return s.name == name; });
  }

private:
  mesh::ImportedMaterialsAndEquations read(const mesh::ImportRequest& request) override {
    return mesh::import_inp(model_.mesh, request, diagnostics_);
  }
};

/// Elements 10 (LEFT HALF) and 20 (RIGHT) side by side on x 0 .. 2, y 0 .. 1; eighteen lines.
inline const std::string two_quads = R"(*Heading
 a title, with commas
** a comment
*NODE, nset=all
 1, 0., 0.
 2, 1.0D0, 0.
3,2,0,0
 4, +0., 1.
 5, 1., 1.
 6, 2., 1.
 99, 50., 50.
*Element, type = CPS4R ,
  elset=Left half
 10, 1,2,
 5,4
*ELEMENT,TYPE=CPS4,ELSET=RIGHT
 20, 2,3,6,5,
)";

} // namespace spricka::test
