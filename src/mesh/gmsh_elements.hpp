// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"

#include <array>
#include <optional>
#include <span>

namespace spricka::mesh {

/// An element type of gmsh's file formats in our terms; `order[i]` is gmsh's place of our node i,
/// empty where both agree.
struct GmshElementType {
  int number;
  base::ElementType type;
  std::span<const int> order;
};

/// Empty for a type that the element library does not have. Source: gmsh 4.8 reference manual,
/// "Node ordering".
std::optional<GmshElementType> find_gmsh_element_type(int number);

/// Places of the nodes of a plane element turned over, so that it runs anticlockwise; empty for
/// solids.
std::span<const int> reversed_node_order(base::ElementType type);

} // namespace spricka::mesh
