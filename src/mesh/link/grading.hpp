// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

namespace spricka::mesh {

/// Element size in the plane (dim 2) or in space (dim 3): each source asks for its size where it
/// stands, or up to a radius round it, and lets it grow with the distance beyond; the smallest
/// wins.
template <int dim> class SizeGrading {
public:
  using Point = Eigen::Matrix<double, dim, 1>;

  /// Growth of the size with distance. From 0.5 to 0.3 the errors of stress intensity factors halve
  /// for a twentieth more freedoms; below, the rosette and the host have the larger part.
  static constexpr double usual_growth = 0.3;

  struct SizeSource {
    Point at = Point::Zero();
    double size = 1.0;
    double growth = usual_growth; ///< of the size for each unit of distance
    double radius = 0.0;          ///< without growth up to there
  };

  explicit SizeGrading(double growth = usual_growth) : growth_(growth) {}
  /// Asks for an element size at a place [length]; it grows as was said at first.
  void add_size_source(const Point& at, double size) { sources_.push_back({at, size, growth_}); }
  /// Asks for an element size round a place.
  void add_size_source(const SizeSource& source) { sources_.push_back(source); }
  /// The size at a place [length]; endless without sources.
  [[nodiscard]] double operator()(const Point& p) const {
    double least = std::numeric_limits<double>::max();
    for (const SizeSource& source : sources_) {
      const double beyond = std::max(0.0, (p - source.at).norm() - source.radius);
      least = std::min(least, source.size + source.growth * beyond);
    }
    return least;
  }
  [[nodiscard]] const std::vector<SizeSource>& sources() const { return sources_; }

private:
  double growth_; ///< of sources that say nothing of it
  std::vector<SizeSource> sources_;
};
using Grading = SizeGrading<2>;
using SolidGrading = SizeGrading<3>;

/// Divides a stretch into elements by N, the number of elements that it takes up to each of the
/// values s [value], both ascending, from N = 0: as many as it takes in all, rounded, and each the
/// same part of it. Returns the values of s at their ends, the first and the last included.
std::vector<double> divide_by_cumulative_count(const std::vector<double>& s,
                                               const std::vector<double>& N);

/// Divides a line, from length s0 to s1, into elements of the size that is wanted at each s: the
/// lengths of their ends, s0 and s1 included.
std::vector<double> divide_line_by_size(double s0, double s1,
                                        const std::function<double(double)>& size);

/// Divides a curve x(t), from t0 to t1, into elements of the wanted sizes. Returns the values of t
/// at their ends, both ends of the curve included.
std::vector<double> divide_curve_by_size(const std::function<base::Vec2(double)>& x, double t0,
                                         double t1, const Grading& size);

} // namespace spricka::mesh
