// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include <fmt/format.h>

// Results of a solid and of tied nets know neither units nor the origin, neither the numbers of
// nodes and elements nor their order, nor how many threads there are.
namespace spricka::test_tied_invariance {
namespace {

using base::NodeId;
using base::Vec3;
using test::solve_text;
using test::Solved;

/// How a deck is written: units in which l is one mm and f one N, and where its origin lies.
struct Frame {
  std::string units = "LENGTH=mm FORCE=N";
  double l = 1.0;
  double f = 1.0;
  Vec3 shift = Vec3::Zero(); ///< [mm]
};

std::string head(const Frame& frame) {
  return fmt::format("$DECK VERSION=1 {}\n$PARAMETER\n  l = {:.17g}\n  f = {:.17g}\n  sx = "
                     "{:.17g}\n  sy = {:.17g}\n  sz = {:.17g}\n",
                     frame.units, frame.l, frame.f, frame.l * frame.shift.x(),
                     frame.l * frame.shift.y(), frame.l * frame.shift.z());
}

// A coarse foot, a finer head tied to it and a loose point that moves the head's end rigidly.
std::string solids(const Frame& frame) {
  return head(frame) + R"(
$NET NAME=FOOT
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=(sx) Y0=(sy) Z0=(sz) LX=(30*l) LY=(20*l) LZ=(10*l) NX=2 NY=2 NZ=2
$ENDNET
$NET NAME=HEAD
  $MESH SHAPE=BLOCK TYPE=TET10 X0=(sx) Y0=(sy) Z0=(sz+10*l) LX=(15*l) LY=(20*l) LZ=(20*l) NX=2 NY=4 NZ=3
$ENDNET
$MATERIAL NAME=S E=(210000*f/l^2) NU=0.3 ALPHA=1.2e-5
$MATERIAL NAME=R E=(70000*f/l^2) NU=0.495 ALPHA=2.3e-5
$PROPERTY ESET=FOOT.BODY MATERIAL=S STATE=SOLID
$PROPERTY ESET=HEAD.BODY MATERIAL=R STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  FOOT.ZMIN
$MPC TYPE=TRANSITION SLAVE=HEAD.ZMIN MASTER=FOOT.ZMAX
$MPC TYPE=RIGID SLAVE=HEAD.ZMAX
$LOAD CASE=WORK TYPE=RESULTANT
  HEAD.ZMAX (500*f) (-200*f) (300*f)
$LOAD CASE=WORK TYPE=PRESSURE
  HEAD.XMAX ((2 + 0.1*(y-sy)/l)*f/l^2)
$LOAD CASE=WORK TYPE=TEMPERATURE
  HEAD.BODY (20 + (z-sz)/l)
$STEP NAME=S
  LOAD WORK 1
$END
)";
}

// Two plates tied, one of them held by a contact with a third.
std::string plates(const Frame& frame) {
  return head(frame) + R"(
$NET NAME=BASE
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=(sx) Y0=(sy) LX=(30*l) LY=(10*l) NX=7 NY=2
$ENDNET
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=QUAMC8 X0=(sx) Y0=(sy+10*l) LX=(30*l) LY=(5*l) NX=4 NY=1
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=TRIMC6 X0=(sx) Y0=(sy+15*l) LX=(30*l) LY=(10*l) NX=8 NY=3
$ENDNET
$MATERIAL NAME=S E=(210000*f/l^2) NU=0.3
$PROPERTY ESET=BASE.BODY MATERIAL=S STATE=STRESS THICK=(5*l)
$PROPERTY ESET=LOW.BODY MATERIAL=S STATE=STRESS THICK=(5*l)
$PROPERTY ESET=UP.BODY MATERIAL=S STATE=STRESS THICK=(5*l)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  BASE.YMIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  LOW.XMIN
$MPC TYPE=TRANSITION SLAVE=UP.YMIN MASTER=LOW.YMAX
$CONTACT NAME=C SLAVE=LOW.YMIN MASTER=BASE.YMAX
$LOAD CASE=WORK TYPE=PRESSURE
  UP.YMAX ((10 + (x-sx)/l)*f/l^2)
$STEP NAME=S
  LOAD WORK 1
$END
)";
}

