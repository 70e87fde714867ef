// SPDX-License-Identifier: GPL-3.0-or-later
// The operator of the cubic modes of solids: what the points of a rule give one by one, symmetry,
// rigid motions, its diagonal.
#include "estimate/space_operator.hpp"

#include "estimate/space_modes.hpp"
#include "fe/element.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace spricka::estimate::test_space_operator {
namespace {

using base::ElementType;
using base::Vec3;

// A number without a pattern in -1 .. 1.
double rough(Eigen::Index i) {
  return std::sin(1.7 * static_cast<double>(i * i % 97));
}

base::Vector rough_vector(Eigen::Index size) {
  base::Vector v(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    v[i] = rough(i);
  }
  return v;
}

/// A block of curved elements, more of them than go together and no multiple of that.
struct Block {
  model::Model model;
  SolidModeNumbers numbers;

  explicit Block(ElementType type) {
    mesh::BlockSpec spec;
    spec.type = type;
    spec.size = {1.0, 2.0, 1.5};
    spec.nx = 3;
    spec.ny = 4;
    spec.nz = 3;
    model.nets = {{"", {}}};
    mesh::generate_solid_block(model.mesh, base::NetId(std::size_t{0}), "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 1e-5, {}}};
    model.properties = {{base::ElementSetId(std::size_t{0}),
                         base::MaterialId(std::size_t{0}),
                         model::StressState::solid,
                         1.0,
                         {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        model.mesh.x[n][c] += 0.01 * rough(3 * static_cast<Eigen::Index>(n) + c);
      }
    }
    numbers = number_solid_modes(model.mesh,
                                 std::vector<model::FreedomRole>(static_cast<std::size_t>(nodal()),
                                                                 model::FreedomRole::local),
                                 fe::ConstraintTransformation({}, {}));
  }

  [[nodiscard]] Eigen::Index nodal() const {
    return 3 * static_cast<Eigen::Index>(model.mesh.node_count());
  }
  [[nodiscard]] Eigen::Index modal() const { return numbers.free.size(); }

  // Forces of all elements, point by point: nodes [3 * node], then modes.
  [[nodiscard]] base::Vector by_points(const base::Vector& motion) const {
    base::Vector forces = base::Vector::Zero(nodal() + modal());
    for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
      if (SolidModes::has_modes_for_type(model.mesh.type[e])) {
        add(base::ElementId(e), motion, forces);
      }
    }
    return forces;
  }

private:
  void add(base::ElementId e, const base::Vector& motion, base::Vector& forces) const {
    const ElementType type = model.mesh.type[e.index()];
    const fe::AnyElement<3>& element = shape::reference_element<3>(type);
    const SolidModes& modes = SolidModes::for_type(type);
    const auto count = element.nodes + static_cast<Eigen::Index>(modes.modes().size());
    std::vector<Eigen::Index> at;
    std::vector<double> sign;
    for (const base::NodeId n : model.mesh.element_nodes(e)) {
      at.push_back(3 * static_cast<Eigen::Index>(n.index()));
      sign.push_back(1.0);
    }
    for (std::size_t m = numbers.first[e.index()]; m < numbers.first[e.index() + 1]; ++m) {
      at.push_back(nodal() + 3 * static_cast<Eigen::Index>(numbers.mode[m]));
      sign.push_back(numbers.sign[m]);
    }
    const fe::AnyNodeVectors<3> X = fe::element_coordinates(element, model.mesh, e);
    const fe::ConstitutiveLaw law = fe::constitutive_law(model, model.mesh, e);
    const int degree = type == ElementType::tet10 ? 5 : 7;
    for (const auto& point : shape::quadrature<3>(element.domain, degree)) {
      const fe::AnyElement<3>::ShapeDerivatives dN = element.dN(point.r);
      base::Matrix slopes(count, 3);
      slopes << dN, modes.dpsi(point.r);
      const Eigen::Matrix3d J = X.lazyProduct(dN);
      slopes = (slopes * J.inverse()).eval();
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      for (std::size_t k = 0; k < at.size(); ++k) {
        H += sign[k] * motion.segment<3>(at[k]) * slopes.row(static_cast<Eigen::Index>(k));
      }
      const Eigen::Matrix3d sigma =
          law.lambda * H.trace() * Eigen::Matrix3d::Identity() + law.mu * (H + H.transpose());
      for (std::size_t k = 0; k < at.size(); ++k) {
        forces.segment<3>(at[k]) += sign[k] * point.weight * J.determinant() * sigma *
                                    slopes.row(static_cast<Eigen::Index>(k)).transpose();
      }
    }
  }
};

class SpaceOperatorOf : public testing::TestWithParam<ElementType> {
protected:
  Block block{GetParam()};
  SolidModeStiffness op{block.model, block.model.mesh, block.numbers};
  base::Vector v = rough_vector(block.nodal());
  base::Vector x = rough_vector(block.modal());

