// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/cut/mouth.hpp"
#include "mesh/plane.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace spricka::mesh {

/// A tip in the crack's frame.
struct PlacedTip {
  base::Vec2 at = base::Vec2::Zero();
  double direction = 0.0; ///< of growth, angle from the frame's x

  [[nodiscard]] base::Vec2 growth_direction() const {
    return {std::cos(direction), std::sin(direction)};
  }
};

/// A crack put into its host, in its own frame: mouth at (0, 0), length 1; an embedded one has its
/// first tip there and length 2.
struct CrackPlacement {
  CrackFrame frame;
  std::vector<base::Vec2> line;       ///< the crack, mouth first
  std::optional<MouthPosition> mouth; ///< none: embedded
  base::ElementId seed;               ///< host element that it starts in
  std::vector<PlacedTip> fronts;      ///< each a tip, in the order of the line
  double radius = 0.0;                ///< of the rosettes
  double size = 0.0;                  ///< of the tip elements
  /// Symmetric half: +1 if the body lies on the left of the line, -1 on the right; else 0.
  int half = 0;
};

/// What rings that grow by `factor` from one to the next reach, in thicknesses of the first.
double geometric_ring_sum(int rings, double factor);

/// Puts a crack with a patch into its host. Empty, with an error at `span`, if it does not start
/// where it should or a rosette does not fit.
std::optional<CrackPlacement> place_crack_in_host(const HostMesh& host, const CrackLine& line,
                                                  const TipMeshParameters& tip,
                                                  base::SourceSpan span,
                                                  base::Diagnostics& diagnostics);

/// The same crack in another frame; unchanged in its own.
CrackPlacement placement_in_frame(const CrackPlacement& placement, const CrackFrame& frame);

/// Distance from the last point of a line to the net's boundary, but for the line itself of a
/// symmetric half, and to borders of other properties [a].
double tip_boundary_distance(const HostMesh& host, const CrackFrame& frame,
                             const std::vector<base::Vec2>& line, bool half, base::NetId net);

/// Frame of a crack in the plane, from its first point on; `a` is half the length of an embedded
/// one.
CrackFrame make_crack_frame(const CrackLine& line);

} // namespace spricka::mesh
