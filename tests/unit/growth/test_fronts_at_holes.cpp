// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/elliptical_front.hpp"
#include "growth/free_front_shape.hpp"
#include "tests/unit/growth/growing_block.hpp"
#include "tests/unit/mesh/surface_hosts.hpp"

#include <memory>

namespace spricka::test_fronts_at_holes {
namespace {

using base::Vec3;
using test::Block;
using test::run;

// Corner cracks at the bore, in the plane y = 0 through its axis: first and second of a and c on
// the right, then on the left. The bore has a radius of 1, the plate is 8 wide and 6 thick.
Block plate_with(const std::vector<std::array<double, 2>>& right_and_left) {
  Block block(Vec3::Zero(), Vec3::Ones(), 1);
  test::HolePlate plate;
  plate.thickness = 6.0;
  plate.around = 32;
  block.model.mesh = test::hole_plate(base::ElementType::hexec20, plate);
  block.model.mesh.property.assign(block.model.mesh.element_count(), base::PropertyId(0));
  double side = 1.0;
  for (const auto& [a, c] : right_and_left) {
    block.ellipse({side, 0, 0}, a, c, side > 0.0 ? "C1" : "C2");
    block.model.cracks.back().plane.normal = -Vec3::UnitY();
    side = -side;
  }
  return block;
}

struct Grown {
  std::string end, reason;
  growth::CrackGeometry last;
};

template <class Ways> Grown grown(Block block, double last_length) {
  block.model.growth->last_length = last_length;
  growth::GrowthIntegrator march(block.model, test::paris, std::make_unique<Ways>(block.model), {});
  Grown out;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3&) {
    out.last = cracks;
    return 1.0;
  });
  out.end = march.growth_end()->word();
  out.reason = march.growth_end()->reason;
  return out;
}

// Two cracks on both sides of a hole do not meet in it: neither where the front of one would go on
// straight behind the bore, nor where the other half of an ellipse lies in the body behind it.
template <class Ways> void grow_apart() {
  const Grown both = grown<Ways>(plate_with({{0.6, 0.5}, {0.5, 0.4}}), 2.6);
  EXPECT_EQ(both.end, "AMAX") << both.reason;
  for (const model::CrackDefinition& crack : both.last.solids) {
    EXPECT_FALSE(growth::is_merged(crack));
  }
  for (std::size_t i = 0; i < both.last.aims.size(); ++i) {
    const double side = both.last.fronts[i] == 0 ? 1.0 : -1.0;
    EXPECT_GT(side * both.last.aims[i].x(), 0.99) << i;
  }
}

TEST(FrontsAtHoles, FreeOnesOnBothSidesDoNotMeet) {
  grow_apart<growth::FreeFrontShape>();
}

TEST(FrontsAtHoles, EllipsesOnBothSidesDoNotMeet) {
  grow_apart<growth::EllipticalFront>();
}

// Its other half is in the body behind the bore as the ligament on its own side is cut: that does
// not go on.
TEST(FrontsAtHoles, EllipseEndsWithItsOwnLigament) {
  const Grown one = grown<growth::EllipticalFront>(plate_with({{4.0, 2.4}}), 100.0);
  EXPECT_EQ(one.end, "EDGE") << one.reason;
}

// A plate 2 thick and 16 wide with a web 2 thick under its middle, of cubes of 1.
Block stiffened_plate() {
  constexpr int n = 16;
  Block block({-8, 0, -8}, {8, 16, 8}, n);
  model::Mesh mesh;
  mesh.dim = 3;
  const model::Mesh& whole = block.model.mesh;
  for (std::size_t i = 0; i < whole.node_count(); ++i) {
    model::add_node(mesh, whole.x[i], static_cast<base::Label>(i) + 1, base::NetId(0));
  }
  for (std::size_t e = 0; e < whole.element_count(); ++e) {
    const auto nodes = whole.element_nodes(base::ElementId(e));
    const Vec3 low = whole.x[nodes[0].index()];
    if (low.y() < 1.5 || std::abs(low.x() + 0.5) < 1.0) {
      model::add_element(mesh, base::ElementType::hexe8, nodes, static_cast<base::Label>(e) + 1,
                         base::NetId(0));
    }
  }
  mesh.property.assign(mesh.element_count(), base::PropertyId(0));
  block.model.mesh = mesh;
  return block;
}

// A surface crack opposite of the web goes on as three fronts, all as far from where it began as K
// that is the same everywhere has it.
TEST(FrontsAtHoles, CrackUnderAWebBecomesThree) {
  Block block = stiffened_plate();
  block.ellipse({0, 0, 0}, 1.0, 1.0);
  const Grown three = grown<growth::FreeFrontShape>(block, 6.0);
  EXPECT_EQ(three.end, "AMAX") << three.reason;
  std::array<int, 3> places{};
  for (const Vec3& x : three.last.aims) {
    EXPECT_NEAR(x.norm(), 6.0, 0.1 * 6.0) << x.transpose();
    ++places.at(x.y() > 2.0 + 1e-6 ? 0 : (x.x() > 0.0 ? 1 : 2));
  }
  EXPECT_TRUE(std::ranges::all_of(places, [](int count) { return count > 2; }));
}

} // namespace
} // namespace spricka::test_fronts_at_holes
