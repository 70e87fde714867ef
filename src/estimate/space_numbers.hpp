// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/dependence.hpp"
#include "model/freedoms.hpp"
#include "model/mesh.hpp"

#include <cstdint>
#include <vector>

namespace spricka::estimate {

/// Numbers of the modes of a mesh of solids: those of an edge or a face are shared.
struct SolidModeNumbers {
  std::vector<std::size_t> first; ///< [element + 1] into mode and sign
  std::vector<std::int32_t> mode; ///< of all elements, in the order of SolidModes
  std::vector<double> sign;
  base::Vector free; ///< [3 * mode] 0 where held, else 1
};

/// Held are directions that supports hold at all nodes of an edge or face, edges and faces with a
/// node that follows others, and such whose nodes are all followed; but the edges of a
/// quadrilateral whose diagonal alone is tied (the tube of a crack) are free: both sides share
/// them. (Where more nodes inside a face are tied, as at a host of hexahedra, a mode of an edge
/// that differs inside the face on both sides would let a linear stress do work on it: an error
/// where there is none.)
SolidModeNumbers number_solid_modes(const model::Mesh& mesh,
                                    const std::vector<model::FreedomRole>& cls,
                                    const fe::ConstraintTransformation& ties);

} // namespace spricka::estimate
