// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"

#include "fe/element.hpp"
#include "model/model.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <gtest/gtest.h>

namespace spricka::fe::test_assemble {
namespace {

using base::ElementType;
using base::Matrix;
using base::Vec2;
using base::Vec3;
using base::Vector;

// Two kinds of elements, curved edges, a support, an external edge: the general case in small.
class Assembly : public testing::Test {
protected:
  Assembly() : model(test::plane_model(70e3, 0.33, model::StressState::plane_strain, 1.5)) {
    model::Mesh& mesh = model.mesh;
    mesh = test::make_mesh(ElementType::quamc8, test::unit_grid(3, 2), [](const Vec2& p) {
      return Vec2(p.x() + 0.1 * p.y() * p.y(), p.y() * (1.0 + 0.3 * p.x()));
    });
    // One more element, a triangle, on the right edge of the lower right cell.
    const std::span<const base::NodeId> cell = mesh.element_nodes(base::ElementId(2));
    const base::NodeId a = cell[2];
    const base::NodeId b = cell[1];
    const base::NodeId c = model::add_node(mesh, Vec3(1.6, 0.3, 0.0), 900, base::NetId(0));
    const base::ElementId e = model::add_element(
        mesh, ElementType::trim3, std::vector<base::NodeId>{a, b, c}, 900, base::NetId(0));
    mesh.property[e.index()] = base::PropertyId(0);
    test::set_freedom(
        model, model::FreedomRole::suppressed, [](const Vec3& x) { return x.x() == 0.0; }, true,
        true);
    test::set_freedom(
        model, model::FreedomRole::external, [](const Vec3& x) { return x.y() == 0.0; }, true,
        true);
    cls = classify_freedoms(model, mesh);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      nodes.emplace_back(n);
    }
    dofs = number_freedoms(mesh, nodes, cls);
    elements = test::every_element(mesh);
  }

  // K column by column: internal forces of unit displacements.
  [[nodiscard]] Matrix by_forces(std::span<const base::ElementId> some) const {
    const auto n = static_cast<Eigen::Index>(dofs.size());
    Matrix K(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      Vector u = Vector::Zero(static_cast<Eigen::Index>(dofs.row.size()));
      Vector r = u;
      u[dofs.freedom[static_cast<std::size_t>(j)]] = 1.0;
      add_internal_force(model, model.mesh, some, u, r);
      for (Eigen::Index i = 0; i < n; ++i) {
        K(i, j) = r[dofs.freedom[static_cast<std::size_t>(i)]];
      }
    }
    return K;
  }

  static Matrix dense(const base::SymmetricCsc& A) {
    Matrix K = Matrix::Zero(A.n, A.n);
    for (std::size_t j = 0; j < static_cast<std::size_t>(A.n); ++j) {
      for (auto k = static_cast<std::size_t>(A.start[j]);
           k < static_cast<std::size_t>(A.start[j + 1]); ++k) {
        const Eigen::Index i = A.row[k];
        K(i, static_cast<Eigen::Index>(j)) = K(static_cast<Eigen::Index>(j), i) = A.value[k];
      }
    }
    return K;
  }

