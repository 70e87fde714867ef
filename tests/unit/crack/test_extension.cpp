// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/extension.hpp"
#include "mesh/cut/split.hpp"
#include "mesh/generate/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// A crack along y = 5 with its tip at (4, 5), in a block of 10 x 10 elements of size 1.
namespace spricka::crack::test_extension {
namespace {

struct Block {
  mesh::CrackedMesh cracked;

  Block() {
    mesh::BlockSpec spec;
    spec.type = base::ElementType::quam4;
    spec.size = {10.0, 10.0, 1.0};
    spec.nx = spec.ny = 10;
    mesh::generate_block(cracked.mesh, base::NetId(std::size_t{0}), "", spec);
    cracked.mesh.property.assign(cracked.mesh.element_count(), base::PropertyId(std::size_t{0}));
    open({0.0, 5.0, 0.0}, {1.0, 0.0, 0.0}, 4);
  }

  [[nodiscard]] base::NodeId node_at(const base::Vec3& x) const {
    const auto found = std::ranges::find_if(
        cracked.mesh.x, [&](const base::Vec3& own) { return (own - x).norm() < 1e-9; });
    return base::NodeId(static_cast<std::size_t>(found - cracked.mesh.x.begin()));
  }

  void open(const base::Vec3& from, const base::Vec3& along, int count) {
    std::vector<base::NodeId> path;
    for (int i = 0; i <= count; ++i) {
      path.push_back(node_at(from + i * along));
    }
    mesh::CrackFront front;
    front.crack = base::CrackId(cracked.faces.size());
    front.a = count;
    front.tip_point() = {.node = path.back(), .x = from + count * along, .growth = along};
    const std::optional<mesh::CrackFaceNodes> faces =
        mesh::open_crack_along_path(cracked.mesh, path, false);
    ASSERT_TRUE(faces);
    cracked.faces.push_back(*faces);
    cracked.fronts.push_back(front);
  }

  /// Rings of the domains that the first tip has.
  [[nodiscard]] std::vector<int> rings() const {
    std::vector<int> kept;
    std::vector<int> left_out;
    for (const VirtualExtensionField& field :
         TipNeighbourhood(cracked.mesh)
             .extension_fields(cracked, cracked.fronts[0], {1, 2, 3}, left_out)) {
      kept.push_back(field.rings);
    }
    return kept;
  }
};

TEST(Extension, MovesItsOwnFacesButNotTheMouth) {
  const Block block;
  EXPECT_EQ(block.rings(), (std::vector<int>{1, 2, 3}));
  std::vector<int> left_out;
  EXPECT_TRUE(TipNeighbourhood(block.cracked.mesh)
                  .extension_fields(block.cracked, block.cracked.fronts[0], {4}, left_out)
                  .empty());
  EXPECT_EQ(left_out, std::vector<int>{4});
}

TEST(Extension, NodesMoveAlongTheGrowthOfTheirPoint) {
  const Block block;
  std::vector<int> left_out;
  const std::vector<VirtualExtensionField> fields =
      TipNeighbourhood(block.cracked.mesh)
          .extension_fields(block.cracked, block.cracked.fronts[0], {2}, left_out);
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].motion.size(), 27U); // 5 x 5 and the twins of the two behind the tip
  for (const NodeMotion& moved : fields[0].motion) {
    EXPECT_EQ(moved.q, 1.0);
    EXPECT_EQ(moved.along, base::Vec3::UnitX());
  }
}

// Another crack passes at x = 6, two rings away: its faces would release energy of their own.
TEST(Extension, LeavesTheFacesOfAnotherCrackAlone) {
  Block block;
  block.open({6.0, 10.0, 0.0}, {0.0, -1.0, 0.0}, 9);
  EXPECT_EQ(block.rings(), std::vector<int>{1});
}

} // namespace
} // namespace spricka::crack::test_extension
