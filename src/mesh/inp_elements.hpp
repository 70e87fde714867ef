// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "model/materials.hpp"

#include <cstddef>
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

/// An element that may stand for a side of another: a bar on an edge, a shell, membrane or rigid
/// facet on a face. Its first nodes are the corners.
struct InpSurfaceElementType {
  std::size_t corners = 0; ///< 2 of a bar
  std::size_t nodes = 0;
};

/// Empty for names the element library has nothing for.
std::optional<InpElementType> find_inp_element_type(std::string_view name);

/// Bars T2D2 to T3D3; triangles and quadrilaterals S, STRI, M3D, SFM3D and R3D. Empty for others.
std::optional<InpSurfaceElementType> find_inp_surface_element_type(std::string_view name);

/// Whether such an element joins points and has no body: springs, dashpots, masses, gaps,
/// connectors, couplings.
bool is_inp_connector(std::string_view name);

/// CPS8, CPE8, CAX8 or C3D20 for a type; empty for those that have no name there (9 and 27 nodes).
std::string inp_element_name(base::ElementType type, model::StressState state);

} // namespace spricka::mesh
