// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/dof_map.hpp"
#include "model/mesh.hpp"
#include "solve/unknown_places.hpp"

namespace spricka::analysis {

/// Where the unknowns of a net are in the mesh.
solve::UnknownPlaces locate_unknowns(const model::Mesh& mesh, const fe::DofMap& map);

} // namespace spricka::analysis
