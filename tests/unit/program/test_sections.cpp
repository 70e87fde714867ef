// SPDX-License-Identifier: GPL-3.0-or-later
// Solids by their sections: where nothing changes along an axis, the plane deck gives what they do.
#include "deck/deck_text.hpp"
#include "program/study/deck_variant.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace spricka::test_sections {
namespace {

// @0 and @1 are the directions of the section, @a that of the axis; capital ones for keys.
std::string turned(std::string text, int axis) {
  const std::map<std::string, int> marks{{"0", (axis + 1) % 3}, {"1", (axis + 2) % 3}, {"a", axis}};
  for (const auto& [mark, d] : marks) {
    for (const auto& [sign, first] : {std::pair{'@', 'x'}, std::pair{'#', 'X'}}) {
      const std::string wanted = sign + mark;
      for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted)) {
        text.replace(at, 2, 1, static_cast<char>(first + d));
      }
    }
  }
  return text;
}

// A vector along the axis' frame, as a data line has it.
std::string vector(int axis, const std::string& v0, const std::string& v1,
                   const std::string& va = "0") {
  std::array<std::string, 3> v;
  v[static_cast<std::size_t>((axis + 1) % 3)] = v0;
  v[static_cast<std::size_t>((axis + 2) % 3)] = v1;
  v[static_cast<std::size_t>(axis)] = va;
  return v[0] + "  " + v[1] + "  " + v[2];
}

program::DeckVariant section_of(const std::string& deck, const std::string& state) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << deck;
  const program::CheckedDeck ready =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto text = deck::read_deck_card_list(file, sources, diagnostics);
  if (!ready.model || !text) {
    ADD_FAILURE() << "the deck is refused\n" << deck;
    return {};
  }
  return program::make_section_deck(*ready.model, *text, state);
}

std::string written(const program::DeckVariant& section) {
  EXPECT_TRUE(section.text) << section.reason;
  return deck::format_deck_card_list(section.text.value_or(deck::DeckCardList{}), "/");
}

// Largest difference of displacements at nodes of one number, to the largest of the solid.
double difference(const test::Solved& solid, const test::Solved& plane,
                  const sense::SectionPlane& how) {
  std::map<std::pair<std::int32_t, base::Label>, std::size_t> by_label;
  for (std::size_t n = 0; n < solid.mesh().node_count(); ++n) {
    by_label[{solid.mesh().node_net[n].value, solid.mesh().node_label[n]}] = n;
  }
  double off = 0.0;
  double size = 0.0;
  for (std::size_t n = 0; n < plane.mesh().node_count(); ++n) {
    const std::size_t of =
        by_label.at({plane.mesh().node_net[n].value, plane.mesh().node_label[n]});
    const auto last = solid.run.increments.front().steps.size() - 1;
    const base::Vec3 u = solid.vector(solid.step(last).u, base::NodeId(of));
    const base::Vec3 v = plane.vector(plane.step(last).u, base::NodeId(n));
    off = std::max({off, std::abs(v.x() - u[how.space_direction_index(0)]),
                    std::abs(v.y() - u[how.space_direction_index(1)])});
    size = std::max(size, u.norm());
  }
  return off / size;
}

// A block held between flat faces, in plane strain; `more` cards.
std::string block(int axis, const std::string& type, const std::string& more) {
  return turned("$DECK VERSION=1 LENGTH=mm FORCE=N\n"
                "$NET NAME=UP\n"
                "  $MESH SHAPE=BLOCK TYPE=" +
                    type +
                    " L#0=4 L#1=2 L#a=3 N#0=4 N#1=2 N#a=2 #00=-1.3 #10=0 #a0=5\n"
                    "$ENDNET\n"
                    "$MATERIAL NAME=M E=200000 NU=0.3 ALPHA=1e-5\n"
                    "$PROPERTY ESET=UP.BODY MATERIAL=M STATE=SOLID\n"
                    "$NSET NAME=FLAT WHERE=(abs(@a - 5) < 1e-6 or abs(@a - 8) < 1e-6)\n"
                    "$FREEDOM CLASS=SUPPRESSED DOF=#a\n"
                    "  FLAT\n" +
                    more +
                    "$STEP NAME=S\n"
                    "  LOAD F 1\n"
                    "$END\n",
                axis);
}

