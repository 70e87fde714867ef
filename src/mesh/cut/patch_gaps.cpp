// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_gaps.hpp"

#include "geometry/polyline.hpp"

#include <algorithm>
#include <limits>

namespace spricka::mesh {
namespace {

using base::Vec2;

/// Gaps narrower than this part of a crack's length are not followed further.
constexpr double least_gap = 1e-3;
/// A gap is beside a crack, not where it starts or bends, if it is narrower than this part of the
/// way along the crack or from the mouth.
constexpr double beside = 0.5;

class Gaps {
public:
  Gaps(const std::vector<const CrackPlacement*>& cracks,
       const std::vector<std::array<Vec2, 3>>& boundary)
      : cracks_(cracks), boundary_(boundary) {}

  /// At a point of segment k of a crack, `s` from its start.
  [[nodiscard]] double at(const CrackPlacement& crack, const Vec2& p, double s,
                          std::size_t k) const {
    double gap = std::numeric_limits<double>::max();
    for (const CrackPlacement* other : cracks_) {
      gap = std::min(gap, other == &crack ? to_itself(crack, p, s, k)
                                          : geometry::nearest_point(p, other->line).distance);
    }
    for (const auto& [a, mid, b] : boundary_) {
      const double d = std::min(geometry::distance_to_segment(p, a, mid),
                                geometry::distance_to_segment(p, mid, b));
      // Near its mouth a crack is near the boundary anyhow; an embedded one has no mouth.
      gap = !crack.mouth || d < beside * s ? std::min(gap, d) : gap;
    }
    return gap;
  }

private:
  static double to_itself(const CrackPlacement& crack, const Vec2& p, double s, std::size_t k) {
    double gap = std::numeric_limits<double>::max();
    double start = 0.0;
    for (std::size_t i = 1; i < crack.line.size(); ++i) {
      const double d = geometry::distance_to_segment(p, crack.line[i - 1], crack.line[i]);
      const double end = start + (crack.line[i] - crack.line[i - 1]).norm();
      // The way along the crack to the nearer end of segment i.
      const double along = i < k ? s - end : start - s;
      gap = i != k && d < beside * along ? std::min(gap, d) : gap;
      start = end;
    }
    return gap;
  }

  const std::vector<const CrackPlacement*>& cracks_;
  const std::vector<std::array<Vec2, 3>>& boundary_;
};

} // namespace

double crack_length_in_frame(const CrackPlacement& placement) {
  const double length = geometry::polyline_length(placement.line);
  return placement.mouth ? length : 0.5 * length;
}

void add_gap_sizes(const std::vector<const CrackPlacement*>& cracks,
                   const std::vector<std::array<Vec2, 3>>& boundary, Grading& size) {
  const Gaps gaps(cracks, boundary);
  for (const CrackPlacement* crack : cracks) {
    const double total = geometry::polyline_length(crack->line);
    double before = 0.0; // up to the segment
    for (std::size_t k = 1; k < crack->line.size(); ++k) {
      const Vec2& a = crack->line[k - 1];
      const Vec2 along = crack->line[k] - a;
      const double length = along.norm();
      for (double s = 0.0; s < length;) {
        const Vec2 p = a + s / length * along;
        const double gap = std::max(gaps.at(*crack, p, before + s, k), least_gap * total);
        if (gap < total) {
          size.add_size_source(p, gap);
        }
        // The next place to ask at is one gap on: in between the size has grown by a part of that
        // only (mesh.4).
        s += gap;
      }
      before += length;
    }
  }
}

} // namespace spricka::mesh
