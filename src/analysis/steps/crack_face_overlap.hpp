// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "mesh/cut/cracked.hpp"

#include <span>

namespace spricka::analysis {

/// Faces that overlap by less, over their largest displacement, do so by round-off.
inline constexpr double overlap_of_round_off = 1e-6;
/// In space, where the ripple of a mesh opens and closes faces under shear: of the size of 1e-4.
inline constexpr double overlap_of_ripple = 5e-4;

/// The largest overlap [node along a face, tips left out] that two neighbouring nodes share, or one
/// of the two at either end has; 0: there is none. A lone node that overlaps inside, beside a kink,
/// is the error of its mesh: finer ones open there, and to press it apart would move K by more than
/// to leave it.
double find_shared_neighbour_overlap(std::span<const double> overlap);

/// How far the faces of a crack run into each other, over the largest displacement of one against
/// the other. u [dim * node], `line` as CrackedMesh::crack faces.
struct RelativeCrackFaceOverlap {
  double resolved = 0.0; ///< as above
  double lone = 0.0;     ///< at any node
};
/// The overlap of both kinds at the nodes of the faces; zero where nothing moves.
RelativeCrackFaceOverlap measure_relative_face_overlap(const mesh::CrackedMesh& cracked,
                                                       std::size_t line, const base::Vector& u);

/// The largest displacement of one face against the other; in a half model twice that off the line.
double largest_crack_face_jump(const mesh::CrackedMesh& cracked, std::size_t line,
                               const base::Vector& u);

} // namespace spricka::analysis
