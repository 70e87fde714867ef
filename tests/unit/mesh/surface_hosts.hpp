// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/generate/generate.hpp"
#include "model/mesh.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

/// Hosts for cracks in solids: a box, and a square plate with a round hole.
namespace spricka::test {

inline model::Mesh box_host(base::ElementType type, const base::Vec3& size, int n) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.size = size;
  spec.nx = spec.ny = spec.nz = n;
  mesh::generate_solid_block(mesh, base::NetId(0), "", spec);
  return mesh;
}

/// The mesh with each node moved, and nodes that then coincide made one.
inline model::Mesh moved(const model::Mesh& from,
                         const std::function<base::Vec3(const base::Vec3&)>& where) {
  model::Mesh mesh;
  mesh.dim = 3;
  std::map<std::array<long, 3>, base::NodeId> known;
  std::vector<base::NodeId> number;
  for (const base::Vec3& old : from.x) {
    const base::Vec3 x = where(old);
    const std::array<long, 3> key{std::lround(x.x() * 1e7), std::lround(x.y() * 1e7),
                                  std::lround(x.z() * 1e7)};
    const auto [at, fresh] = known.try_emplace(key, base::NodeId());
    if (fresh) {
      at->second = model::add_node(mesh, x, static_cast<base::Label>(known.size()), base::NetId(0));
    }
    number.push_back(at->second);
  }
  for (std::size_t e = 0; e < from.element_count(); ++e) {
    std::vector<base::NodeId> nodes;
    for (const base::NodeId n : from.element_nodes(base::ElementId(e))) {
      nodes.push_back(number[n.index()]);
    }
    model::add_element(mesh, from.type[e], nodes, from.element_label[e], base::NetId(0));
  }
  return mesh;
}

struct HolePlate {
  double radius = 1.0;
  double half = 4.0;      ///< of the square's side
  double thickness = 1.0; ///< z from 0
  int around = 16, outwards = 4, through = 2;
};

/// Nodes on the bore lie on it exactly, those between the corners of quadratic elements too. About
/// the z axis.
inline model::Mesh hole_plate(base::ElementType type, const HolePlate& plate) {
  model::Mesh block;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.size = {1.0, 1.0, plate.thickness};
  spec.nx = plate.outwards;
  spec.ny = plate.around;
  spec.nz = plate.through;
  spec.bias = 2.0;
  mesh::generate_solid_block(block, base::NetId(0), "", spec);
  return moved(block, [&](const base::Vec3& x) -> base::Vec3 {
    const double angle = 2.0 * std::numbers::pi * x.y();
    const base::Vec2 d(std::cos(angle), std::sin(angle));
    const base::Vec2 at =
        (1.0 - x.x()) * plate.radius * d + x.x() * plate.half / d.cwiseAbs().maxCoeff() * d;
    return {at.x(), at.y(), x.z()};
  });
}

} // namespace spricka::test
