// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/line_division.hpp"
#include "mesh/surface/surface_trace.hpp"

namespace spricka::mesh {

namespace {

/// No corner at a bend nearer to another one than this part of the size of elements.
constexpr double least_of_size = 0.3;

} // namespace

std::vector<double> SurfaceTrace::kink_positions(double angle) const {
  constexpr int looks = 8; // between two points
  std::vector<double> all;
  if (!plane_.relief) {
    return all;
  }
  const NonPlanarCrackSurface& crack = *plane_.relief;
  const auto strip = [&](double s) { return crack.strip_number(at(s).x); };
  double before = 0.0;
  std::size_t last = strip(before);
  for (std::size_t i = 1; i < arc_.size(); ++i) {
    for (int k = 1; k <= looks; ++k) {
      const double here = arc_[i - 1] + (arc_[i] - arc_[i - 1]) * k / looks;
      const std::size_t now = strip(here);
      double low = before;
      double high = here;
      for (int step = 0; step < 40 && now != last; ++step) {
        const double middle = 0.5 * (low + high);
        (strip(middle) == last ? low : high) = middle;
      }
      if (now != last &&
          crack.distance_to_kink(at(high).x, angle) < crack.narrowest_strip_width() / looks) {
        all.push_back(high);
      }
      before = here;
      last = now;
    }
  }
  return all;
}

DividedTrace divide(const SurfaceTrace& trace, const SizeFunction& size) {
  const auto size_of = [&](double at) { return size(trace.at(at).x); };
  DividedTrace line;
  double begin = 0.0;
  line.corners.push_back(trace.points().front());
  const auto go_to = [&](double end, const TracePoint& there) {
    const std::vector<double> s = divide_line_by_size(begin, end, size_of);
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
      line.mids.push_back(trace.at(0.5 * (s[i] + s[i + 1])));
      line.corners.push_back(i + 2 < s.size() ? TracePoint{trace.at(s[i + 1]), nowhere, 0.0}
                                              : there);
    }
    begin = end;
  };
  const std::vector<double> bends = trace.kink_positions(bent);
  std::size_t bend = 0;
  for (std::size_t i = 1; i < trace.points().size(); ++i) {
    if (trace.points()[i].edge == nowhere && i + 1 < trace.points().size()) {
      continue;
    }
    const double end = trace.arc_lengths()[i];
    for (; bend < bends.size() && bends[bend] < end; ++bend) {
      const double near = least_of_size * size_of(bends[bend]);
      if (bends[bend] > begin + near && bends[bend] < end - near) {
        go_to(bends[bend], {trace.at(bends[bend]), nowhere, 0.0});
      }
    }
    go_to(end, trace.points()[i]);
  }
  return line;
}

} // namespace spricka::mesh
