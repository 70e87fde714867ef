// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "program/shell/session.hpp"

#include <string>
#include <vector>

/// What the shell says of cracks in space.
namespace spricka::program {

/// K: without a name the points of each front with the largest and the smallest K1, with one all
/// points of its fronts.
std::string front_reply(const ShellSession& session, const std::string& only);
/// Why K along these fronts is in doubt or has no bar, and where the faces touch.
std::string front_notes(const ShellSession& session, const std::string& only);
/// A line for each front: size and range of K1.
std::string fronts_state(const ShellSession& session);
/// What puts K of a front in doubt.
std::string front_k_concerns(const ShellSession& session);

/// A point of a front whose K1 is shown along a map.
struct MappedFrontPoint {
  std::string name; ///< front and number of the point
  const base::PiecewiseLinear* K1 = nullptr;
};
/// Of each front the points inside with the largest and the smallest K1 at the end of the path.
std::vector<MappedFrontPoint> mapped_points(const results::LoadPathResult& path);

} // namespace spricka::program
