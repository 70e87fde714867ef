// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "program/job/job.hpp"
#include "sense/load_totals.hpp"
#include "tests/unit/support/run_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_load_totals {
namespace {

constexpr int sides = 20; // of elements along the loaded edge

// A cracked plate under a pressure (or what stands for p) along its upper edge, 10 long.
std::string plate(const std::string& p) {
  return fmt::format(R"($DECK VERSION=1 LENGTH=MM FORCE=N
$NET NAME=P
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX={} NY=20
$ENDNET
$MATERIAL NAME=M E=200000 NU=0.3
$NSET NAME=LINE WHERE=(abs(y-5) < 1e-9 and x < 5.1) ORDER=(x)
$PROPERTY ESET=P.BODY MATERIAL=M STATE=STRAIN THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P.YMIN
$LOAD CASE=F TYPE=PRESSURE
  P.YMAX {}
$CRACK NAME=C PATH=LINE A0=2
$STEP NAME=S
  LOAD F 1
$END
)",
                     sides, p);
}

// What is said of a load whose set has lost this many sides in the cracked mesh.
std::vector<base::Diagnostic> messages(const std::string& p, std::size_t lost) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << plate(p);
  const program::CheckedDeck deck =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  if (!deck.model) {
    ADD_FAILURE() << "the deck is refused";
    return {};
  }
  model::Mesh cracked = deck.model->mesh;
  for (model::FaceSet& set : cracked.face_sets) {
    if (set.name == "P.YMAX") {
      set.faces.resize(set.faces.size() - lost);
    }
  }
  base::Diagnostics diagnostics;
  bool sound = true;
  for (const model::LoadCase& load_case : deck.model->cases) {
    for (const model::Load& load : load_case.loads) {
      const base::Vector f =
          fe::consistent_load_vector(*deck.model, cracked, {load_case.name, {load}});
      sound = sense::check_load_on_cracked_mesh(*deck.model, cracked, load_case, load, f,
                                                diagnostics) &&
              sound;
    }
  }
  EXPECT_EQ(sound, !diagnostics.has_errors());
  return {diagnostics.messages().begin(), diagnostics.messages().end()};
}

bool is_refused(const std::vector<base::Diagnostic>& found) {
  return std::ranges::any_of(found, [](const base::Diagnostic& d) { return d.code == "E435"; });
}

TEST(LoadTotals, AreRefusedWhereTheCrackedMeshHasLostASide) {
  EXPECT_TRUE(messages("100", 0).empty());
  const std::vector<base::Diagnostic> found = messages("100", 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().code, "E435");
  // Pressure times length: 1000 N, of which one side in twenty is gone.
  EXPECT_NE(found.front().text.find("the total of this load, 1000, by 50"), std::string::npos)
      << found.front().text;
}

// What neither mesh integrates exactly may differ by as much, and W435 says by how much that is.
TEST(LoadTotals, MayDifferByWhatIntegrationMisses) {
  EXPECT_FALSE(is_refused(messages("(100*exp(-y/3))", 0)));
  EXPECT_TRUE(is_refused(messages("(100 + x)", 1)));
}

} // namespace
} // namespace spricka::test_load_totals
