// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/refine/wide_bars.hpp"
#include "base/vec.hpp"
#include "mesh/size_map.hpp"
#include "model/mesh.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace spricka::analysis {

using SizeRequestsByNet = std::map<std::string, std::vector<mesh::SizeMap::SizeRequest>>; // by net

/// A place on contact surfaces that needs smaller elements.
struct RefinementPoint {
  base::Vec2 at;
  double factor = 1.0;   ///< of the largest element there
  base::CrackId crack;   ///< an edge of one surface whose pressure this crack feels; else invalid
  double patch = 0.0;    ///< size of a patch's element that has that edge
  bool on_faces = false; ///< the place lies on that crack's own faces: its patch alone follows
};

/// What a K feels of the pressures' discretisation takes at most this part of its tolerance.
inline constexpr double most_of_bar = 0.3;
/// Of an element's size in one round: the estimate of what it takes is a guess.
inline constexpr double least_factor = 0.3;
/// Of the error that patch and host may keep at least.
inline constexpr double least_share = 0.2;

/// Adds the places that make this bar wide: where contact ends between two points that lie farther
/// apart than K bears, and edges that it is closed up to.
void add_points_that_widen_bar(const model::Model& model, const ExcessiveErrorBar& wide,
                               std::vector<RefinementPoint>& places);

/// The crack whose faces a contact of the results is; invalid: another contact.
base::CrackId crack_of_face_contact(const model::Model& model, const std::string& contact);

/// Elements of the present mesh where they are and as large as they are, by net.
struct PresentElementSizes {
  SizeRequestsByNet kept; ///< of the host
  SizeRequestsByNet cut;  ///< what patches stand in for
};

/// What follows the places.
struct RefinedSizeRequests {
  SizeRequestsByNet nets;
  std::vector<double> patch; ///< [crack] its patch is to be finer by this
};

/// Nets whose nearest element is no further from a place than it is large follow it.
RefinedSizeRequests request_sizes_near_points(const std::vector<RefinementPoint>& places,
                                              const PresentElementSizes& elements,
                                              std::size_t cracks);

} // namespace spricka::analysis
