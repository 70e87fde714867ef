// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/preview/net_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::program {

namespace {

/// A large regular mesh of one type.
struct RegularMesh {
  double elements;    ///< that a cell of the grid is cut into
  double layer_share; ///< nodes in a plane of the grid over nodes of a cell
  double neighbours;  ///< nodes that a node shares elements with, itself included, on the average
};

// [element type], counted on paper. Tetrahedra are six in a cube.
constexpr std::array<RegularMesh, base::element_infos.size()> regular_meshes{{
    {2.0, 1.0, 7.0},          // TRIM3
    {2.0, 1.0 / 2, 11.5},     // TRIMC6
    {1.0, 1.0, 9.0},          // QUAM4
    {1.0, 2.0 / 3, 47.0 / 3}, // QUAMC8
    {1.0, 1.0 / 2, 16.0},     // QUAMC9
    {6.0, 1.0, 15.0},         // TET4
    {6.0, 1.0 / 2, 29.0},     // TET10
    {2.0, 1.0, 21.0},         // PENTA6
    {2.0, 2.0 / 3, 44.0},     // PENTAC15
    {1.0, 1.0, 27.0},         // HEXE8
    {1.0, 3.0 / 4, 58.5},     // HEXEC20
    {1.0, 1.0 / 2, 64.0},     // HEXEC27
}};

} // namespace

solve::NetOutline outline_net(const model::Mesh& mesh, const analysis::Substructure& net,
                              std::size_t condensed) {
  solve::NetOutline outline;
  outline.dim = mesh.dim;
  const auto kept = std::max(condensed, static_cast<std::size_t>(net.map.external_count()));
  outline.externals = static_cast<double>(std::min(kept, net.map.freedom.size()));
  outline.locals = static_cast<double>(net.map.freedom.size()) - outline.externals;
  if (net.elements.empty()) {
    return outline;
  }
  base::Vec3 low = base::Vec3::Constant(1e300);
  base::Vec3 high = -low;
  base::Vec3 extents = base::Vec3::Zero();
  double cells = 0.0;
  double layer = 0.0;
  double neighbours = 0.0;
  for (const base::ElementId e : net.elements) {
    const base::ElementType type = mesh.type[e.index()];
    const auto corners = static_cast<std::size_t>(base::element_info(type).corners);
    base::Vec3 least = base::Vec3::Constant(1e300);
    base::Vec3 most = -least;
    for (const base::NodeId n : mesh.element_nodes(e).first(corners)) {
      least = least.cwiseMin(mesh.x[n.index()]);
      most = most.cwiseMax(mesh.x[n.index()]);
    }
    low = low.cwiseMin(least);
    high = high.cwiseMax(most);
    extents += most - least;
    const RegularMesh& regular = regular_meshes[static_cast<std::size_t>(type)];
    cells += 1.0 / regular.elements;
    layer += regular.layer_share;
    neighbours += regular.neighbours;
  }
  const auto count = static_cast<double>(net.elements.size());
  outline.layer_share = layer / count;
  outline.row_neighbours = neighbours / count;
  // As many cells as the elements make: a mesh that is fine at one place, or hollow, has fewer than
  // a box so many of its elements long, wide and high.
  double in_box = 1.0;
  for (int c = 0; c < mesh.dim; ++c) {
    double& along = outline.cells.at(static_cast<std::size_t>(c));
    along = extents[c] > 0.0 ? std::max(1.0, (high[c] - low[c]) * count / extents[c]) : 1.0;
    in_box *= along;
  }
  const double scale = std::pow(cells / in_box, 1.0 / mesh.dim);
  for (int c = 0; c < mesh.dim; ++c) {
    outline.cells.at(static_cast<std::size_t>(c)) *= scale;
  }
  return outline;
}

double element_matrix_entries(const model::Mesh& mesh, const analysis::Substructure& net) {
  double entries = 0.0;
  for (const base::ElementId e : net.elements) {
    const double freedoms = mesh.dim * base::element_info(mesh.type[e.index()]).nodes;
    entries += freedoms * freedoms;
  }
  return entries;
}

} // namespace spricka::program
