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
struct SolidFront {
  std::shared_ptr<const FrontCurve> curve; ///< its length from 0
  std::array<SurfacePlace, 2> end;         ///< of an open one: where the surface is
  /// The mouth that begins at its last end: points on the surface, from that end to the first end
  /// of the front `next`.
  std::vector<base::Vec3> mouth = {};
  std::size_t edges = 0; ///< of the body that the mouth passes, borders of sets not counted
  std::size_t next = 0;
};

/// A hole of the body within a crack: a mouth that runs all round.
struct CrackHole {
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
  std::vector<SolidFront> fronts = {};
  std::vector<CrackHole> holes = {};
  /// What fronts and mouths enclose, as closed polygons; those of holes lie within others.
  std::vector<std::vector<base::Vec3>> outlines = {};
  /// A place of what a closed front encloses elsewhere, beyond a hole or a slot: not of the crack.
  std::optional<base::Vec3> left_out = {};
};

CrackReferencePlane reference_plane(const SolidCrack& crack);

/// Finds where a crack lies; false, with an error, where that is not in one part of the host.
bool locate_crack(const SolidHost& host, LocatedSolidCrack& request,
                  base::Diagnostics& diagnostics);

} // namespace spricka::mesh
