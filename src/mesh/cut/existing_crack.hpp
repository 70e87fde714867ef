// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/boundary.hpp"
#include "mesh/cut/cracked.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// A crack that the deck's own mesh has already: the nodes of its faces are there twice, at the
/// same places, those of its front, in the plane its tip, once.
namespace spricka::mesh {

/// A side of the body with its corners by the places they lie at.
struct PlacedSide : FaceNodes {
  model::Face face;
  std::vector<std::size_t> places;        ///< [node of all]
  base::Vec3 normal = base::Vec3::Zero(); ///< outer, of the size of the side
};

/// Sides that lie on one another and hang together with the front of a crack.
struct ExistingCrackSides {
  std::vector<PlacedSide> sides; ///< all that no two elements share
  std::vector<std::size_t> twin; ///< [side] the one it lies on, or their number
  std::vector<std::size_t>
      upper;             ///< of the crack, ascending; the normal of an upper one points down
  double shortest = 0.0; ///< edge at the front

  /// The node of the other face at the place of a node of side s; invalid if none is there.
  [[nodiscard]] base::NodeId opposite_node(std::size_t s, base::NodeId node) const;
};

/// Finds the sides from the nodes of a front, in any order; nodes between corners count for
/// nothing. What is wrong, in words, or nothing.
std::string find_existing_crack_sides(const model::Mesh& mesh,
                                      const std::vector<base::NodeId>& front,
                                      ExistingCrackSides& found);

/// In the plane: the nodes of both faces from the mouth to the tip, mid nodes too, as a path that
/// was opened has them; a tip at both ends of a crack inside a body, of which the one with the
/// larger label is last. `tips` has one node, or the two of such a crack. What is wrong, in words,
/// or nothing.
std::string find_existing_crack_path(const model::Mesh& mesh, const std::vector<base::NodeId>& tips,
                                     CrackFaceNodes& faces);

} // namespace spricka::mesh
