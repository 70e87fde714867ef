// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/inp_joint.hpp"
#include "model/forward.hpp"
#include "program/peers/inp_nets.hpp"

#include <set>
#include <string>
#include <vector>

namespace spricka::program {

/// Supports, loads and steps of an Abaqus or CalculiX file as cards of a deck.
struct InpStepCards {
  std::vector<std::string> node_sets; ///< [net] $NSET of its nodes that the file names one by one
  std::string supports;               ///< $FREEDOM
  std::string loads_and_steps;        ///< $LOAD, $STEP
  std::vector<std::string> remarks;
  std::set<std::string> held_nets; ///< with a support
};

/// Every static step becomes a $STEP with a load case of all that acts in it.
InpStepCards write_inp_step_cards(const model::Model& model, const mesh::InpJointCards& joint,
                                  const InpNets& nets);

} // namespace spricka::program
