// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/path_functions.hpp"

#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double worst_mismatch = 1e-6;

} // namespace

std::vector<double> path_knots(const solve::SolutionPath& found) {
  std::vector<double> t;
  for (const solve::SolutionPathSegment& s : found.segments) {
    t.push_back(s.from);
  }
  t.push_back(found.end);
  return t;
}

base::PiecewiseLinear path_functional(const solve::SolutionPath& found, Eigen::Index k) {
  std::vector<double> value;
  std::vector<double> slope;
  for (const solve::SolutionPathSegment& s : found.segments) {
    value.push_back(s.value[k]);
    slope.push_back(s.slope[k]);
  }
  return {path_knots(found), std::move(value), std::move(slope)};
}

bool zero_K1_where_closed(const solve::SolutionPath& found, std::size_t row,
                          base::PiecewiseLinear& K1) {
  const auto place = static_cast<std::ptrdiff_t>(row);
  bool closed = found.closed[row];
  bool any = false;
  std::vector<double> value;
  std::vector<double> slope;
  auto change = found.changes.begin();
  for (std::size_t s = 0; s < found.segments.size(); ++s) {
    for (; change != found.changes.end() && change->segment == s; ++change) {
      // Changes of a segment happen at its beginning.
      closed = change->row == place ? change->closes : closed;
    }
    any = any || closed;
    value.push_back(closed ? 0.0 : K1.value_at_knot(s));
    slope.push_back(closed ? 0.0 : K1.slope(s));
  }
  K1 = base::PiecewiseLinear(K1.knots(), std::move(value), std::move(slope));
  return any;
}

void warn_of_K_mismatch(results::LoadPathResult& path) {
  if (!(path.mismatch <= worst_mismatch)) {
    path.notes.push_back(results::less_exact_note(
        fmt::format("K on the path differs from K of the steps at its "
                    "ends by {:.1e} of the largest: between them it is off by "
                    "about as much",
                    path.mismatch)));
  }
}

} // namespace spricka::analysis
