// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/crack_bends.hpp"

#include "geometry/polyline.hpp"
#include "mesh/surface/line_division.hpp"
#include "mesh/surface/surface_trace.hpp"

namespace spricka::mesh {

namespace {

using base::Vec3;

/// No point of a line nearer to a tube or a mouth than this part of the size of elements there.
constexpr double least_of_size = 0.5;
/// A node of a mouth so near to where the line meets it is its end.
constexpr double at_mouth = 0.05;

class BendLines {
public:
  BendLines(const CrackDistanceField& reach, double finer, const std::vector<int>& rim,
            const PatchMeshBuilder& net)
      : reach_(reach), finer_(finer), rim_(rim), net_(net) {}

  std::vector<KinkLine> make() {
    for (const std::vector<Vec3>& line : reach_.plane().relief->kink_lines(bent)) {
      divide(line);
    }
    return std::move(lines_);
  }

private:
  [[nodiscard]] double size_of(const Vec3& x) const {
    return size_at_front_distance(reach_.distance(x), CrackDistanceField::usual_growth / finer_) /
           finer_;
  }
  /// Within the loops, and not beside one.
  [[nodiscard]] bool free(const Vec3& x) const {
    const base::Vec2 q = reach_.plane().project(x);
    const double away = least_of_size * size_of(x);
    const CrackDistanceField::CrackDistances d = reach_.distance(x);
    return reach_.polygons().contains(q) && reach_.polygons().distance_to_outlines(q) > away &&
           d.front > d.radius + away;
  }

  /// The parts of a line that are free.
  void divide(const std::vector<Vec3>& line) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
      if (i == line.size() || !free(line[i])) {
        if (i > begin) {
          add(line, begin, i);
        }
        begin = i + 1;
      }
    }
  }

  /// Points from one up to before another.
  void add(const std::vector<Vec3>& line, std::size_t begin, std::size_t end) {
    std::vector<Vec3> points(line.begin() + static_cast<std::ptrdiff_t>(begin),
                             line.begin() + static_cast<std::ptrdiff_t>(end));
    const bool closed = points.size() == line.size() && line.front() == line.back();
    const int from = closed ? -1 : mouth_node(line, begin, -1);
    const int to = closed ? -1 : mouth_node(line, end - 1, 1);
    if (from >= 0) {
      points.insert(points.begin(), net_.local_position(from));
    }
    if (to >= 0) {
      points.push_back(net_.local_position(to));
    }
    const std::vector<double> arc = geometry::arc_lengths(points);
    if (!(arc.back() > size_of(points.front()))) {
      return;
    }
    const auto at = [&](double s) {
      return geometry::position_at_length(arc, s).interpolate(points);
    };
    KinkLine made;
    for (const double s :
         divide_line_by_size(0.0, arc.back(), [&](double s) { return size_of(at(s)); })) {
      made.points.push_back({-1, at(s), size_of(at(s))});
    }
    made.points.front().node = from;
    made.points.back().node = to;
    made.closed = closed;
    if (closed) {
      made.points.pop_back();
    }
    lines_.push_back(std::move(made));
  }

  /// The node of a mouth where a line goes on from one of its points, backwards or forwards.
  [[nodiscard]] int mouth_node(const std::vector<Vec3>& line, std::size_t i, int step) const {
    const double size = size_of(line[i]);
    double way = 0.0;
    for (auto k = static_cast<std::ptrdiff_t>(i);; k += step) {
      const std::ptrdiff_t next = k + step;
      if (next < 0 || next >= static_cast<std::ptrdiff_t>(line.size()) || way > 2.0 * size) {
        return -1;
      }
      const Vec3& a = line[static_cast<std::size_t>(k)];
      const Vec3& b = line[static_cast<std::size_t>(next)];
      for (const int n : rim_) {
        const Vec3 x = net_.local_position(n);
        if (geometry::distance_to_segment(x, a, b) < at_mouth * size) {
          return n;
        }
      }
      way += (b - a).norm();
    }
  }

  const CrackDistanceField& reach_;
  double finer_;
  const std::vector<int>& rim_;
  const PatchMeshBuilder& net_;
  std::vector<KinkLine> lines_;
};

} // namespace

std::vector<KinkLine> build_kink_lines(const CrackDistanceField& reach, double finer,
                                       const std::vector<int>& rim, const PatchMeshBuilder& net) {
  if (!reach.plane().relief) {
    return {};
  }
  return BendLines(reach, finer, rim, net).make();
}

} // namespace spricka::mesh