  [[nodiscard]] base::Vector all(const base::Vector* nodes, const base::Vector* modes) const {
    base::Vector f = base::Vector::Zero(block.nodal());
    base::Vector g = base::Vector::Zero(block.modal());
    op.add_forces({nodes, modes}, {&f, &g});
    base::Vector both(f.size() + g.size());
    both << f, g;
    return both;
  }
};

TEST_P(SpaceOperatorOf, GivesWhatThePointsGive) {
  base::Vector motion(v.size() + x.size());
  motion << v, x;
  const base::Vector expected = block.by_points(motion);
  EXPECT_LT((all(&v, &x) - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT((all(&v, nullptr) + all(nullptr, &x) - expected).norm(), 1e-13 * expected.norm());
}

TEST_P(SpaceOperatorOf, GivesAPartAsItDoesTheWhole) {
  base::Vector f = base::Vector::Zero(block.nodal());
  base::Vector g = base::Vector::Zero(block.modal());
  op.add_forces({&v, nullptr}, {nullptr, &g});
  op.add_forces({nullptr, &x}, {&f, nullptr});
  EXPECT_LT((g - all(&v, nullptr).tail(g.size())).norm(), 1e-14 * g.norm());
  EXPECT_LT((f - all(nullptr, &x).head(f.size())).norm(), 1e-14 * f.norm());
  // K_ep is the transpose of K_pe.
  EXPECT_NEAR(x.dot(g), v.dot(f), 1e-12 * x.norm() * g.norm());
}

TEST_P(SpaceOperatorOf, RestsUnderRigidMotions) {
  const Vec3 turn(0.3, -0.7, 0.4);
  base::Vector rigid(block.nodal());
  for (std::size_t n = 0; n < block.model.mesh.node_count(); ++n) {
    rigid.segment<3>(3 * static_cast<Eigen::Index>(n)) =
        Vec3(1.0, 2.0, 3.0) + turn.cross(block.model.mesh.x[n]);
  }
  EXPECT_LT(all(&rigid, nullptr).norm(), 1e-12 * all(&v, nullptr).norm());
}

// As a preconditioner it must have no motion without energy, and none with too much.
TEST_P(SpaceOperatorOf, IsNearByFewerPoints) {
  for (Eigen::Index shift = 0; shift < 5; ++shift) {
    base::Vector motion(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      motion[i] = rough(i + 31 * shift);
    }
    base::Vector f = base::Vector::Zero(x.size());
    op.add_forces({nullptr, &motion}, {nullptr, &f}, ModeStiffnessRule::reduced);
    const double energy = motion.dot(all(nullptr, &motion).tail(x.size()));
    EXPECT_NEAR(motion.dot(f), energy, 0.1 * energy);
  }
}

TEST_P(SpaceOperatorOf, HasItsDiagonal) {
  const std::vector<Eigen::Matrix3d> diagonal = op.diagonal_blocks();
  ASSERT_EQ(static_cast<Eigen::Index>(3 * diagonal.size()), block.modal());
  for (Eigen::Index m = 0; m < block.modal() / 3; m += 37) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const base::Vector one = base::Vector::Unit(block.modal(), 3 * m + c);
      const Vec3 column = all(nullptr, &one).segment<3>(block.nodal() + 3 * m);
      const Eigen::Matrix3d& own = diagonal[static_cast<std::size_t>(m)];
      EXPECT_LT((column - own.col(c)).norm(), 1e-12 * own.norm());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Types, SpaceOperatorOf,
                         testing::Values(ElementType::tet10, ElementType::pentac15,
                                         ElementType::hexec20),
                         [](const auto& type) {
                           return std::string(base::element_info(type.param).name);
                         });

} // namespace
} // namespace spricka::estimate::test_space_operator
