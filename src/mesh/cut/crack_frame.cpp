// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_frame.hpp"

#include "mesh/plane.hpp"

namespace spricka::mesh {

base::Vec3 CrackFrame::rounded_local_coordinates(const base::Vec3& x) const {
  return rounded(exact_local_coordinates(x));
}

} // namespace spricka::mesh
