// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Builds structured 2D meshes from cells of a lattice. A lattice has points at the corners, side
/// mid-points and centre of each cell: cell (i, j) takes the points (2i, 2j) to (2i+2, 2j+2). A
/// point is known by its key, so that blocks which give a shared point the same key are joined.
class Lattice {
public:
  using Key = std::array<int, 4>;
  struct KeyedPoint {
    Key key{};
    base::Vec3 x = base::Vec3::Zero();
  };
  using Map = std::function<KeyedPoint(int, int)>;

  Lattice(model::Mesh& mesh, base::NetId net, base::ElementType type);

  /// Meshes a cell with one quadrilateral or two triangles. Returns its sides: lower j, upper i,
  /// upper j, lower i. The map must be right-handed in (i, j).
  std::array<model::Face, 4> add_cell(int i, int j, const Map& map);

  /// The node of a point, made when first asked for.
  base::NodeId find_or_add_node(const KeyedPoint& point);

  /// A triangle of the lattice's order; `mid` are the points opposite corners 2, 0, 1.
  base::ElementId add_triangle(const std::array<base::NodeId, 3>& corner,
                               const std::array<KeyedPoint, 3>& mid);

  /// Appends the element set `prefix` + BODY of all elements made here.
  void add_body_set(const std::string& prefix);
  /// Appends a face set of that name to the mesh.
  void add_face_set(std::string name, std::vector<model::Face> faces);

private:
  base::ElementId add(base::ElementType type, std::span<const base::NodeId> nodes);

  model::Mesh& mesh_;
  base::NetId net_;
  base::ElementType type_;
  base::Label next_node_;
  base::Label next_element_;
  std::size_t first_element_;
  std::map<Key, base::NodeId> known_;
};

/// Appends the element set `prefix` + BODY of all elements of the mesh from `first` on.
void append_body_set(model::Mesh& mesh, const std::string& prefix, std::size_t first);

/// Unit vector at an angle [rad] from x; multiples of a right angle are exact, so that nodes meant
/// to lie on an axis do.
base::Vec3 unit_direction(double angle);

/// Positions 0 .. 1 of the 2n + 1 lattice lines of n intervals whose sizes grow geometrically, last
/// over first = bias; odd lines halve their interval.
std::vector<double> graded_lattice_positions(int n, double bias);

} // namespace spricka::mesh
