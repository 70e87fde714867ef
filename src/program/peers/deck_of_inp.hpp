// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/inp_joint.hpp"
#include "model/forward.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// A deck that imports an Abaqus or CalculiX file and says by cards what the file says of contact,
/// ties, friction, supports and loads.
struct DeckOfInp {
  std::string text;
  std::vector<std::string>
      remarks; ///< what the cards say otherwise than the file, and what it lacks
};

/// `model` holds the file as mesh::import_inp reads it with SKIP=ALL, without a prefix; `file` is
/// its path from the deck, `name` what the net is called that a file of one body is read into.
DeckOfInp deck_of_inp(const model::Model& model, const mesh::InpJointCards& joint,
                      const std::string& file, const std::string& name);

} // namespace spricka::program
