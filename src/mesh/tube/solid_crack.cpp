// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_crack.hpp"

#include "mesh/surface/crack_relief.hpp"

#include <algorithm>

namespace spricka::mesh {

std::vector<base::Vec3> SolidCrack::normals_at(const std::vector<base::Vec3>& points) const {
  std::vector<base::Vec3> normals(points.size(), normal);
  if (relief) {
    std::ranges::transform(points, normals.begin(),
                           [&](const base::Vec3& x) { return relief->normal_at_front(x); });
  }
  return normals;
}

std::string SolidCrack::display_name() const {
  return "crack " + (name.empty() ? std::to_string(crack.index() + 1) : name);
}

} // namespace spricka::mesh
