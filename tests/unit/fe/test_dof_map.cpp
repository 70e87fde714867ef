// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dof_map.hpp"

#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

namespace spricka::fe::test_dof_map {
namespace {

using base::ElementType;
using base::Vec2;
using base::Vec3;
using model::FreedomRole;

constexpr auto everywhere = [](const Vec3&) { return true; };

model::Model square(int n = 2) {
  model::Model model = test::plane_model(1.0, 0.3, model::StressState::plane_stress);
  model.mesh = test::make_mesh(ElementType::quam4, test::unit_grid(n, n));
  return model;
}

std::vector<base::NodeId> all_nodes(const model::Mesh& mesh) {
  std::vector<base::NodeId> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    nodes.emplace_back(n);
  }
  return nodes;
}

TEST(classify_freedoms, suppressed_wins_over_prescribed_over_external) {
  model::Model model = square(1);
  const auto left = [](const Vec3& x) { return x.x() == 0.0; };
  const auto bottom = [](const Vec3& x) { return x.y() == 0.0; };
  test::set_freedom(model, FreedomRole::suppressed, left, true, false);
  test::set_freedom(model, FreedomRole::prescribed, bottom, true, true);
  test::set_freedom(model, FreedomRole::external, everywhere, true, false);
  using enum FreedomRole;
  // Nodes (0,0) (1,0) (0,1) (1,1).
  const std::vector<FreedomRole> expected{suppressed, prescribed, prescribed, prescribed,
                                          suppressed, local,      external,   local};
  EXPECT_EQ(classify_freedoms(model, model.mesh), expected);
}

TEST(number_freedoms, counts_locals_first_then_externals) {
  model::Model model = square(1);
  using enum FreedomRole;
  const std::vector<FreedomRole> cls{external, local,      suppressed, local,
                                     local,    prescribed, external,   local};
  const DofMap dofs = number_freedoms(model.mesh, all_nodes(model.mesh), cls);
  EXPECT_EQ(dofs.freedom, (std::vector<std::int32_t>{1, 3, 4, 7, 0, 6}));
  EXPECT_EQ(dofs.row, (std::vector<std::int32_t>{4, 0, -1, 1, 2, -1, 5, 3}));
  EXPECT_EQ(dofs.locals, 4);
  EXPECT_EQ(dofs.external_count(), 2);
}

TEST(number_freedoms, leaves_out_nodes_not_given) {
  const model::Model model = square(1);
  const std::vector<FreedomRole> cls(8, FreedomRole::local);
  const DofMap dofs = number_freedoms(model.mesh, {base::NodeId(2)}, cls);
  EXPECT_EQ(dofs.freedom, (std::vector<std::int32_t>{4, 5}));
  EXPECT_EQ(dofs.row[0], -1);
}

TEST(find_bodies, splits_by_shared_nodes_in_order_of_elements) {
  model::Model model = square(2);
  model::Mesh& mesh = model.mesh;
  const base::NodeId lonely = model::add_node(mesh, Vec3(9, 9, 0), 99, base::NetId(0));
  std::vector<base::NodeId> far;
  for (const Vec2& p : {Vec2(5, 0), Vec2(6, 0), Vec2(6, 1)}) {
    far.push_back(model::add_node(mesh, Vec3(p.x(), p.y(), 0.0), 100, base::NetId(1)));
  }
  const base::ElementId e = model::add_element(mesh, ElementType::trim3, far, 100, base::NetId(1));
  const std::vector<Body> bodies = find_bodies(mesh);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].elements.size(), 4U);
  EXPECT_EQ(bodies[0].nodes.size(), 9U);
  EXPECT_EQ(bodies[0].net, base::NetId(0));
  EXPECT_EQ(bodies[1].elements, std::vector<base::ElementId>{e});
  EXPECT_EQ(bodies[1].nodes, far);
  EXPECT_EQ(bodies[1].net, base::NetId(1));
  EXPECT_EQ(std::ranges::count(bodies[0].nodes, lonely), 0);
}

std::vector<Body> one_piece(const std::vector<base::NodeId>& nodes) {
  return {{base::NetId(0), {}, nodes}};
}

