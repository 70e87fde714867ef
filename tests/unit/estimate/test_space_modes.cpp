// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic modes of solids: zero at nodes, slopes, complete cubics, the same on both sides of a face.
#include "base/dense_solve.hpp"
#include "estimate/space_modes.hpp"
#include "shape/solid.hpp"
#include "shape/topology.hpp"

#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace spricka::estimate::test_space_modes {
namespace {

using base::ElementType;
using base::NodeId;
using base::Vec3;

template <class S> void vanish_at_nodes() {
  for (const auto& node : S::coordinates) {
    const Vec3 r(node[0], node[1], node[2]);
    EXPECT_LT(SolidModes::for_type(S::type).psi(r).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(SolidModes, VanishAtNodes) {
  vanish_at_nodes<shape::Tet10>();
  vanish_at_nodes<shape::Pentac15>();
  vanish_at_nodes<shape::Hexec20>();
}

TEST(SolidModes, SlopesAreDerivatives) {
  const Vec3 r(0.21, 0.34, 0.17);
  constexpr double h = 1e-6;
  for (const ElementType type : {ElementType::tet10, ElementType::pentac15, ElementType::hexec20}) {
    const SolidModes& modes = SolidModes::for_type(type);
    for (int c = 0; c < 3; ++c) {
      const base::Vector by_difference =
          (modes.psi(r + h * Vec3::Unit(c)) - modes.psi(r - h * Vec3::Unit(c))) / (2.0 * h);
      EXPECT_LT((by_difference - modes.dpsi(r).col(c)).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

// Nodes and modes together hold x^i y^j z^k, i + j + k <= 3.
template <class S> void hold_cubics() {
  const SolidModes& modes = SolidModes::for_type(S::type);
  const auto count = S::nodes + static_cast<Eigen::Index>(modes.modes().size());
  constexpr int n = 7;
  base::Matrix functions(n * n * n, count);
  base::Matrix cubics(n * n * n, 20);
  Eigen::Index row = 0;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      for (int c = 0; c < n; ++c, ++row) {
        const Vec3 r(0.05 + 0.13 * a, 0.02 + 0.14 * b, -0.4 + 0.15 * c);
        functions.row(row) << S::N(r).transpose(), modes.psi(r).transpose();
        Eigen::Index k = 0;
        for (int i = 0; i <= 3; ++i) {
          for (int j = 0; i + j <= 3; ++j) {
            for (int l = 0; i + j + l <= 3; ++l) {
              cubics(row, k++) = std::pow(r[0], i) * std::pow(r[1], j) * std::pow(r[2], l);
            }
          }
        }
      }
    }
  }
  const base::Matrix fitted = functions * base::least_squares(functions, cubics);
  EXPECT_LT((fitted - cubics).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(SolidModes, HoldCubics) {
  hold_cubics<shape::Tet10>();
  hold_cubics<shape::Pentac15>();
  hold_cubics<shape::Hexec20>();
}

// Modes of a side of a hexahedron by number along common axes, at a place of the side given by its
// corners' weights; corner k of the side is node nodes[k].
std::array<double, 4> on_side(const std::array<NodeId, 4>& nodes, double u, double w) {
  const SolidModes& modes = SolidModes::for_type(ElementType::hexec20);
  const auto local = shape::side_nodes(ElementType::hexec20, 1);
  Vec3 r = Vec3::Zero();
  const Eigen::Vector4d N = shape::Quam4::N({u, w});
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& x = shape::Hexec20::coordinates[static_cast<std::size_t>(local[k])];
    r += N[static_cast<Eigen::Index>(k)] * Vec3(x[0], x[1], x[2]);
  }
  const base::Vector psi = modes.psi(r);
  const FaceModeAxes axes = face_mode_axes(nodes);
  std::array<double, 4> values{};
  for (std::size_t m = 0; m < modes.modes().size(); ++m) {
    const SolidMode& mode = modes.modes()[m];
    if (mode.on == SolidMode::SolidModeSite::quadrilateral && mode.which == 1) {
      const auto own = static_cast<std::size_t>(mode.number);
      values[static_cast<std::size_t>(axes.number[own])] =
          axes.sign[own] * psi[static_cast<Eigen::Index>(m)];
    }
  }
  return values;
}

// A neighbour sees the same face with its corners turned and the other way round.
TEST(SolidModes, BothSidesOfAFaceHaveTheSame) {
  const std::array<NodeId, 4> nodes{NodeId(7), NodeId(3), NodeId(9), NodeId(5)};
  const std::array<std::array<double, 2>, 4> at{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const Eigen::Vector4d weight = shape::Quam4::N({0.3, -0.6});
  const std::array<double, 4> own = on_side(nodes, 0.3, -0.6);
  for (std::size_t turn = 0; turn < 4; ++turn) {
    for (const bool back : {false, true}) {
      std::array<NodeId, 4> other{};
      Eigen::Vector2d place = Eigen::Vector2d::Zero();
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t from = back ? (turn + 4 - k) % 4 : (turn + k) % 4;
        other[k] = nodes[from];
        // The same place, by the weights of its corners.
        place += weight[static_cast<Eigen::Index>(from)] * Eigen::Vector2d(at[k][0], at[k][1]);
      }
      const std::array<double, 4> seen = on_side(other, place[0], place[1]);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(seen[k], own[k], 1e-14) << turn << back << k;
      }
    }
  }
}

} // namespace
} // namespace spricka::estimate::test_space_modes