TEST(Section, OfABlockInPlaneStrainIsTheSolid) {
  for (const int axis : {2, 1, 0}) {
    const std::string more = "$NSET NAME=EDGE WHERE=(abs(@0 + 1.3) < 1e-6 and @1 < 1e-6)\n"
                             "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n"
                             "  EDGE\n"
                             "$NSET NAME=SIDE WHERE=(abs(@0 + 1.3) < 1e-6 and @1 > 1e-6)\n"
                             "$FREEDOM CLASS=PRESCRIBED DOF=#0\n"
                             "  SIDE\n"
                             "$LOAD CASE=F TYPE=PRESSURE\n"
                             "  UP.#1MAX  (100*(1 + @0/4)*(@a > 4))\n"
                             "$LOAD CASE=F TYPE=DISP\n"
                             "  SIDE  " +
                             vector(axis, "(0.002*@1)", "0") +
                             "\n"
                             "$LOAD CASE=F TYPE=RESULTANT\n"
                             "  UP.#0MAX  " +
                             vector(axis, "12", "(-3)") +
                             "\n"
                             "$LOAD CASE=F TYPE=TRACTION\n"
                             "  UP.#0MAX  " +
                             vector(axis, "12[MPa]", "(-3*@1)") +
                             "\n"
                             "$LOAD CASE=F TYPE=BODY\n"
                             "  UP.BODY  " +
                             vector(axis, "0.5", "(0.1*@1)") +
                             "\n"
                             "$LOAD CASE=F TYPE=TEMPERATURE\n"
                             "  UP.BODY  (20*@1)\n";
    for (const char* type : {"HEXEC20", "HEXEC27"}) {
      const std::string deck = block(axis, type, more);
      const program::DeckVariant section = section_of(deck, "STRAIN");
      EXPECT_EQ(section.section->plane.axis, axis);
      const auto solid = test::solve_text(deck);
      const auto plane = test::solve_text(written(section));
      ASSERT_TRUE(solid && plane) << deck;
      EXPECT_LT(difference(*solid, *plane, section.section->plane), 1e-9) << type << deck;
    }
  }
}

// Meshes that meet node by node, the same stress everywhere.
TEST(Section, KeepsContactsAndTheirFits) {
  for (const int axis : {2, 1, 0}) {
    const std::string deck =
        block(axis, "HEXEC20",
              "$NET NAME=LOW\n"
              "  $MESH SHAPE=BLOCK TYPE=HEXEC20 L#0=4 L#1=2 L#a=3 N#0=4 N#1=2 N#a=2 #00=-1.3 "
              "#10=-2 #a0=5\n"
              "$ENDNET\n"
              "$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=SOLID\n"
              "$FREEDOM CLASS=SUPPRESSED DOF=#1\n"
              "  LOW.#1MIN\n"
              "$FREEDOM CLASS=SUPPRESSED DOF=#0\n"
              "  LOW.#0MIN UP.#0MIN\n"
              "$CONTACT NAME=ON SLAVE=UP.#1MIN MASTER=LOW.#1MAX GAP=0.001 MULTIPLIER=CORNER\n"
              "$LOAD CASE=F TYPE=PRESSURE\n"
              "  UP.#1MAX  100\n");
    const program::DeckVariant section = section_of(deck, "STRAIN");
    const auto solid = test::solve_text(deck);
    const auto plane = test::solve_text(written(section));
    ASSERT_TRUE(solid && plane) << deck;
    EXPECT_LT(difference(*solid, *plane, section.section->plane), 1e-9) << deck;
  }
}