void expect_scaled(const std::string& first, const std::string& second, const Frame& frame,
                   double tolerance) {
  const auto a = solve_text(first);
  const auto b = solve_text(second);
  ASSERT_TRUE(a && b);
  const base::Vector& u = a->step().u;
  const base::Vector& r = a->step().reaction;
  EXPECT_LT((b->step().u / frame.l - u).lpNorm<Eigen::Infinity>(),
            tolerance * u.lpNorm<Eigen::Infinity>());
  EXPECT_LT((b->step().reaction / frame.f - r).lpNorm<Eigen::Infinity>(),
            tolerance * r.lpNorm<Eigen::Infinity>());
  // What heat would store in a held body and what it gives by expanding all but cancel.
  EXPECT_NEAR(b->step().energy / (frame.l * frame.f * a->step().energy), 1.0, 1e2 * tolerance);
}

TEST(TiedInvariance, Units) {
  const Frame metre{"LENGTH=m FORCE=kN", 1e-3, 1e-3, Vec3::Zero()};
  const Frame inch{"LENGTH=in FORCE=lbf", 1.0 / 25.4, 1.0 / 4.4482216152605, Vec3::Zero()};
  for (const Frame& frame : {metre, inch}) {
    SCOPED_TRACE(frame.units);
    expect_scaled(solids({}), solids(frame), frame, 1e-12);
    expect_scaled(plates({}), plates(frame), frame, 1e-12);
  }
}

TEST(TiedInvariance, Origin) {
  Frame near;
  near.shift = Vec3(-40.0, 25.0, 60.0);
  expect_scaled(solids({}), solids(near), near, 1e-12);
  expect_scaled(plates({}), plates(near), near, 1e-12);
  // At a hundred times the size of the body coordinates have lost two digits, and stiffnesses of
  // elements another.
  Frame far;
  far.shift = Vec3(-3000.0, 2000.0, 5000.0);
  expect_scaled(solids({}), solids(far), far, 1e-10);
  expect_scaled(plates({}), plates(far), far, 1e-10);
}

TEST(TiedInvariance, SameBitsForOneAndTwoThreads) {
  for (const std::string& deck : {solids({}), plates({})}) {
    const auto one = solve_text(deck, 1);
    const auto two = solve_text(deck, 2);
    ASSERT_TRUE(one && two);
    EXPECT_GT(one->step().u.lpNorm<Eigen::Infinity>(), 0.0);
    EXPECT_TRUE((one->step().u.array() == two->step().u.array()).all());
    EXPECT_TRUE((one->step().reaction.array() == two->step().reaction.array()).all());
  }
}

/// Numbers 1 to n, shuffled.
std::vector<int> shuffled(std::size_t n, std::mt19937& random) {
  std::vector<int> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 1);
  std::shuffle(numbers.begin(), numbers.end(), random);
  return numbers;
}

// A block as $COOR and $ELEMENT cards; with `random` numbers and orders are shuffled.
std::string cards(const std::string& net, const mesh::BlockSpec& spec, std::mt19937* random) {
  model::Mesh mesh;
  if (base::element_info(spec.type).dim == 3) {
    mesh.dim = 3;
    mesh::generate_solid_block(mesh, base::NetId(0), "", spec);
  } else {
    mesh::generate_block(mesh, base::NetId(0), "", spec);
  }
  std::mt19937 still(1);
  std::vector<int> node(mesh.node_count());
  std::vector<int> element(mesh.element_count());
  std::iota(node.begin(), node.end(), 1);
  std::iota(element.begin(), element.end(), 1);
  std::vector<int> node_order = node;
  std::vector<int> element_order = element;
  if (random != nullptr) {
    node = shuffled(node.size(), *random);
    element = shuffled(element.size(), *random);
    node_order = shuffled(node.size(), *random);
    element_order = shuffled(element.size(), *random);
  }
  std::string text = fmt::format("$NET NAME={}\n$COOR NSET=NODES DIM={}\n", net, mesh.dim);
  for (const int place : node_order) {
    const auto n = static_cast<std::size_t>(place - 1);
    text += fmt::format("  {} {:.17g} {:.17g}", node[n], mesh.x[n].x(), mesh.x[n].y());
    text += mesh.dim == 3 ? fmt::format(" {:.17g}\n", mesh.x[n].z()) : "\n";
  }
  text += fmt::format("$ELEMENT TYPE={} ESET=BODY\n", base::element_info(spec.type).name);
  for (const int place : element_order) {
    const auto e = static_cast<std::size_t>(place - 1);
    text += fmt::format("  {}", element[e]);
    int column = 0;
    for (const NodeId n : mesh.element_nodes(base::ElementId(e))) {
      text += fmt::format("{}{}", ++column % 12 == 0 ? "\n  & " : " ", node[n.index()]);
    }
    text += "\n";
  }
  return text + "$ENDNET\n";
}

