// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace spricka::shape::test_topology {
namespace {

using base::ElementType;

class EveryType : public testing::TestWithParam<ElementType> {};
INSTANTIATE_TEST_SUITE_P(topology, EveryType,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9, ElementType::tet4, ElementType::tet10,
                                         ElementType::penta6, ElementType::pentac15,
                                         ElementType::hexe8, ElementType::hexec20,
                                         ElementType::hexec27));

std::size_t corners_of_side(const base::ElementInfo& info, std::span<const int> side) {
  return static_cast<std::size_t>(
      std::count_if(side.begin(), side.end(), [&](int n) { return n < info.corners; }));
}

TEST_P(EveryType, corners_come_first_and_no_node_twice) {
  const base::ElementInfo& info = base::element_info(GetParam());
  for (int s = 0; s < info.sides; ++s) {
    const std::span<const int> side = side_nodes(GetParam(), s);
    const std::size_t corners = corners_of_side(info, side);
    EXPECT_TRUE(std::all_of(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(corners),
                            [&](int n) { return n < info.corners; }));
    EXPECT_EQ(std::set<int>(side.begin(), side.end()).size(), side.size());
    EXPECT_LT(*std::max_element(side.begin(), side.end()), info.nodes);
  }
}

TEST_P(EveryType, edges_are_those_of_the_sides) {
  const base::ElementInfo& info = base::element_info(GetParam());
  std::set<std::pair<int, int>> of_sides;
  for (int s = 0; s < info.sides; ++s) {
    const std::span<const int> side = side_nodes(GetParam(), s);
    const std::size_t corners = side_corner_count(GetParam(), s);
    EXPECT_EQ(corners, corners_of_side(info, side));
    for (std::size_t i = 0; i < side_edge_count(GetParam(), s); ++i) {
      of_sides.insert(std::minmax(side[i], side[(i + 1) % corners]));
    }
  }
  std::set<std::pair<int, int>> edges;
  for (int m = 0; m < edge_count(GetParam()); ++m) {
    const auto [a, b] = edge_corners(GetParam(), m);
    edges.insert(std::minmax(a, b));
  }
  EXPECT_EQ(edges, of_sides);
}

// A closed surface: every edge of a solid is run through once in each direction, by the two sides
// that meet there, which agree on its mid node.
TEST_P(EveryType, sides_close_and_agree_on_mid_nodes) {
  const base::ElementInfo& info = base::element_info(GetParam());
  std::map<std::pair<int, int>, int> middle;
  std::map<int, int> ends;
  for (int s = 0; s < info.sides; ++s) {
    const std::span<const int> side = side_nodes(GetParam(), s);
    const std::size_t corners = corners_of_side(info, side);
    if (info.dim == 2) {
      ++ends[side[0]];
      --ends[side[1]];
      continue;
    }
    for (std::size_t i = 0; i < corners; ++i) {
      const std::pair<int, int> edge{side[i], side[(i + 1) % corners]};
      EXPECT_FALSE(middle.contains(edge));
      middle[edge] = info.quadratic ? side[corners + i] : -1;
    }
  }
  for (const auto& [edge, node] : middle) {
    const auto opposite = middle.find({edge.second, edge.first});
    ASSERT_NE(opposite, middle.end());
    EXPECT_EQ(opposite->second, node);
  }
  for (const auto& [node, sum] : ends) {
    EXPECT_EQ(sum, 0) << node;
  }
}

} // namespace
} // namespace spricka::shape::test_topology
