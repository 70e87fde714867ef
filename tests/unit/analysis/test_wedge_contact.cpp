// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces made of wedges' faces, of six nodes and of eight: a press fit against Lame's. (The patch
// test is decks/patch_contact_wedges.deck.) Slides of solids that are shorter than a face, or not.
#include "tests/unit/support/solved_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace spricka::test_wedge_contact {
namespace {

struct WedgeRing {
  std::string name;
  double inner = 0.0, outer = 0.0;
  std::array<int, 3> cells{}; // along r, theta, z
  bool triangles = false;     // on the cylinders; else on the ends, and quadrilaterals on these
};

constexpr double wedge_height = 8.0;

// A quarter of a ring, its cells cut into two wedges each, nodes on the true circles.
class WedgeMesh {
public:
  explicit WedgeMesh(const WedgeRing& ring) : ring_(ring) {}

  std::string card() {
    for (int i = 0; i < ring_.cells[0]; ++i) {
      for (int j = 0; j < ring_.cells[1]; ++j) {
        for (int k = 0; k < ring_.cells[2]; ++k) {
          add_cell({2 * i, 2 * j, 2 * k});
        }
      }
    }
    return fmt::format("$NET NAME={}\n  $COOR\n{}  $ELEMENT TYPE=PENTAC15 ESET=BODY\n{}"
                       "  $NSET NAME=IN WHERE=(abs(rho - {}) < 1e-6)\n"
                       "  $NSET NAME=OUT WHERE=(abs(rho - {}) < 1e-6)\n"
                       "  $NSET NAME=NX WHERE=(abs(x) < 1e-9)\n"
                       "  $NSET NAME=NY WHERE=(abs(y) < 1e-9)\n"
                       "  $NSET NAME=NZ WHERE=(abs(z) < 1e-9 or abs(z - {}) < 1e-9)\n$ENDNET\n",
                       ring_.name, nodes_, elements_, ring_.inner, ring_.outer, wedge_height);
  }

private:
  using Place = std::array<int, 3>; // in half cells

  int node(const Place& at) {
    const auto [found, fresh] = number_.try_emplace(at, static_cast<int>(number_.size()) + 1);
    if (fresh) {
      const double s = 0.5 * at[0] / ring_.cells[0];
      const double r = ring_.inner * std::pow(ring_.outer / ring_.inner, s);
      const double angle = 0.25 * std::numbers::pi * at[1] / ring_.cells[1];
      nodes_ += fmt::format("    {} {:.15g} {:.15g} {:.15g}\n", found->second, r * std::cos(angle),
                            r * std::sin(angle), 0.5 * wedge_height * at[2] / ring_.cells[2]);
    }
    return found->second;
  }

  static Place middle(const Place& a, const Place& b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  }

  // From a triangle, and as far along one direction.
  void add_wedge(const std::array<Place, 3>& low, const Place& way) {
    std::array<Place, 6> c{};
    for (std::size_t i = 0; i < 3; ++i) {
      c[i] = low[i];
      c[i + 3] = {low[i][0] + way[0], low[i][1] + way[1], low[i][2] + way[2]};
    }
    elements_ += fmt::format("    {}", ++count_);
    for (const Place& corner : c) {
      elements_ += fmt::format(" {}", node(corner));
    }
    elements_ += "\n    &";
    static constexpr std::array<std::pair<std::size_t, std::size_t>, 9> sides{
        {{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}}};
    for (const auto& [a, b] : sides) {
      elements_ += fmt::format(" {}", node(middle(c[a], c[b])));
    }
    elements_ += "\n";
  }

  void add_cell(const Place& o) {
    // u, v span the triangles, `way` is across them: a right-handed triple
    const Place u = ring_.triangles ? Place{0, 2, 0} : Place{2, 0, 0};
    const Place v = ring_.triangles ? Place{0, 0, 2} : Place{0, 2, 0};
    const Place way = ring_.triangles ? Place{2, 0, 0} : Place{0, 0, 2};
    const auto plus = [&o](const Place& a, const Place& b) {
      return Place{o[0] + a[0] + b[0], o[1] + a[1] + b[1], o[2] + a[2] + b[2]};
    };
    const Place none{};
    add_wedge({plus(none, none), plus(u, none), plus(u, v)}, way);
    add_wedge({plus(none, none), plus(u, v), plus(v, none)}, way);
  }