TEST(rigid_modes, are_orthonormal_and_strain_nothing) {
  model::Model model = square(3);
  const std::vector<base::NodeId> nodes = all_nodes(model.mesh);
  const base::Matrix modes = rigid_modes(model, model.mesh, one_piece(nodes));
  ASSERT_EQ(modes.cols(), 3);
  EXPECT_LT((modes.transpose() * modes - base::Matrix::Identity(3, 3)).norm(), 1e-14);
  for (Eigen::Index k = 0; k < 3; ++k) {
    // Rigid: every distance keeps its length to first order.
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Vec2 dx = (model.mesh.x[a] - model.mesh.x[b]).head<2>();
        const Vec2 du = modes.col(k).segment<2>(2 * static_cast<Eigen::Index>(a)) -
                        modes.col(k).segment<2>(2 * static_cast<Eigen::Index>(b));
        EXPECT_NEAR(dx.dot(du), 0.0, 1e-15);
      }
    }
  }
}

TEST(rigid_modes, are_six_and_orthonormal_in_space) {
  model::Mesh mesh;
  mesh.dim = 3;
  std::vector<base::NodeId> nodes;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(2, 0, 0.3), Vec3(0.1, 1, 0), Vec3(0, 0.4, 3)}) {
    nodes.push_back(model::add_node(mesh, x, 1, base::NetId(0)));
  }
  model::Model model;
  model.mesh.dim = 3;
  const base::Matrix modes = rigid_modes(model, mesh, one_piece(nodes));
  ASSERT_EQ(modes.cols(), 6);
  EXPECT_LT((modes.transpose() * modes - base::Matrix::Identity(6, 6)).norm(), 1e-14);
}

struct Held {
  std::vector<std::size_t> freedoms; ///< suppressed freedoms of the 2 x 2 unit square
  Eigen::Index free;
};

class FreeModes : public testing::TestWithParam<Held> {};

// Nodes of the square: 0 (0,0), 2 (1,0), 6 (0,1), 8 (1,1).
INSTANTIATE_TEST_SUITE_P(modes, FreeModes,
                         testing::Values(Held{{}, 3}, Held{{0}, 2}, Held{{0, 1}, 1},
                                         Held{{0, 1, 5}, 0}, Held{{0, 2, 4}, 2}, Held{{0, 12}, 1},
                                         Held{{0, 1, 4}, 1}, Held{{0, 1, 12, 13, 16, 17}, 0}));

TEST_P(FreeModes, span_the_motions_that_supports_leave) {
  const model::Model model = square(2);
  const std::vector<base::NodeId> nodes = all_nodes(model.mesh);
  std::vector<FreedomRole> cls(18, FreedomRole::local);
  cls[7] = FreedomRole::external;
  for (const std::size_t f : GetParam().freedoms) {
    cls[f] = f % 3 == 0 ? FreedomRole::prescribed : FreedomRole::suppressed;
  }
  const base::Matrix modes = rigid_modes(model, model.mesh, one_piece(nodes));
  const base::Matrix free =
      free_rigid_modes(model.mesh, modes, one_piece(nodes), ConstraintTransformation({}, cls), cls);
  EXPECT_EQ(free.rows(), 3);
  ASSERT_EQ(free.cols(), GetParam().free);
  const base::Matrix motion = modes * free;
  for (const std::size_t f : GetParam().freedoms) {
    EXPECT_LT(motion.row(static_cast<Eigen::Index>(f)).norm(), 1e-14);
  }
  EXPECT_LT((motion.transpose() * motion - base::Matrix::Identity(free.cols(), free.cols())).norm(),
            1e-13);
}

// A support far away from the axis of a small rotation still counts as held: the lever is what
// matters, not the size of the model.
TEST(free_rigid_modes, depends_on_no_unit_of_length) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    model::Mesh mesh =
        test::make_mesh(ElementType::quam4, test::unit_grid(2, 2),
                        [&](const Vec2& p) { return Vec2(scale * p + Vec2(3 * scale, 0)); });
    const std::vector<base::NodeId> nodes = all_nodes(mesh);
    std::vector<FreedomRole> cls(18, FreedomRole::local);
    const ConstraintTransformation none({}, cls);
    const std::vector<Body> body = one_piece(nodes);
    const base::Matrix modes = rigid_modes({}, mesh, body);
    cls[0] = cls[1] = FreedomRole::suppressed;
    EXPECT_EQ(free_rigid_modes(mesh, modes, body, none, cls).cols(), 1);
    cls[5] = FreedomRole::suppressed;
    EXPECT_EQ(free_rigid_modes(mesh, modes, body, none, cls).cols(), 0);
  }
}

} // namespace
} // namespace spricka::fe::test_dof_map
