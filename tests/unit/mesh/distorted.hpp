// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/generate/generate.hpp"

#include <array>

namespace spricka::test {

inline constexpr std::array all_types{
    base::ElementType::trim3,  base::ElementType::trimc6,  base::ElementType::quam4,
    base::ElementType::quamc8, base::ElementType::quamc9,  base::ElementType::tet4,
    base::ElementType::tet10,  base::ElementType::penta6,  base::ElementType::pentac15,
    base::ElementType::hexe8,  base::ElementType::hexec20, base::ElementType::hexec27};

/// A block of 2 x 2 (x 2) cells whose edges are all curved and of different lengths, so that no two
/// nodes of an element can be swapped unnoticed. Coordinates need all their digits. Sets: those of
/// $MESH, the overlapping element sets SOME and MORE and the node set LINE.
inline model::Mesh distorted_block(base::ElementType type) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.size = {1.3, 0.9, 1.1};
  spec.nx = spec.ny = spec.nz = 2;
  const bool solid = base::element_info(type).dim == 3;
  (solid ? mesh::generate_solid_block : mesh::generate_block)(mesh, base::NetId(std::size_t{0}), "",
                                                              spec);
  for (base::Vec3& p : mesh.x) {
    const base::Vec3 q = p;
    p.x() += 0.10 * q.y() * q.y() + 0.06 * q.x() * q.z() + 1.0 / 3.0;
    p.y() += 0.05 * q.x() * q.x() - 0.04 * q.z() * q.y();
    p.z() += solid ? 0.07 * q.x() * q.y() + 0.03 * q.z() * q.z() : 0.0;
  }
  const auto e = [](std::size_t i) { return base::ElementId(i); };
  mesh.element_sets.push_back({"SOME", {e(0), e(1)}, {}});
  mesh.element_sets.push_back({"MORE", {e(1), e(2), e(3)}, {}});
  const auto n = mesh.element_nodes(e(2));
  mesh.node_sets.push_back({"LINE", {n[0], n[1], n[2]}, {}});
  std::sort(mesh.node_sets[0].nodes.begin(), mesh.node_sets[0].nodes.end());
  return mesh;
}

} // namespace spricka::test
