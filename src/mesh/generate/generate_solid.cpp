// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"
#include "mesh/generate/lattice.hpp"
#include "mesh/generate/solid_points.hpp"
#include "mesh/numbering.hpp"
#include "shape/solid.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace spricka::mesh {
namespace {

using base::NodeId;
using base::Vec3;
using Place = Eigen::Vector3i; ///< on the lattice of corners, mid-edge and middle points

class SolidBlock {
public:
  SolidBlock(model::Mesh& mesh, base::NetId net, const BlockSpec& spec)
      : mesh_(mesh), net_(net), spec_(spec), info_(base::element_info(spec.type)),
        count_(spec.nx, spec.ny, spec.nz), lines_{graded_lattice_positions(spec.nx, spec.bias),
                                                  graded_lattice_positions(spec.ny, 1.0),
                                                  graded_lattice_positions(spec.nz, 1.0)},
        next_node_(next_node_label(mesh, net)), next_element_(next_element_label(mesh, net)) {
    std::size_t points = 1;
    for (const auto& line : lines_) {
      points *= line.size();
    }
    known_.resize(points);
  }

  void build(const std::string& prefix) {
    mesh_.dim = 3;
    const std::size_t first = mesh_.element_count();
    for (int k = 0; k < count_[2]; ++k) {
      for (int j = 0; j < count_[1]; ++j) {
        for (int i = 0; i < count_[0]; ++i) {
          cell({i, j, k});
        }
      }
    }
    append_body_set(mesh_, prefix, first);
    static constexpr std::array<const char*, 6> names{"XMIN", "XMAX", "YMIN",
                                                      "YMAX", "ZMIN", "ZMAX"};
    for (std::size_t s = 0; s < names.size(); ++s) {
      mesh_.face_sets.push_back({prefix + names[s], std::move(faces_[s]), {}});
    }
  }

private:
  void cell(const Place& at) {
    if (info_.corners == 8) {
      std::array<Place, 8> corner;
      for (std::size_t c = 0; c < 8; ++c) {
        corner[c] =
            2 * at + (Eigen::Map<const Vec3>(shape::detail::hexahedron[c].data()).array() + 1)
                         .cast<int>()
                         .matrix();
      }
      add(corner);
    } else if (info_.corners == 6) {
      wedges(at);
    } else {
      tetrahedra(at);
    }
  }

  /// Two, on diagonals that alternate in the plane.
  void wedges(const Place& at) {
    static constexpr std::array<std::array<int, 2>, 4> square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
    const std::size_t turn = (at[0] + at[1]) % 2 == 0 ? 0 : 1;
    for (const std::size_t half : {0U, 2U}) {
      std::array<Place, 6> corner;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& p = square[(turn + half + c) % 4];
        corner[c] = 2 * at + Place(p[0], p[1], 0);
        corner[c + 3] = corner[c] + Place(0, 0, 2);
      }
      add(corner);
    }
  }

  /// Six round a diagonal of the cell (Kuhn). Odd cells are mirrored, so that cells agree on the
  /// diagonals of the sides between them and no direction is preferred.
  void tetrahedra(const Place& at) {
    std::array<int, 3> path{0, 1, 2};
    bool even = true; // so begins the sequence of permutations; its signs go + - - + + -
    const bool mirrored = (at.unaryExpr([](int i) { return i % 2; }).sum()) % 2 == 1;
    for (int n = 0; n < 6; ++n) {
      std::array<Place, 4> corner;
      Place p = Place::Zero();
      for (std::size_t c = 0; c < 4; ++c) {
        if (c > 0) {
          p[path[c - 1]] = 2;
        }
        for (int d = 0; d < 3; ++d) {
          corner[c][d] = 2 * at[d] + (at[d] % 2 == 0 ? p[d] : 2 - p[d]);
        }
      }
      if (even == mirrored) {
        std::swap(corner[2], corner[3]);
      }
      add(corner);
      even = n % 2 == 0 ? !even : even;
      std::next_permutation(path.begin(), path.end());
    }
  }

  /// The element with these corners; its other nodes lie halfway between them.
  void add(std::span<const Place> corner) {
    const std::array<Place, 27> p = solid_element_points<Place>(
        spec_.type, corner, [](const Place& a, const Place& b) { return Place((a + b) / 2); });
    std::array<NodeId, 27> nodes;
    std::transform(p.begin(), p.begin() + info_.nodes, nodes.begin(),
                   [&](const Place& place) { return node(place); });
    const base::ElementId e = model::add_element(
        mesh_, spec_.type, std::span(nodes).first(static_cast<std::size_t>(info_.nodes)),
        next_element_++, net_);
    note_sides(e, corner);
  }

  void note_sides(base::ElementId e, std::span<const Place> corner) {
    for (int s = 0; s < info_.sides; ++s) {
      const auto local =
          shape::side_nodes(spec_.type, s).first(shape::side_corner_count(spec_.type, s));
      for (Eigen::Index d = 0; d < 3; ++d) {
        for (const int end : {0, 1}) {
          const int plane = end == 0 ? 0 : 2 * count_[d];
          if (std::all_of(local.begin(), local.end(),
                          [&](int c) { return corner[static_cast<std::size_t>(c)][d] == plane; })) {
            faces_[static_cast<std::size_t>(2 * d + end)].push_back({e, s});
          }
        }
      }
    }
  }

  NodeId node(const Place& p) {
    const auto at = [&](int d) { return static_cast<std::size_t>(p[d]); };
    NodeId& known = known_[at(0) + lines_[0].size() * (at(1) + lines_[1].size() * at(2))];
    if (!known.valid()) {
      const Vec3 part(lines_[0][at(0)], lines_[1][at(1)], lines_[2][at(2)]);
      known =
          model::add_node(mesh_, spec_.origin + spec_.size.cwiseProduct(part), next_node_++, net_);
    }
    return known;
  }

  model::Mesh& mesh_;
  base::NetId net_;
  const BlockSpec& spec_;
  const base::ElementInfo& info_;
  Place count_;
  std::array<std::vector<double>, 3> lines_;
  base::Label next_node_;
  base::Label next_element_;
  std::vector<NodeId> known_; ///< [x + nx (y + ny z)] of the lattice
  std::array<std::vector<model::Face>, 6> faces_;
};

} // namespace

void generate_solid_block(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                          const BlockSpec& spec) {
  assert(base::element_info(spec.type).dim == 3);
  SolidBlock(mesh, net, spec).build(prefix);
}

} // namespace spricka::mesh
