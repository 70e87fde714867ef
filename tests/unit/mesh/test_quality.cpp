// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include <gtest/gtest.h>

namespace spricka {
namespace {

model::Mesh one(base::ElementType type, const std::vector<base::Vec3>& x) {
  model::Mesh mesh;
  std::vector<base::NodeId> nodes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    nodes.push_back(model::add_node(mesh, x[i], static_cast<base::Label>(i + 1), {}));
  }
  model::add_element(mesh, type, nodes, 1, {});
  return mesh;
}

TEST(Quality, TurnedElementIsBad) {
  const auto mesh = one(base::ElementType::trim3, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
  const auto bad = mesh::bad_elements(mesh);
  ASSERT_EQ(bad.size(), 1U);
  EXPECT_NEAR(bad[0].jacobian, -1.0, 1e-15);
}

TEST(Quality, QuarterPointTriangleIsAccepted) {
  const auto mesh =
      one(base::ElementType::trimc6,
          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0, 0}, {0.5, 0.5, 0}, {0, 0.25, 0}});
  EXPECT_TRUE(mesh::bad_elements(mesh).empty());
}

TEST(Quality, MidNodeBeyondTheQuarterPointIsBad) {
  const auto mesh = one(base::ElementType::trimc6,
                        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}});
  EXPECT_EQ(mesh::bad_elements(mesh).size(), 1U);
}

TEST(Quality, CollapsedQuarterPointQuadrilateralIsAccepted) {
  const auto mesh = one(base::ElementType::quamc8, {{0, 0, 0},
                                                    {1, 0, 0},
                                                    {0, 1, 0},
                                                    {0, 0, 0},
                                                    {0.25, 0, 0},
                                                    {0.5, 0.5, 0},
                                                    {0, 0.25, 0},
                                                    {0, 0, 0}});
  EXPECT_TRUE(mesh::bad_elements(mesh).empty());
}

TEST(Quality, ReentrantQuadrilateralIsBad) {
  const auto mesh = one(base::ElementType::quam4, {{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}});
  ASSERT_EQ(mesh::bad_elements(mesh).size(), 1U);
}

TEST(Quality, FlatElementIsBad) {
  const auto mesh = one(base::ElementType::trim3, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(mesh::bad_elements(mesh).size(), 1U);
}

} // namespace
} // namespace spricka
