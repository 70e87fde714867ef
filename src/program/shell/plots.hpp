// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/shell/session.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// Kinds of pictures: k, pressure, mesh, path.
std::vector<std::string> picture_kinds();

/// One SVG of a kind: K1 over the lengths tried at the present loads and fits, the pressures, the
/// mesh with its cracks, or K1 along the path that was mapped last, over t from 0 to 1. The session
/// has nothing pending.
base::OptionalFailure draw_picture(const ShellSession& session, const std::string& kind,
                                   std::string& svg);

} // namespace spricka::program
