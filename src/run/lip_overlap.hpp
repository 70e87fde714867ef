// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "mesh/patch.hpp"

namespace spricka::run {

/// Faces that overlap by less, over their largest displacement, do so by round-off.
inline constexpr double overlap_of_round_off = 1e-6;

/// How far the faces of a crack run into each other at two neighbouring nodes or next to a tip,
/// over the largest displacement of one against the other; 0: they are open there. u [dim * node],
/// `line` as CrackedMesh::lips. A lone node that overlaps beside a kink is the error of its mesh:
/// finer ones open there, and to press it apart would move K by more than to leave it.
double lip_overlap(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u);

/// The same at any node.
double lone_overlap(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u);

/// The largest displacement of one face against the other; in a half model twice that off the line.
double lip_jump(const mesh::CrackedMesh& cracked, std::size_t line, const base::Vector& u);

} // namespace spricka::run
