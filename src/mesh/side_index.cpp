// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/side_index.hpp"

#include "shape/topology.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace spricka::mesh {
namespace {

using base::NodeId;

struct Key {
  NodeId lowest;
  std::array<NodeId, 3> others;
};

Key key_of(std::span<const NodeId> corners) {
  assert(corners.size() >= 2 && corners.size() <= 4);
  std::array<NodeId, 4> sorted{};
  std::copy(corners.begin(), corners.end(), sorted.begin());
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(corners.size()));
  return {sorted[0], {sorted[1], sorted[2], sorted[3]}};
}

template <class F> void for_sides(const model::Mesh& mesh, std::size_t first, F&& f) {
  for (std::size_t e = first; e < mesh.element_count(); ++e) {
    const std::span<const NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const std::span<const int> local = shape::side_nodes(mesh.type[e], s);
      const std::size_t count = shape::side_corner_count(mesh.type[e], s);
      std::array<NodeId, 4> corners{};
      for (std::size_t c = 0; c < count; ++c) {
        corners[c] = nodes[static_cast<std::size_t>(local[c])];
      }
      f(std::span<const NodeId>(corners).first(count), model::Face{base::ElementId(e), s});
    }
  }
}

} // namespace

SideIndex::SideIndex(const model::Mesh& mesh, std::size_t first, const std::vector<bool>* corners)
    : begin_(mesh.node_count() + 1, 0) {
  std::vector<std::pair<Key, model::Face>> sides;
  sides.reserve(corners == nullptr ? 6 * (mesh.element_count() - first) : 0);
  for_sides(mesh, first, [&](std::span<const NodeId> nodes, model::Face face) {
    if (corners == nullptr ||
        std::ranges::all_of(nodes, [&](NodeId n) { return (*corners)[n.index()]; })) {
      const Key key = key_of(nodes);
      sides.emplace_back(key, face);
      ++begin_[key.lowest.index() + 1];
    }
  });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  others_.resize(begin_.back());
  faces_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const auto& [key, face] : sides) {
    // equal keys side by side, in the order of elements: a handful of sides meet at a node
    const std::size_t start = begin_[key.lowest.index()];
    std::size_t at = next[key.lowest.index()]++;
    for (; at > start && key.others < others_[at - 1]; --at) {
      others_[at] = others_[at - 1];
      faces_[at] = faces_[at - 1];
    }
    others_[at] = key.others;
    faces_[at] = face;
  }
}

std::span<const model::Face> SideIndex::find(std::span<const NodeId> corners) const {
  const Key key = key_of(corners);
  if (!key.lowest.valid()) {
    return {};
  }
  const auto begin = others_.begin() + static_cast<std::ptrdiff_t>(begin_[key.lowest.index()]);
  const auto end = others_.begin() + static_cast<std::ptrdiff_t>(begin_[key.lowest.index() + 1]);
  const auto [low, high] = std::equal_range(begin, end, key.others);
  return std::span(faces_).subspan(static_cast<std::size_t>(low - others_.begin()),
                                   static_cast<std::size_t>(high - low));
}

std::vector<model::Face> SideIndex::unshared_sides() const {
  std::vector<model::Face> result;
  for_same_sides([&](std::span<const model::Face> same) {
    if (same.size() == 1) {
      result.push_back(same.front());
    }
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::optional<model::Face> find_side_below(const model::Mesh& mesh, const SideIndex& sides,
                                           std::span<const NodeId> corners) {
  const std::span<const model::Face> found = sides.find(corners);
  if (found.empty()) {
    return std::nullopt;
  }
  for (const model::Face& face : found) {
    const base::ElementType type = mesh.type[face.element.index()];
    const auto nodes = mesh.element_nodes(face.element);
    const auto local =
        shape::side_nodes(type, face.side).first(shape::side_corner_count(type, face.side));
    for (std::size_t c = 0; c < shape::side_edge_count(type, face.side); ++c) {
      const std::size_t next = (c + 1) % local.size();
      if (nodes[static_cast<std::size_t>(local[c])] == corners[0] &&
          nodes[static_cast<std::size_t>(local[next])] == corners[1]) {
        return face;
      }
    }
  }
  return found.front();
}

} // namespace spricka::mesh
