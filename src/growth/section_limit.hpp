// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/dependence.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"
#include "model/freedoms.hpp"

#include <vector>

/// Force and moments over a section against its plastic limit: net section of bodies in space.
namespace spricka::growth {

/// A piece of a section: its middle in the section's plane and its area.
struct SectionPiece {
  base::Vec2 at = base::Vec2::Zero();
  double area = 0.0; ///< [length^2]
};

/// Normal force N and its moments q = integral of sigma r dA about the origin of the pieces.
struct SectionLoad {
  double N = 0.0;
  base::Vec2 q = base::Vec2::Zero(); ///< [force * length]
};

/// The load over what the section carries where all of it flows at +-s: the largest
/// (N e + q k) / (s D(e, k)), D = integral of |e + k r| dA (manual, growth.6a). By the pieces'
/// middles.
double plastic_load_ratio(const std::vector<SectionPiece>& section, const SectionLoad& on,
                          double flow_stress);

/// Bodies with a crack in them.
struct CrackedBodies {
  const model::Model& model;
  const mesh::CrackedMesh& cracked;
  const fe::ConstraintTransformation& ties;
  const std::vector<model::FreedomRole>& cls; ///< [3 * node]
};

/// The same of the section in a crack's plane, as far as it is left before a front and hangs
/// together, cut through the elements' corners, with its mirror image where supports are a plane of
/// symmetry. Forces are the internal ones of the elements below it at displacements u [3 * node].
/// 0: the front has nothing before it.
double plastic_load_ratio(const CrackedBodies& in, const mesh::CrackFront& front,
                          const base::Vector& u, double flow_stress);

} // namespace spricka::growth
