// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <functional>
#include <vector>

namespace spricka::mesh {

/// Element size in the plane: each source asks for its size where it stands, and lets it grow with
/// the distance; the smallest wins.
class Grading {
public:
  /// Growth of the size with distance. From 0.5 to 0.3 the errors of stress intensity factors halve
  /// for a twentieth more freedoms; below, the rosette and the host have the larger part.
  static constexpr double usual_growth = 0.3;

  explicit Grading(double growth = usual_growth) : growth_(growth) {}

  /// Asks for an element size at a place [length].
  void add_source(const base::Vec2& at, double size) { sources_.push_back({at, size}); }
  [[nodiscard]] double operator()(const base::Vec2& p) const;

  struct SizeSource {
    base::Vec2 at;
    double size;
  };
  [[nodiscard]] const std::vector<SizeSource>& sources() const { return sources_; }
  [[nodiscard]] double growth() const { return growth_; }

private:
  double growth_; ///< of the size for each unit of distance
  std::vector<SizeSource> sources_;
};

/// Divides a curve x(t), from t0 to t1, into elements of the wanted sizes. Returns the values of t
/// at their ends, both ends of the curve included.
std::vector<double> divide(const std::function<base::Vec2(double)>& x, double t0, double t1,
                           const Grading& size);

} // namespace spricka::mesh
