// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/bytes.hpp"
#include "mesh/link/solid_region.hpp"

#include <string>

namespace spricka::mesh {

/// Fills a region with tetrahedra by gmsh; with `trouble` there are none. Every triangle of a shell
/// is the side of one of them, every embedded one that of two.
TetrahedronFill fill_tetrahedra(const SolidRegion& region, const SolidGrading& size);

// How the mesher is asked, and answers (mesher_request.hpp).
/// The request that asks the mesher process for tetrahedra, as bytes.
std::string fill_solid_request(const SolidRegion& region, const SolidGrading& size);
/// False if the bytes are none.
bool read_fill_solid_request(ByteReader& in, SolidRegion& region, SolidGrading& size);
/// The answer of the mesher process to such a request, as bytes.
std::string fill_solid_answer(const TetrahedronFill& filling);
/// Reads the answer to a request for `region`. False if the bytes are none, name points that are
/// not there, or give places that are not finite.
bool read_fill_solid_answer(ByteReader& in, const SolidRegion& region, TetrahedronFill& filling);

} // namespace spricka::mesh