  model::Model model;
  std::vector<model::FreedomRole> cls;
  std::vector<base::NodeId> nodes;
  std::vector<base::ElementId> elements;
  DofMap dofs;
};

TEST_F(Assembly, equals_the_internal_forces_of_unit_displacements) {
  const base::SymmetricCsc K = assemble_stiffness(model, model.mesh, elements, {}, dofs);
  const Matrix expected = by_forces(elements);
  EXPECT_LT((dense(K) - expected).norm(), 1e-14 * expected.norm());
}

TEST_F(Assembly, keeps_rows_ascending_from_the_diagonal) {
  const base::SymmetricCsc K = assemble_stiffness(model, model.mesh, elements, {}, dofs);
  ASSERT_EQ(K.n, dofs.size());
  ASSERT_EQ(K.start.size(), static_cast<std::size_t>(K.n) + 1);
  EXPECT_EQ(K.start.back(), static_cast<std::int64_t>(K.row.size()));
  for (std::size_t j = 0; j < static_cast<std::size_t>(K.n); ++j) {
    auto k = static_cast<std::size_t>(K.start[j]);
    ASSERT_LT(k, static_cast<std::size_t>(K.start[j + 1]));
    EXPECT_EQ(K.row[k], static_cast<std::int64_t>(j));
    for (++k; k < static_cast<std::size_t>(K.start[j + 1]); ++k) {
      EXPECT_LT(K.row[k - 1], K.row[k]);
    }
  }
}

TEST_F(Assembly, stores_diagonals_that_no_element_touches) {
  const std::vector<base::ElementId> one{base::ElementId(0)};
  const base::SymmetricCsc K = assemble_stiffness(model, model.mesh, one, {}, dofs);
  for (std::size_t j = 0; j < static_cast<std::size_t>(K.n); ++j) {
    EXPECT_EQ(K.row[static_cast<std::size_t>(K.start[j])], static_cast<std::int64_t>(j));
  }
  EXPECT_LT((dense(K) - by_forces(one)).norm(), 1e-9);
}

TEST_F(Assembly, adds_superelements_and_drops_their_held_freedoms) {
  const std::vector<base::ElementId> rest{elements.begin() + 3, elements.end()};
  // The first three elements as one dense block over all freedoms of the mesh, in falling order.
  Superelement super;
  const auto n = static_cast<Eigen::Index>(dofs.row.size());
  Matrix S = Matrix::Zero(n, n);
  super.stiffness = &S;
  const std::vector<base::ElementId> first{elements.begin(), elements.begin() + 3};
  for (Eigen::Index j = 0; j < n; ++j) {
    super.freedom.push_back(static_cast<std::int32_t>(n - 1 - j));
    Vector r = Vector::Zero(n);
    add_internal_force(model, model.mesh, first, Vector::Unit(n, n - 1 - j), r);
    S.col(j) = r.reverse();
  }
  const std::vector<Superelement> supers{super};
  const Matrix expected = dense(assemble_stiffness(model, model.mesh, elements, {}, dofs));
  const Matrix K = dense(assemble_stiffness(model, model.mesh, rest, supers, dofs));
  EXPECT_LT((K - expected).norm(), 1e-14 * expected.norm());
}

TEST_F(Assembly, strain_energy_is_half_uKu) {
  Vector u(static_cast<Eigen::Index>(dofs.row.size()));
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    u[i] = std::sin(0.3 + static_cast<double>(i));
  }
  Vector r = Vector::Zero(u.size());
  add_internal_force(model, model.mesh, elements, u, r);
  const double energy = 0.5 * u.dot(r);
  EXPECT_NEAR(strain_energy(model, model.mesh, elements, u), energy, 1e-13 * energy);
}

// A quadrilateral with a node named twice is the triangle that is left (Q4 collapsed to T3).
TEST(assemble_stiffness, takes_elements_with_a_node_named_twice) {
  model::Model model = test::plane_model(3.0, 0.2, model::StressState::plane_stress);
  model::Mesh& mesh = model.mesh;
  std::vector<base::NodeId> nodes;
  for (const Vec2& p : {Vec2(0, 0), Vec2(2, 0.1), Vec2(0.4, 1.5)}) {
    nodes.push_back(model::add_node(mesh, Vec3(p.x(), p.y(), 0.0), 1, base::NetId(0)));
  }
  std::vector<base::NodeId> twice = nodes;
  twice.push_back(nodes[2]);
  const std::vector<model::FreedomRole> cls(6, model::FreedomRole::local);
  const DofMap dofs = number_freedoms(mesh, nodes, cls);
  const auto q = model::add_element(mesh, ElementType::quam4, twice, 1, base::NetId(0));
  const auto t = model::add_element(mesh, ElementType::trim3, nodes, 2, base::NetId(0));
  mesh.property = {base::PropertyId(0), base::PropertyId(0)};
  const base::SymmetricCsc a =
      assemble_stiffness(model, mesh, std::vector<base::ElementId>{q}, {}, dofs);
  const base::SymmetricCsc b =
      assemble_stiffness(model, mesh, std::vector<base::ElementId>{t}, {}, dofs);
  ASSERT_EQ(a.row, b.row);
  for (std::size_t k = 0; k < a.value.size(); ++k) {
    EXPECT_NEAR(a.value[k], b.value[k], 1e-13);
  }
}

} // namespace
} // namespace spricka::fe::test_assemble
