// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/front_curve.hpp"
#include "mesh/surface/surface_trace.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "mesh/tube/solid_host.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

std::string coordinate_text(const base::Vec3& x);

/// A part of a crack's front that lies in the body, from surface to surface, or all of a closed
/// one.
struct InteriorFront {
  std::shared_ptr<const FrontCurve> curve; ///< its length from 0
  std::array<SurfacePlace, 2> end;         ///< of an open one: where the surface is
  /// The mouth that begins at its last end: points on the surface, from that end to the first end
  /// of the front `next`.
  std::vector<base::Vec3> mouth = {};
  std::size_t edges = 0; ///< of the body that the mouth passes, borders of sets not counted
  std::size_t next = 0;
};

/// A hole of the body within a crack: a mouth that runs all round.
struct BodyHoleInCrack {
  SurfacePlace from; ///< on the crack's plane
  base::Vec3 towards = base::Vec3::Zero();
  std::vector<base::Vec3> mouth; ///< closed, the first point not repeated
};

/// A crack before it is cut: where it lies in the host.
struct LocatedSolidCrack {
  const SolidCrack* crack = nullptr;
  const TubeMeshParameters* mesh = nullptr;
  base::SourceSpan span;
  base::ElementId seed{}; ///< the host's element that its front begins in
  std::vector<InteriorFront> fronts = {};
  std::vector<BodyHoleInCrack> holes = {};
  /// What fronts and mouths enclose, as closed polygons; those of holes lie within others.
  std::vector<std::vector<base::Vec3>> outlines = {};
  /// A place of what a closed front encloses elsewhere, beyond a hole or a slot: not of the crack.
  std::optional<base::Vec3> left_out = {};

  /// Calls f(from, to) for one piece after another of its mouths, those of holes all round.
  template <class F> void for_each_mouth_segment(F&& f) const {
    for (const InteriorFront& front : fronts) {
      for (std::size_t i = 1; i < front.mouth.size(); ++i) {
        f(front.mouth[i - 1], front.mouth[i]);
      }
    }
    for (const BodyHoleInCrack& hole : holes) {
      for (std::size_t i = 0; i < hole.mouth.size(); ++i) {
        f(hole.mouth[i], hole.mouth[(i + 1) % hole.mouth.size()]);
      }
    }
  }
};

CrackReferencePlane crack_reference_plane(const SolidCrack& crack);

/// Finds where a crack lies; false, with an error, where that is not in one part of the host.
bool locate_crack_in_host(const SolidHostMesh& host, LocatedSolidCrack& request,
                          base::Diagnostics& diagnostics);

} // namespace spricka::mesh
