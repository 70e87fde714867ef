// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/fill.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::mesh {
namespace {

using base::Vec3;
using Triangle = std::array<int, 3>;

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Counts how often triangles are sides of the tetrahedra.
class Sides {
public:
  explicit Sides(const TetrahedronFill& filling) {
    for (const std::array<int, 4>& t : filling.cells) {
      for (std::size_t i = 0; i < 4; ++i) {
        all_.push_back(sorted({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}));
      }
    }
    std::sort(all_.begin(), all_.end());
  }
  [[nodiscard]] std::ptrdiff_t count(const Triangle& t) const {
    const auto [low, high] = std::equal_range(all_.begin(), all_.end(), sorted(t));
    return high - low;
  }

private:
  std::vector<Triangle> all_;
};

/// What is wrong with a filling; empty if nothing.
std::string fault_of(const SolidRegion& region, const TetrahedronFill& filling) {
  if (filling.cells.empty()) {
    return "no tetrahedra were made";
  }
  const Sides sides(filling);
  std::ptrdiff_t removed = 0;
  for (const auto& [surfaces, wanted] :
       {std::pair(&region.boundaries, 1), std::pair(&region.embedded, 2)}) {
    for (const std::vector<Triangle>& surface : *surfaces) {
      removed += std::ranges::count_if(
          surface, [&, wanted = wanted](const Triangle& t) { return sides.count(t) != wanted; });
    }
  }
  return removed == 0
             ? std::string()
             : fmt::format("{} given triangles are no sides of the tetrahedra made", removed);
}

void turn_positive(const SolidRegion& region, TetrahedronFill& filling) {
  const auto at = [&](int n) -> const Vec3& {
    const auto i = static_cast<std::size_t>(n);
    return i < region.points.size() ? region.points[i] : filling.added[i - region.points.size()];
  };
  for (std::array<int, 4>& t : filling.cells) {
    const Vec3& a = at(t[0]);
    if ((at(t[1]) - a).cross(at(t[2]) - a).dot(at(t[3]) - a) < 0.0) {
      std::swap(t[1], t[2]);
    }
  }
}

} // namespace

TetrahedronFill fill_tetrahedra(const SolidRegion& region, const SolidGrading& size) {
  TetrahedronFill filling = request_mesh_fill(region, size);
  if (filling.trouble.empty()) {
    filling.trouble = fault_of(region, filling);
    turn_positive(region, filling);
  }
  if (!filling.trouble.empty()) {
    filling.added.clear();
    filling.cells.clear();
  }
  return filling;
}

} // namespace spricka::mesh