mesh::BlockSpec block(base::ElementType type, const Vec3& origin, const Vec3& size, int n) {
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = origin;
  spec.size = size;
  spec.nx = spec.ny = spec.nz = n;
  return spec;
}

std::string numbered(int dim, std::mt19937* random) {
  using base::ElementType;
  const bool solid = dim == 3;
  const auto coarse = solid ? ElementType::hexec20 : ElementType::quamc8;
  const auto fine = solid ? ElementType::pentac15 : ElementType::trimc6;
  const std::string all = solid ? "XYZ" : "XY";
  const std::string third = solid ? " 30" : "";
  return std::string("$DECK VERSION=1 LENGTH=mm FORCE=N\n") +
         cards("A", block(coarse, Vec3::Zero(), Vec3(20.0, 20.0, 20.0), 2), random) +
         cards("B", block(fine, Vec3(20.0, 0.0, 0.0), Vec3(20.0, 20.0, 20.0), 4), random) +
         R"($MATERIAL NAME=S E=210000 NU=0.3
$NSET NAME=FOOT  FROM=A.NODES WHERE=(x < 1e-6)
$NSET NAME=JOINA FROM=A.NODES WHERE=(x > 20 - 1e-6)
$FSET NAME=JOIN
  JOINA
$NSET NAME=SLAVE FROM=B.NODES WHERE=(x < 20 + 1e-6)
$NSET NAME=ENDN  FROM=B.NODES WHERE=(x > 40 - 1e-6)
$FSET NAME=END
  ENDN
$NSET NAME=GRIP  FROM=B.NODES WHERE=(y > 20 - 1e-6)
)" +
         fmt::format("$PROPERTY ESET=A.BODY MATERIAL=S STATE={0}\n"
                     "$PROPERTY ESET=B.BODY MATERIAL=S STATE={0}\n"
                     "$FREEDOM CLASS=SUPPRESSED DOF={1}\n  FOOT\n"
                     "$MPC TYPE=TRANSITION SLAVE=SLAVE MASTER=JOIN\n"
                     "$MPC TYPE=RIGID SLAVE=GRIP\n"
                     "$LOAD CASE=F TYPE=TRACTION\n  END 10 (20+y){2}\n"
                     "$STEP NAME=S\n  LOAD F 1\n$END\n",
                     solid ? "SOLID" : "STRESS", all, third);
}

// Nodes are found again by their places; where two nets meet both have one there.
double difference(const Solved& a, const Solved& b) {
  double worst = 0.0;
  for (std::size_t n = 0; n < a.mesh().node_count(); ++n) {
    double best = 1e300;
    for (std::size_t m = 0; m < b.mesh().node_count(); ++m) {
      if (a.mesh().x[n] == b.mesh().x[m] && a.mesh().node_net[n] == b.mesh().node_net[m]) {
        best = (a.u(NodeId(n)) - b.u(NodeId(m))).norm();
      }
    }
    worst = std::max(worst, best);
  }
  return worst / a.step().u.lpNorm<Eigen::Infinity>();
}

TEST(TiedInvariance, NumbersAndOrder) {
  for (const int dim : {2, 3}) {
    const auto tidy = solve_text(numbered(dim, nullptr));
    ASSERT_TRUE(tidy);
    EXPECT_GT(tidy->step().energy, 0.0);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(testing::Message() << dim << "D, seed " << seed);
      std::mt19937 random(seed);
      const auto mixed = solve_text(numbered(dim, &random));
      ASSERT_TRUE(mixed);
      EXPECT_LT(difference(*tidy, *mixed), 1e-12);
      EXPECT_NEAR(mixed->step().energy / tidy->step().energy, 1.0, 1e-12);
    }
  }
}

} // namespace
} // namespace spricka::test_tied_invariance