TEST(Section, DrawsRigidTargetsAcrossTheirAxis) {
  const std::string deck =
      block(2, "HEXEC20", R"($RIGID NAME=FLOOR SHAPE=PLANE X0=0 Y0=-1 Z0=0 X1=0.3 Y1=0 Z1=0
$RIGID NAME=SHAFT SHAPE=CYLINDER X0=2 Y0=12 Z0=0 X1=2 Y1=12 Z1=5 R=-10
$CONTACT NAME=FOOT SLAVE=UP.YMIN MASTER=FLOOR
$CONTACT NAME=TOP SLAVE=UP.YMAX MASTER=SHAFT
$LOAD CASE=F TYPE=PRESSURE
  UP.XMAX  30
)");
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "plane.deck";
  std::ofstream(file) << written(section_of(deck, "STRESS"));
  const program::CheckedDeck plane = program::read_deck_silently(file, {});
  ASSERT_TRUE(plane.model);
  const model::RigidTarget& floor = plane.model->rigids.at(0);
  const base::Vec3 way = (floor.second - floor.first).normalized();
  const base::Vec3 left(-way.y(), way.x(), 0.0); // the body is there
  EXPECT_LT((left - base::Vec3(0.3, 1.0, 0.0).normalized()).norm(), 1e-9);
  EXPECT_NEAR(left.dot(base::Vec3(0.0, -1.0, 0.0) - floor.first), 0.0, 1e-9);
  const model::RigidTarget& shaft = plane.model->rigids.at(1);
  EXPECT_EQ(shaft.shape, model::RigidTargetShape::arc);
  EXPECT_LT((shaft.first - base::Vec3(2.0, 12.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(shaft.radius, -10.0);
}

// An edge crack, inclined, through a plate that cannot grow thicker.
std::string cracked_plate(int axis, bool reversed) {
  const std::string ends =
      reversed ? "  " + vector(axis, "4", "2", "-1") + "\n  " + vector(axis, "4", "2", "3") + "\n"
               : "  " + vector(axis, "4", "2", "3") + "\n  " + vector(axis, "4", "2", "-1") + "\n";
  return turned("$DECK VERSION=1 LENGTH=mm FORCE=N\n"
                "$NET NAME=P\n"
                "  $MESH SHAPE=BLOCK TYPE=HEXEC20 #00=0 #10=-10 #a0=0 L#0=12 L#1=20 L#a=2"
                " N#0=9 N#1=15 N#a=1\n"
                "$ENDNET\n"
                "$MATERIAL NAME=M E=200000 NU=0.3\n"
                "$PROPERTY ESET=P.BODY MATERIAL=M STATE=SOLID\n"
                "$FREEDOM CLASS=SUPPRESSED DOF=#0#1\n"
                "  P.#1MIN\n"
                "$FREEDOM CLASS=SUPPRESSED DOF=#a\n"
                "  P.#aMIN P.#aMAX\n"
                "$LOAD CASE=F TYPE=TRACTION\n"
                "  P.#1MAX  " +
                    vector(axis, "0", "100") +
                    "\n"
                    "$STEP NAME=S\n"
                    "  LOAD F 1\n"
                    "$CRACK NAME=C NET=P #00=1 #10=0.5 #a0=1\n" +
                    ends + "$END\n",
                axis);
}

TEST(Section, HasTheModesOfAStraightFront) {
  for (const auto& [axis, reversed] :
       {std::pair{2, false}, std::pair{2, true}, std::pair{0, false}}) {
    std::string deck = cracked_plate(axis, reversed);
    const std::size_t dof = deck.find("DOF=ZX");
    deck.replace(dof == std::string::npos ? 0 : dof, dof == std::string::npos ? 0 : 6,
                 dof == std::string::npos ? "" : "DOF=XZ");
    const program::DeckVariant section = section_of(deck, "STRAIN");
    const auto solid = test::solve_text(deck);
    const auto plane = test::solve_text(written(section));
    ASSERT_TRUE(solid && plane);
    const results::FrontPointResult& tip = plane->step().fronts.at(0).single_point();
    const results::FrontResult& front = solid->step().fronts.at(0);
    const results::FrontPointResult& middle = front.points.at(front.points.size() / 2);
    EXPECT_NEAR(middle.K1, tip.K1, 3e-3 * tip.K1);
    EXPECT_NEAR(middle.K2, section.section->sign_of_K2.at("C") * tip.K2, 3e-3 * tip.K1);
    EXPECT_GT(std::abs(tip.K2), 0.1 * tip.K1);
  }
}

TEST(Section, IsRefusedWhereSomethingChangesAlongTheAxis) {
  const std::string foot = "$FREEDOM CLASS=SUPPRESSED DOF=XY\n  UP.YMIN\n"
                           "$LOAD CASE=F TYPE=BODY\n  UP.BODY  (x*y) 0 0\n"; // along z alone
  const std::string press = foot + "$LOAD CASE=F TYPE=PRESSURE\n  UP.YMAX 100\n";
  const std::pair<std::string, std::string> refused[]{
      {foot + "$LOAD CASE=F TYPE=PRESSURE\n  UP.YMAX (100*z)\n", "along the thickness"},
      {foot + "$LOAD CASE=F TYPE=TRACTION\n  UP.YMAX 0 0 5\n", "along the thickness"},
      {foot + "$LOAD CASE=F TYPE=FORCE\n  UP.YMAX 0 5 0\n", "forces on single nodes"},
      {foot + "$LOAD CASE=F TYPE=PRESSURE\n  UP.ZMAX 5\n", "flat face"},
      {foot +
           "$NSET NAME=HALF FROM=UP.YMAX WHERE=(z < 6.6)\n$LOAD CASE=F TYPE=PRESSURE\n  HALF 5\n",
       "part of the thickness"},
      {press + "$ESET NAME=BELOW FROM=UP.BODY WHERE=(z < 6.5)\n"
               "$LOAD CASE=F TYPE=TEMPERATURE\n  BELOW 50\n",
       "part of the thickness"},
      {press + "$MPC TYPE=RIGID SLAVE=UP.XMAX\n", "$MPC"},
      {press + "$CRACK NAME=C NET=UP A=0.5 X0=0.7 Y0=1 Z0=6.5 NORMAL=Y\n", "no straight front"},
      {press + "$RIGID NAME=R SHAPE=SPHERE X0=0.7 Y0=12 Z0=6.5 R=10\n"
               "$CONTACT NAME=ON SLAVE=UP.YMAX MASTER=R\n",
       "rigid target R"},
      {press +
           "$NET NAME=LONG\n  $MESH SHAPE=BLOCK TYPE=HEXEC20 LX=1 LY=1 LZ=4 X0=9 Z0=5\n$ENDNET\n"
           "$PROPERTY ESET=LONG.BODY MATERIAL=M STATE=SOLID\n"
           "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  LONG.XMIN\n",
       "not the same all along"},
  };
  for (const auto& [more, reason] : refused) {
    const program::DeckVariant section = section_of(block(2, "HEXEC20", more), "STRAIN");
    EXPECT_FALSE(section.text) << more;
    EXPECT_NE(section.reason.find(reason), std::string::npos) << section.reason << "\n" << more;
  }
}

} // namespace
} // namespace spricka::test_sections
