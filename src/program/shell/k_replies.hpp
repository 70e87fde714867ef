// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/shell/session.hpp"
#include "results/load_path.hpp"

#include <string>
#include <vector>

/// What the shell says of K.
namespace spricka::program {

/// Of a tip K, error bars, energy release rate and T. In space K and error bars: without a name at
/// the points of each front with the largest and the smallest K1, with one at all points of its
/// fronts. Of one crack, tip or front where `only` is not empty.
std::string k_reply(const ShellSession& session, const std::string& only);
/// What a reader of these K must not miss, one line each.
std::string k_notes(const ShellSession& session, const std::string& only);
/// A line for each front: size and K of a tip, in space the range of K1.
std::string k_state(const ShellSession& session);
/// What puts K of a front in doubt.
std::string k_concerns(const ShellSession& session);
/// K at the breakpoints of the path that was followed last.
std::string map_reply(const ShellSession& session);

/// A point of a front whose K is shown along a map.
struct MappedFrontPoint {
  std::string name; ///< of a tip, or of a front and number of the point
  const results::LoadPathFrontPoint* point = nullptr;
  bool is_tip = false;
};
/// The tips; in space of each front the points inside with the largest and the smallest K1 at the
/// end of the path.
std::vector<MappedFrontPoint> mapped_points(const results::LoadPathResult& path);

} // namespace spricka::program
