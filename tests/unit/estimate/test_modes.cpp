// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/edges.hpp"
#include "estimate/mode_kernel.hpp"
#include "mesh/generate/generate.hpp"
#include "shape/topology.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace spricka::test_modes {
namespace {

using estimate::Modes;
using estimate::PlaneModes;
using estimate::SideModeFrames;

template <class S> class CubicModes : public testing::Test {};
using Shapes = testing::Types<shape::Trimc6, shape::Quamc8, shape::Quamc9>;
TYPED_TEST_SUITE(CubicModes, Shapes);

template <shape::PlaneShape S> std::vector<shape::Point<2>> inner_points() {
  std::vector<shape::Point<2>> points;
  for (const auto& p : shape::quadrature<S>(9)) {
    points.push_back(p.r);
  }
  return points;
}

// From corner s to the next one at t.
template <shape::PlaneShape S> shape::Point<2> on_side(int s, double t) {
  const shape::Point<2> a = shape::node_local_coordinates<S>(s);
  const shape::Point<2> b = shape::node_local_coordinates<S>((s + 1) % Modes<S>::sides);
  return 0.5 * (1.0 - t) * a + 0.5 * (1.0 + t) * b;
}

TYPED_TEST(CubicModes, VanishAtAllNodes) {
  for (int n = 0; n < TypeParam::nodes; ++n) {
    EXPECT_LT(
        Modes<TypeParam>::psi(shape::node_local_coordinates<TypeParam>(n)).cwiseAbs().maxCoeff(),
        1e-16);
  }
}

TYPED_TEST(CubicModes, LiveOnOneSideOrInside) {
  using M = Modes<TypeParam>;
  for (int s = 0; s < M::sides; ++s) {
    for (const double t : {-0.7, -0.2, 0.4, 0.9}) {
      const shape::Point<2> r = on_side<TypeParam>(s, t);
      auto psi = M::psi(r);
      EXPECT_NEAR(psi[s], estimate::side_mode_value(t), 1e-15);
      EXPECT_NEAR(M::side_coordinate(r, s), t, 1e-15);
      psi[s] = 0.0;
      EXPECT_LT(psi.cwiseAbs().maxCoeff(), 1e-16);
    }
  }
}

TYPED_TEST(CubicModes, HaveTheSlopesOfTheirDifferences) {
  using M = Modes<TypeParam>;
  const double h = 1e-5;
  for (const shape::Point<2>& r : inner_points<TypeParam>()) {
    for (int k = 0; k < 2; ++k) {
      const shape::Point<2> step = h * shape::Point<2>::Unit(k);
      const auto slope = ((M::psi(r + step) - M::psi(r - step)) / (2.0 * h)).eval();
      EXPECT_LT((slope - M::dpsi(r).col(k)).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

// With the element's own functions they hold every cubic, and every product of cubics on
// quadrilaterals.
TYPED_TEST(CubicModes, CompleteTheCubics) {
  using S = TypeParam;
  const std::vector<shape::Point<2>> points = inner_points<S>();
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd A(rows, S::nodes + Modes<S>::count);
  for (Eigen::Index i = 0; i < rows; ++i) {
    A.row(i) << S::N(points[static_cast<std::size_t>(i)]).transpose(),
        Modes<S>::psi(points[static_cast<std::size_t>(i)]).transpose();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  EXPECT_EQ(qr.rank(), A.cols()); // hierarchical: none is a combination of the others
  for (int a = 0; a <= 3; ++a) {
    for (int b = 0; b <= 3; ++b) {
      if (S::domain == shape::ReferenceDomain::triangle && a + b > 3) {
        continue;
      }
      Eigen::VectorXd f(rows);
      for (Eigen::Index i = 0; i < rows; ++i) {
        const shape::Point<2>& r = points[static_cast<std::size_t>(i)];
        f[i] = std::pow(r[0], a) * std::pow(r[1], b);
      }
      EXPECT_LT((A * qr.solve(f) - f).cwiseAbs().maxCoeff(), 1e-12) << a << ' ' << b;
    }
  }
}

// Along an edge the modes of the elements on both sides move alike, on curved sides too.
TYPED_TEST(CubicModes, AreContinuousAcrossEdges) {
  using S = TypeParam;
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.type = S::type;
  spec.ri = 1.0;
  spec.ro = 2.0;
  spec.nr = 2;
  spec.nt = 8;
  mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
  const estimate::EdgeTable table = estimate::make_edge_table(mesh);
  struct Seen {
    std::array<base::Vec2, 2> slope; ///< du/dt by the edge's two freedoms, at t = 0.3 of the edge
  };
  std::map<std::size_t, Seen> seen;
  int shared = 0;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const fe::NodeVectors<S> X = fe::element_coordinates<S>(mesh, e);
    const auto nodes = mesh.element_nodes(e);
    SideModeFrames sides;
    for (int s = 0; s < Modes<S>::sides; ++s) {
      sides.sign[static_cast<std::size_t>(s)] =
          estimate::side_mode_sign(nodes[static_cast<std::size_t>(s)],
                                   nodes[static_cast<std::size_t>((s + 1) % Modes<S>::sides)]);
    }
    for (int s = 0; s < Modes<S>::sides; ++s) {
      const double sign = sides.sign[static_cast<std::size_t>(s)];
      const shape::Point<2> r = on_side<S>(s, 0.3 * sign);
      const Eigen::Matrix2d J = X * S::dN(r);
      const auto G = estimate::mode_gradients(PlaneModes::for_type(S::type), X, r, J, sides);
      const base::Vec2 along = sign * J *
                               (shape::node_local_coordinates<S>((s + 1) % Modes<S>::sides) -
                                shape::node_local_coordinates<S>(s));
      Seen found;
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector4d g = G.col(2 * s + k);
        found.slope[static_cast<std::size_t>(k)] = {g.head<2>().dot(along), g.tail<2>().dot(along)};
      }
      EXPECT_GT(found.slope[0].norm(), 1e-3);
      const auto [at, fresh] = seen.emplace(table.edge_at_side(e, s), found);
      if (!fresh) {
        ++shared;
        for (std::size_t k = 0; k < 2; ++k) {
          EXPECT_LT((at->second.slope[k] - found.slope[k]).norm(), 1e-13);
        }
      }
    }
  }
  EXPECT_GT(shared, 10);
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    EXPECT_LE(table.edges[e].elements, 2);
  }
}

// In its own frame a mode is that of the axes turned with the side: it moves the same points along
// the normal, and its gradients are those of that motion.
TYPED_TEST(CubicModes, FollowACurvedSideInItsFrame) {
  using S = TypeParam;
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.type = S::type;
  spec.ri = 1.0;
  spec.ro = 2.0;
  spec.nr = 1;
  spec.nt = 8;
  mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
  const fe::NodeVectors<S> X = fe::element_coordinates<S>(mesh, base::ElementId(std::size_t{0}));
  for (int s = 0; s < Modes<S>::sides; ++s) {
    SideModeFrames sides;
    sides.framed[static_cast<std::size_t>(s)] = true;
    const auto value = [&](const shape::Point<2>& r, std::size_t k) -> base::Vec2 {
      return Modes<S>::psi(r)[s] * estimate::side_frame(estimate::side_node_coordinates(
                                                            PlaneModes::for_type(S::type), X, s),
                                                        Modes<S>::side_coordinate(r, s))
                                       .axis[k];
    };
    for (const shape::Point<2>& r : inner_points<S>()) {
      const Eigen::Matrix2d J = X * S::dN(r);
      const auto G = estimate::mode_gradients(PlaneModes::for_type(S::type), X, r, J, sides);
      for (std::size_t k = 0; k < 2; ++k) {
        const double h = 1e-5;
        Eigen::Matrix2d slope;
        for (int j = 0; j < 2; ++j) {
          const shape::Point<2> step = h * shape::Point<2>::Unit(j);
          slope.col(j) = (value(r + step, k) - value(r - step, k)) / (2.0 * h);
        }
        const Eigen::Matrix2d H = slope * J.inverse();
        const Eigen::Vector4d g = G.col(2 * s + static_cast<int>(k));
        EXPECT_LT((Eigen::Vector4d(H(0, 0), H(0, 1), H(1, 0), H(1, 1)) - g).norm(), 1e-8);
      }
    }
  }
}

// Frames turn nothing but the axes that a mode is counted along: on straight sides along x and y
// both ways of integration give the same stiffness.
TYPED_TEST(CubicModes, HaveTheSameStiffnessInTheFrameOfAStraightSide) {
  using S = TypeParam;
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = S::type;
  spec.size = {1.3, 0.8, 1.0};
  mesh::generate_block(mesh, base::NetId(std::size_t{0}), "", spec);
  const fe::NodeVectors<S> X = fe::element_coordinates<S>(mesh, base::ElementId(std::size_t{0}));
  fe::ConstitutiveLaw law;
  law.lambda = 3.0;
  law.mu = 2.0;
  law.thickness = 0.7;
  SideModeFrames plain;
  plain.sign[1] = -1.0;
  SideModeFrames framed = plain;
  framed.framed[0] = true; // from (0, 0) along x: the outer normal is -y, the tangent x
  const estimate::EnrichedStiffness<S> K(X, law, plain);
  const estimate::EnrichedStiffness<S> F(X, law, framed);
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(K.ee.rows(), K.ee.rows());
  T.topLeftCorner<2, 2>() << 0.0, 1.0, -1.0, 0.0;
  const double size = K.ee.cwiseAbs().maxCoeff();
  EXPECT_LT((T.transpose() * K.ee * T - F.ee).cwiseAbs().maxCoeff(), 1e-13 * size);
  EXPECT_LT((T.transpose() * K.ep - F.ep).cwiseAbs().maxCoeff(), 1e-13 * size);
  EXPECT_LT((K.ee - K.ee.transpose()).cwiseAbs().maxCoeff(), 1e-15 * size);
}

} // namespace
} // namespace spricka::test_modes
