// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cavity.hpp"

namespace spricka::mesh {

/// Whether the crack stays inside its cavity, in one material; errors at `span`.
bool check_crack_inside_cavity(const HostMesh& host, const CrackPlacement& placement,
                               const Cavity& cavity, base::SourceSpan span,
                               base::Diagnostics& diagnostics);

} // namespace spricka::mesh