  const WedgeRing& ring_;
  std::map<Place, int> number_;
  std::string nodes_, elements_;
  int count_ = 0;
};

class WedgePressFit : public testing::TestWithParam<std::pair<bool, bool>> {};

TEST_P(WedgePressFit, HasLamesPressure) {
  const WedgeRing bush{"BUSH", 30.0, 36.0, {2, 9, 2}, GetParam().first};
  const WedgeRing ring{"RING", 36.0, 86.5, {7, 7, 1}, GetParam().second};
  std::string deck =
      "$DECK VERSION=1 LENGTH=mm FORCE=N\n" + WedgeMesh(bush).card() + WedgeMesh(ring).card();
  deck += R"($MATERIAL NAME=STEEL E=210e3 NU=0.3
$MATERIAL NAME=ALUMINIUM E=70e3 NU=0.33
$PROPERTY ESET=BUSH.BODY MATERIAL=STEEL STATE=SOLID
$PROPERTY ESET=RING.BODY MATERIAL=ALUMINIUM STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=X
  BUSH.NX RING.NX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  BUSH.NY RING.NY
$FREEDOM CLASS=SUPPRESSED DOF=Z
  BUSH.NZ RING.NZ
$CONTACT NAME=FIT SLAVE=BUSH.OUT MASTER=RING.IN INTERFERENCE=0.042
$STEP NAME=PRESS
  FIT FIT 1
$END
)";
  const std::optional<test::Solved> solved = test::solve_text(deck);
  ASSERT_TRUE(solved);
  const auto square = [](double x) { return x * x; };
  const double b = square(36.0);
  const double of_ring =
      1.33 / 70e3 * (0.34 * b + square(86.5)) / (square(86.5) - b); // plane strain
  const double of_bush = 1.3 / 210e3 * (0.4 * b + square(30.0)) / (b - square(30.0));
  const double p = 0.042 / (36.0 * (of_ring + of_bush));
  const results::ContactResult& contact = solved->step().contacts.front();
  double wrong = 0.0;
  double wrong_average = 0.0;
  for (const results::ContactPoint& point : contact.points) {
    wrong += square(point.p_consistent / p - 1.0);
    wrong_average += square(point.p_lumped / p - 1.0);
    EXPECT_TRUE(point.closed);
  }
  const auto count = static_cast<double>(contact.points.size());
  std::printf("triangles on the bush %d, on the ring %d: mean %.4f %%, L2 %.3f %% (%.3f %%)\n",
              GetParam().first ? 1 : 0, GetParam().second ? 1 : 0,
              100.0 * (contact.mean_pressure / p - 1.0), 100.0 * std::sqrt(wrong / count),
              100.0 * std::sqrt(wrong_average / count));
  EXPECT_NEAR(contact.mean_pressure, p, 1e-5 * p);
  EXPECT_LT(std::sqrt(wrong / count), 4e-4);
  EXPECT_LT(std::sqrt(wrong_average / count), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Faces, WedgePressFit,
                         testing::Values(std::pair(true, true), std::pair(true, false),
                                         std::pair(false, true), std::pair(false, false)));

// A block that is drawn along a floor, by a part of an element or by more than one.
std::string drawn_block(double way) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BLOCK
  $MESH SHAPE=BLOCK TYPE=TET10 LX=6 LY=4 LZ=1 NX=6 NY=4 NZ=1
$ENDNET
$NET NAME=FLOOR
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=-2 Y0=-1 Z0=-1 LX=12 LY=6 LZ=1 NX=24 NY=12 NZ=1
$ENDNET
$MATERIAL NAME=M E=1e5 NU=0
$PROPERTY ESET=BLOCK.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=FLOOR.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  FLOOR.ZMIN
$FREEDOM CLASS=PRESCRIBED DOF=XY
  BLOCK.ZMAX
$CONTACT NAME=FOOT SLAVE=BLOCK.ZMIN MASTER=FLOOR.ZMAX MU=0.25
$LOAD CASE=WEIGHT TYPE=PRESSURE
  BLOCK.ZMAX  10
$LOAD CASE=DRAW TYPE=DISP
  BLOCK.ZMAX  ({})  ({})  0
$STEP NAME=REST
  LOAD WEIGHT 1
$STEP NAME=DRAWN
  LOAD DRAW 1
$END
)",
                     0.8 * way, 0.6 * way);
}

// Coulomb's force against the way it goes holds for any way; pairing is that of the drawn bodies,
// which is told once the way is longer than the side of the larger faces (root of the area, 0.7).
TEST(SlidesOfSolids, AreGoodForAnElementAndToldBeyond) {
  for (const double way : {0.02, 0.3, 0.65, 0.75}) {
    const std::optional<test::Solved> solved = test::solve_text(drawn_block(way));
    ASSERT_TRUE(solved);
    const results::LoadStepResult& step = solved->step(1);
    const results::ContactResult& contact = step.contacts.front();
    const double P = 240.0;
    const double sign = contact.force_on_slave.z() > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(sign * contact.force_on_slave.z(), P, 1e-8 * P);
    EXPECT_NEAR(sign * contact.force_on_slave.x(), -0.8 * 0.25 * P, 1e-6 * P) << way;
    EXPECT_NEAR(sign * contact.force_on_slave.y(), -0.6 * 0.25 * P, 1e-6 * P) << way;
    EXPECT_EQ(contact.sticking, 0);
    const bool told = std::ranges::any_of(step.notes, [](const results::Note& note) {
      return results::is_warning(note) && note.text.find("slide") != std::string::npos;
    });
    EXPECT_EQ(told, way > std::sqrt(0.5)) << way;
  }
}

} // namespace
} // namespace spricka::test_wedge_contact
