// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "mesh/tube/solid_host.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

struct LocatedSolidCrack;

/// A face of the body at which a crack opens. Lengths are those of the deck.
struct BodyFaceAtCrackMouth {
  std::string name;                       ///< of the smallest set that has it; empty: none has it
  base::Vec3 at = base::Vec3::Zero();     ///< a place of the mouth on it
  base::Vec3 normal = base::Vec3::Zero(); ///< unit, out of the body there
  double length = 0.0;                    ///< of the mouth along it
  std::vector<model::Face> faces;         ///< element sides that the mouth passes
  /// Of an ellipse: how far its centre lies off the face (or off the face's continuation), in the
  /// crack's plane, as a part of the ellipse's radius that way; with its sign.
  double offset = 0.0;
};

/// What the body has of a crack before it is cut.
struct CrackExtentInBody {
  CrackConfiguration kind = CrackConfiguration::embedded;
  base::ElementId seed{}; ///< one of the body's elements that its front passes
  double area = 0.0;      ///< of one of its faces
  double drawn = 1.0;     ///< area as a part of that of the drawn ellipse, or closed front; else 1
  /// Of a surface crack the largest distance of its front from its mouth; of an embedded one the
  /// least distance from the surface.
  double depth = 0.0;
  std::string nearest; ///< of an embedded one: the name of the face there
  std::vector<BodyFaceAtCrackMouth> open;
  /// Area of the crack as a part of the section of the body that its front divides; not a number
  /// where no one front does.
  double of_section = std::numeric_limits<double>::quiet_NaN();
  /// Of a surface crack: from both ends of its mouth on over the surface to an edge of the body.
  std::array<double, 2> to_edge{std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::infinity()};
  std::array<base::Vec3, 2> edge{base::Vec3::Zero(), base::Vec3::Zero()}; ///< the places there
};

/// By the edges of the body that its mouths pass: of a crack that is placed.
CrackConfiguration classify_crack(const LocatedSolidCrack& placed);

/// Finds it; empty where the crack cannot be placed (which a cut reports). The crack has not turned
/// out of its plane.
std::optional<CrackExtentInBody> measure_crack_in_body(const SolidHostMesh& host,
                                                       const SolidCrack& crack);

} // namespace spricka::mesh
