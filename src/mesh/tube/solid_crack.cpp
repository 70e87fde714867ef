// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_crack.hpp"

namespace spricka::mesh {

std::string SolidCrack::title() const {
  return "crack " + (name.empty() ? std::to_string(crack.index() + 1) : name);
}

} // namespace spricka::mesh
