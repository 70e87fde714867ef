// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/lattice.hpp"

#include "mesh/numbering.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace spricka::mesh {

using base::ElementType;
using base::NodeId;

Lattice::Lattice(model::Mesh& mesh, base::NetId net, ElementType type)
    : mesh_(mesh), net_(net), type_(type), next_node_(next_node_label(mesh, net)),
      next_element_(next_element_label(mesh, net)), first_element_(mesh.element_count()) {
  assert(base::element_info(type).dim == 2);
}

NodeId Lattice::find_or_add_node(const KeyedPoint& point) {
  const auto [at, fresh] = known_.try_emplace(point.key);
  if (fresh) {
    at->second = model::add_node(mesh_, point.x, next_node_++, net_);
  }
  return at->second;
}

base::ElementId Lattice::add(ElementType type, std::span<const NodeId> nodes) {
  return model::add_element(mesh_, type, nodes, next_element_++, net_);
}

base::ElementId Lattice::add_triangle(const std::array<NodeId, 3>& corner,
                                      const std::array<KeyedPoint, 3>& mid) {
  if (!base::element_info(type_).quadratic) {
    return add(ElementType::trim3, corner);
  }
  const std::array<NodeId, 6> nodes{corner[0],
                                    corner[1],
                                    corner[2],
                                    find_or_add_node(mid[0]),
                                    find_or_add_node(mid[1]),
                                    find_or_add_node(mid[2])};
  return add(ElementType::trimc6, nodes);
}

std::array<model::Face, 4> Lattice::add_cell(int i, int j, const Map& map) {
  static constexpr std::array<std::pair<int, int>, 9> place{
      {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};
  std::array<KeyedPoint, 9> p;
  for (std::size_t k = 0; k < 9; ++k) {
    p[k] = map(2 * i + place[k].first, 2 * j + place[k].second);
  }
  const base::ElementInfo& info = base::element_info(type_);
  if (info.corners == 4) {
    std::array<NodeId, 9> nodes;
    const auto count = static_cast<std::size_t>(info.nodes);
    for (std::size_t k = 0; k < count; ++k) {
      nodes[k] = find_or_add_node(p[k]);
    }
    const base::ElementId e = add(type_, std::span(nodes).first(count));
    return {{{e, 0}, {e, 1}, {e, 2}, {e, 3}}};
  }
  // the diagonal is as curved as the sides are on the mean, and straight between straight sides
  const bool even = (i + j) % 2 == 0;
  p[8].x = even ? 0.5 * (p[0].x + p[2].x) : 0.5 * (p[1].x + p[3].x);
  for (std::size_t k = 0; k < 4; ++k) {
    p[8].x += 0.5 * (p[4 + k].x - 0.5 * (p[k].x + p[(k + 1) % 4].x));
  }
  const std::array<NodeId, 4> c{find_or_add_node(p[0]), find_or_add_node(p[1]),
                                find_or_add_node(p[2]), find_or_add_node(p[3])};
  if (even) { // diagonals alternate, so that no direction is preferred
    const base::ElementId a = add_triangle({c[0], c[1], c[2]}, {p[4], p[5], p[8]});
    const base::ElementId b = add_triangle({c[0], c[2], c[3]}, {p[8], p[6], p[7]});
    return {{{a, 0}, {a, 1}, {b, 1}, {b, 2}}};
  }
  const base::ElementId a = add_triangle({c[0], c[1], c[3]}, {p[4], p[8], p[7]});
  const base::ElementId b = add_triangle({c[1], c[2], c[3]}, {p[5], p[6], p[8]});
  return {{{a, 0}, {b, 0}, {b, 1}, {a, 2}}};
}

void Lattice::add_body_set(const std::string& prefix) {
  append_body_set(mesh_, prefix, first_element_);
}

void Lattice::add_face_set(std::string name, std::vector<model::Face> faces) {
  mesh_.face_sets.push_back({std::move(name), std::move(faces), {}});
}

void append_body_set(model::Mesh& mesh, const std::string& prefix, std::size_t first) {
  model::ElementSet set{prefix + "BODY", {}, {}};
  for (std::size_t e = first; e < mesh.element_count(); ++e) {
    set.elements.emplace_back(e);
  }
  mesh.element_sets.push_back(std::move(set));
}

base::Vec3 unit_direction(double angle) {
  const double quarters = angle / (0.5 * std::numbers::pi);
  const double nearest = std::round(quarters);
  if (std::abs(quarters - nearest) < 1e-12) {
    static constexpr std::array<std::pair<int, int>, 4> axis{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto k = static_cast<std::size_t>(((static_cast<long>(nearest) % 4) + 4) % 4);
    return {static_cast<double>(axis[k].first), static_cast<double>(axis[k].second), 0.0};
  }
  return {std::cos(angle), std::sin(angle), 0.0};
}

std::vector<double> graded_lattice_positions(int n, double bias) {
  assert(n >= 1 && bias > 0.0);
  const double ratio = n > 1 ? std::pow(bias, 1.0 / (n - 1)) : 1.0;
  std::vector<double> line(static_cast<std::size_t>(2 * n + 1));
  if (std::abs(ratio - 1.0) < 1e-12) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      line[k] = static_cast<double>(k) / (2.0 * n);
    }
    return line;
  }
  const double whole = std::pow(ratio, n) - 1.0;
  for (std::size_t k = 0; k < line.size(); k += 2) {
    line[k] = (std::pow(ratio, static_cast<double>(k) / 2.0) - 1.0) / whole;
  }
  line.back() = 1.0;
  for (std::size_t k = 1; k < line.size(); k += 2) {
    line[k] = 0.5 * (line[k - 1] + line[k + 1]);
  }
  return line;
}

} // namespace spricka::mesh
