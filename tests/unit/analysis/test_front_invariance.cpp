// SPDX-License-Identifier: GPL-3.0-or-later
// A crack in a solid has the same K along its front wherever the body is, however it is turned,
// measured and numbered.
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_front_invariance {
namespace {

using base::Vec3;

/// Where a body is put, how long its unit is, and in which order its nodes and elements come.
struct Put {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< or mirror
  Vec3 shift = Vec3::Zero();
  double unit = 1.0;
  bool backwards = false;

  [[nodiscard]] Vec3 place(const Vec3& x) const { return unit * (turn * x) + shift; }
};

constexpr int cells = 4; // along each side of a cube from -4 to 4

// A cube of tetrahedra: six in each cell, all round one of its diagonals.
class Cube {
public:
  explicit Cube(const Put& put) : put_(put) {}

  [[nodiscard]] std::string coordinates() const {
    std::string out = "$COOR\n";
    for (int n = 0; n < count(); ++n) {
      const int i = put_.backwards ? count() - 1 - n : n;
      const int row = i / side % side;
      const int layer = i / side / side;
      const Vec3 at(i % side, row, layer);
      const Vec3 x = put_.place((8.0 / (side - 1)) * at - Vec3::Constant(4.0));
      out += fmt::format("{} {:.17g} {:.17g} {:.17g}\n", n + 1, x.x(), x.y(), x.z());
    }
    return out;
  }

  [[nodiscard]] std::string elements() const {
    std::vector<std::string> lines;
    for (int c = 0; c < cells * cells * cells; ++c) {
      const Eigen::Vector3i low(c % cells, c / cells % cells, c / cells / cells);
      std::array<int, 3> way{0, 1, 2};
      do {
        lines.push_back(tetrahedron(low, way));
      } while (std::ranges::next_permutation(way).found);
    }
    if (put_.backwards) {
      std::ranges::reverse(lines);
    }
    std::string out = "$ELEMENT TYPE=TET10 ESET=BODY\n";
    for (std::size_t e = 0; e < lines.size(); ++e) {
      out += fmt::format("{} {}\n", e + 1, lines[e]);
    }
    return out;
  }

  [[nodiscard]] int node(const Eigen::Vector3i& doubled) const {
    const int i = doubled.x() + side * (doubled.y() + side * doubled.z());
    return put_.backwards ? count() - i : i + 1;
  }

private:
  static constexpr int side = 2 * cells + 1;
  static constexpr int count() { return side * side * side; }

  [[nodiscard]] std::string tetrahedron(const Eigen::Vector3i& low,
                                        const std::array<int, 3>& way) const {
    std::array<Eigen::Vector3i, 4> corner;
    corner[0] = 2 * low;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k + 1] = corner[k] + 2 * Eigen::Vector3i::Unit(way[k]);
    }
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) {
      edges.col(k) =
          put_.turn * (corner[static_cast<std::size_t>(k) + 1] - corner[0]).cast<double>();
    }
    if (edges.determinant() < 0.0) {
      std::swap(corner[2], corner[3]);
    }
    std::string line;
    for (const Eigen::Vector3i& c : corner) {
      line += fmt::format("{} ", node(c));
    }
    constexpr std::array<std::array<std::size_t, 2>, 6> mids{
        {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
    for (const auto& [i, j] : mids) {
      line += fmt::format("{} ", node((corner[i] + corner[j]) / 2));
    }
    return line;
  }

  Put put_;
};

// "dof of node = 0" along a direction, as an equation whose first freedom has a coefficient.
std::string held_along(int node, const Vec3& direction) {
  int first = 0;
  direction.cwiseAbs().maxCoeff(&first);
  std::string line = "$MPC TYPE=EQUATION\n ";
  for (const int c : {first, (first + 1) % 3, (first + 2) % 3}) {
    if (c == first || std::abs(direction[c]) > 1e-12) {
      line += fmt::format(" {:.17g} {} {}", direction[c], node, "XYZ"[c]);
    }
  }
  return line + "\n";
}

// A slanted surface crack on the face z = 4 under tension along x and shear of its plane.
std::string deck(const Put& put) {
  const Cube cube(put);
  std::string out = "$DECK VERSION=1 LENGTH=mm FORCE=N\n" + cube.coordinates() + cube.elements();
  out += "$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID\n";
  const std::array<Vec3, 3> e{put.turn.col(0), put.turn.col(1), put.turn.col(2)};
  constexpr int last = 2 * cells;
  out += fmt::format("$NSET NAME=P\n  {}\n$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  P\n",
                     cube.node({0, 0, 0}));
  out += held_along(cube.node({last, 0, 0}), e[1]) + held_along(cube.node({last, 0, 0}), e[2]);
  out += held_along(cube.node({0, last, 0}), e[2]);
  const auto face = [&](const char* name, const Vec3& n) {
    const double at = n.dot(put.shift) + put.unit * (4.0 - 1e-6);
    out += fmt::format("$FSET NAME={} WHERE=(({:.17g})*x+({:.17g})*y+({:.17g})*z > {:.17g})\n",
                       name, n.x(), n.y(), n.z(), at);
  };
  face("RIGHT", e[0]);
  face("LEFT", -e[0]);
  const Vec3 x0 = put.place({0.3, 0.2, 4.0});
  const Vec3 x1 = put.place({1.3, 0.5, 4.0});
  const Vec3 x2 = put.place({0.0, 1.2, 4.0});
  out += fmt::format("$CRACK NAME=C A={:.17g} C={:.17g}", 1.0 * put.unit, 1.3 * put.unit);
  int i = 0;
  for (const Vec3& at : {x0, x1, x2}) {
    out += fmt::format(" X{0}={1:.17g} Y{0}={2:.17g} Z{0}={3:.17g}", i++, at.x(), at.y(), at.z());
  }
  out += fmt::format("\n$TIPNET CRACK=C RADIUS={:.17g} RINGS=2 SECTORS=6", 0.3 * put.unit);
  const Vec3 pull = 100.0 * e[0];
  out += fmt::format("\n$LOAD CASE=PULL TYPE=TRACTION\n  RIGHT {:.17g} {:.17g} {:.17g}\n"
                     "  LEFT {:.17g} {:.17g} {:.17g}\n$STEP NAME=PULL\n  LOAD PULL 1\n$END\n",
                     pull.x(), pull.y(), pull.z(), -pull.x(), -pull.y(), -pull.z());
  return out;
}

std::vector<results::FrontPointResult> points_of(const Put& put, int threads = 1) {
  const auto solved = test::solve_text(deck(put), threads);
  return solved ? solved->step().fronts.at(0).points : std::vector<results::FrontPointResult>();
}

double size_of(const std::vector<results::FrontPointResult>& front) {
  double size = 0.0;
  for (const results::FrontPointResult& place : front) {
    size = std::max(size, std::hypot(place.K1, place.K2, place.K3));
  }
  return size;
}

// Of the largest K. Where round-off decides on a tetrahedron of the fill, another mesh comes out.
constexpr double same = 1e-5;

TEST(FrontInvariance, PlaceTurnUnitNumbersAndThreads) {
  const std::vector<results::FrontPointResult> first = points_of({});
  ASSERT_GT(first.size(), 6U);
  const double size = size_of(first);
  Eigen::Matrix3d cyclic;
  cyclic << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Eigen::Matrix3d odd =
      Eigen::AngleAxisd(1.1, Vec3(-2, 1, 1).normalized()).toRotationMatrix();
  std::vector<Put> puts{
      {.turn = odd, .shift = Vec3(1e-3, 2e-3, 3e-3), .unit = 1e-3, .backwards = true}};
  if (test::full_size()) { // one by one
    puts.insert(puts.end(), {{.shift = Vec3(7.3, -11.1, 23.7)},
                             {.turn = cyclic},
                             {.turn = odd, .shift = Vec3(1, 2, 3)},
                             {.unit = 1e-3},
                             {.backwards = true}});
  }
  for (std::size_t i = 0; i < puts.size(); ++i) {
    SCOPED_TRACE(i);
    const std::vector<results::FrontPointResult> other = points_of(puts[i]);
    ASSERT_EQ(other.size(), first.size());
    const double root = std::sqrt(puts[i].unit);
    for (std::size_t p = 0; p < first.size(); ++p) {
      EXPECT_NEAR(other[p].K1 / root, first[p].K1, same * size);
      EXPECT_NEAR(other[p].K2 / root, first[p].K2, same * size);
      EXPECT_NEAR(other[p].K3 / root, first[p].K3, same * size);
      EXPECT_NEAR(other[p].bar[0].size() / root, first[p].bar[0].size(), same * size);
    }
  }
  // Threads do not change a bit.
  const std::vector<results::FrontPointResult> two = points_of({}, 2);
  ASSERT_EQ(first.size(), two.size());
  for (std::size_t p = 0; p < first.size(); ++p) {
    EXPECT_EQ(first[p].K1, two[p].K1);
    EXPECT_EQ(first[p].K2, two[p].K2);
    EXPECT_EQ(first[p].K3, two[p].K3);
    EXPECT_EQ(first[p].bar[0].eta, two[p].bar[0].eta);
  }
}

// The mesher does not make the mirror image of a mesh in the mirror image of a body: K agrees
// within the bars of both. K3 changes its sign, as b points the other way.
TEST(FrontInvariance, MirrorImagesAgreeWithinTheirBars) {
  const std::vector<results::FrontPointResult> first = points_of({});
  Put put;
  put.turn = Eigen::Vector3d(1, -1, 1).asDiagonal();
  const std::vector<results::FrontPointResult> other = points_of(put);
  ASSERT_GT(first.size(), 6U);
  ASSERT_EQ(other.size(), first.size());
  double most = 0.0;
  for (std::size_t p = 0; p < first.size(); ++p) {
    const results::FrontPointResult& a = first[p];
    const results::FrontPointResult& b = other[other.size() - 1 - p];
    if (a.at_surface || b.at_surface) {
      continue;
    }
    EXPECT_NEAR(a.K1, b.K1, a.bar[0].size() + b.bar[0].size()) << p;
    EXPECT_NEAR(a.K2, b.K2, a.bar[1].size() + b.bar[1].size()) << p;
    EXPECT_NEAR(a.K3, -b.K3, a.bar[2].size() + b.bar[2].size()) << p;
    most = std::max({most, std::abs(a.K1 - b.K1), std::abs(a.K2 - b.K2), std::abs(a.K3 + b.K3)});
  }
  std::printf("mirror images differ by %.1e of K\n", most / size_of(first));
}

} // namespace
} // namespace spricka::test_front_invariance
