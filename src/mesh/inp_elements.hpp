// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "model/materials.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace spricka::mesh {

/// An element name of Abaqus and CalculiX in our terms. Node order and numbers of sides (S1 is side
/// 0) are the same for all of them.
struct InpElementType {
  base::ElementType type = base::ElementType::trim3;
  model::StressState state = model::StressState::solid;
  bool special = false; ///< reduced integration, incompatible modes, hybrid or modified form
};

/// Empty for names the element library has nothing for.
std::optional<InpElementType> find_inp_element_type(std::string_view name);

/// CPS8, CPE8, CAX8 or C3D20 for a type; empty for those that have no name there (9 and 27 nodes).
std::string inp_element_name(base::ElementType type, model::StressState state);

} // namespace spricka::mesh
