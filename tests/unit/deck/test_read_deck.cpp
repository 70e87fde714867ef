// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "model/model.hpp"

#include <system_error>
#include <variant>

#include <gtest/gtest.h>

namespace spricka::deck::test_read_deck {
namespace {

TEST(ReadDeck, ASmallDeckBecomesAModel) {
  const Folder folder;
  const Reading r(folder, k_square + "$NSET NAME=RIM\n 1 : 4\n"
                                     "$FREEDOM CLASS=PRESCRIBED DOF=XY\n RIM\n"
                                     "$LOAD CASE=LINEAR TYPE=DISP\n RIM (1e-3*(x+y/2)) 0\n"
                                     "$STEP NAME=PULL SUBSTEPS=2\n LOAD LINEAR (2/4)\n"
                                     "$OUTPUT FILE='a.csv' FORMAT=CSV\n S PLATE\n"
                                     "$CHECK\n S.XX.MIN(PLATE, PULL) = (4/3)[MPa] REL 1e-10 "
                                     "SOURCE 'exact'\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  const model::Model& m = *r.model;
  EXPECT_EQ(m.units.stress_name(), "MPa");
  EXPECT_EQ(m.mesh.node_count(), 4U);
  ASSERT_EQ(m.mesh.element_count(), 1U);
  EXPECT_EQ(m.element_material(m.mesh, base::ElementId(0)).E, 210000.0);
  EXPECT_EQ(m.element_property(m.mesh, base::ElementId(0)).thickness, 1.0);
  EXPECT_EQ(m.freedoms.at(0).cls, model::FreedomRole::prescribed);
  EXPECT_EQ(m.freedoms.at(0).dof, (std::array<bool, 3>{true, true, false}));
  const model::Load& load = m.cases.at(0).loads.at(0);
  EXPECT_EQ(load.type, model::LoadType::displacement);
  EXPECT_EQ(load.value.at(0)(base::Vec3(1.0, 2.0, 0.0)), 2e-3);
  EXPECT_EQ(m.steps.at(0).substeps, 2);
  EXPECT_EQ(std::get<model::ApplyLoad>(m.steps.at(0).actions.at(0)).factor, 0.5);
  EXPECT_EQ(m.outputs.at(0).requests.at(0).name, "PLATE");
  const model::ResultCheck& check = m.checks.at(0);
  EXPECT_EQ(check.quantity, "S.XX.MIN");
  EXPECT_EQ(std::get<std::string>(check.arguments.at(1)), "PULL");
  EXPECT_EQ(check.source, "exact");
  EXPECT_TRUE(check.relative);
  EXPECT_TRUE(m.unavailable.empty());
}

TEST(ReadDeck, GapsAndFits) {
  const Folder folder;
  const auto gap = [&](const std::string& keys) {
    const Reading r(folder, k_square +
                                "$FSET NAME=L WHERE=(x == 0)\n$FSET NAME=R WHERE=(x == 1)\n"
                                "$CONTACT NAME=C SLAVE=L MASTER=R " +
                                keys + "\n$END\n");
    EXPECT_TRUE(r.model) << r.messages();
    return r.model ? r.model->contacts.at(0).gap : std::nullopt;
  };
  EXPECT_EQ(gap("GAP=0.5"), 0.5);
  EXPECT_EQ(gap("GAP=0"), 0.0);
  EXPECT_EQ(gap("INTERFERENCE=0.5"), -0.5);
  EXPECT_EQ(gap("DIAMETRAL=0.084"), -0.042);
  EXPECT_EQ(gap(""), std::nullopt);
}

TEST(ReadDeck, TheCommandLineOverridesParametersEverywhere) {
  const Folder folder;
  folder.write("sub/more.inc", "$PARAMETER\n t = 5\n$INCLUDE FILE='deep.inc'\n");
  folder.write("sub/deep.inc", "$NSET NAME=CORNER\n (n)\n");
  DeckReadOptions options;
  options.defines = {{"T", "3*2[mm]"}, {"N", "3"}};
  const Reading r(folder,
                  k_square + "$PARAMETER\n n = 1\n$INCLUDE FILE='sub/more.inc'\n"
                             "$PARAMETER\n twice = 2*t\n"
                             "$OUTPUT FILE='a' FORMAT=VTU\n U CORNER\n$END\n",
                  options);
  ASSERT_TRUE(r.model) << r.messages();
  EXPECT_EQ(r.model->mesh.node_label[r.model->mesh.node_sets[0].nodes[0].index()], 3);
  EXPECT_EQ(r.model->parameters.back().second, 12.0);
}

TEST(ReadDeck, BadDefinitionsOnTheCommandLine) {
  const Folder folder;
  DeckReadOptions options;
  options.defines = {{"x", "1"}, {"2", "1"}, {"A", "1+"}, {"B", "Q"}};
  const Reading r(folder, k_square + "$END\n", options);
  EXPECT_EQ(r.diagnostics.error_count(), 4U) << r.messages();
}

TEST(ReadDeck, DefinitionsOnTheCommandLineMayUseOtherParameters) {
  const Folder folder;
  DeckReadOptions options;
  options.defines = {{"c", "a + 10*b"}, {"b", "2*a"}};
  const Reading r(folder, k_square + "$PARAMETER\n a = 3\n b = 1\n c = 0\n$END\n", options);
  ASSERT_TRUE(r.model) << r.messages();
  EXPECT_EQ(r.model->parameters.at(1).second, 6.0);
  EXPECT_EQ(r.model->parameters.at(2).second, 63.0);
  options.defines = {{"a", "b"}, {"b", "2*a"}};
  const Reading circle(folder, k_square + "$PARAMETER\n a = 3\n b = 1\n$END\n", options);
  EXPECT_EQ(circle.codes(), "E210") << circle.messages();
  options.defines = {{"delat", "1"}};
  const Reading misspelt(folder, k_square + "$PARAMETER\n delta = 3\n$END\n", options);
  EXPECT_EQ(misspelt.codes(), "E201") << misspelt.messages();
  EXPECT_NE(misspelt.messages().find("did you mean 'DELTA'"), std::string::npos)
      << misspelt.messages();
}

TEST(ReadDeck, SweepsTakeValuesWithUnitsAndExpressions) {
  const Folder folder;
  const std::string deck = k_square + "$PARAMETER\n fit = 0.1\n mu = 0\n E1 = 1\n"
                                      "$SWEEP PARAMETER=fit WITH=MU\n 0 0  1[um] (fit/2)\n"
                                      "$SWEEP PARAMETER=E1\n 3\n 4 5\n$END\n";
  const Reading r(folder, deck);
  ASSERT_TRUE(r.model) << r.messages();
  ASSERT_EQ(r.model->sweeps.size(), 2U);
  EXPECT_EQ(r.model->sweeps[0].parameters, (std::vector<std::string>{"fit", "mu"}));
  EXPECT_EQ(r.model->sweeps[0].values, (std::vector<std::vector<double>>{{0, 0}, {1e-3, 0.05}}));
  EXPECT_EQ(r.model->sweeps[1].values, (std::vector<std::vector<double>>{{3}, {4}, {5}}));
  DeckReadOptions options;
  options.defines = {{"MU", "1"}};
  EXPECT_EQ(Reading(folder, deck, options).codes(), "E390");
  options.defines.clear();
  options.sweep_values = {{"fit", 0.25}, {"mu", 0.125}};
  const Reading point(folder, deck, options);
  ASSERT_TRUE(point.model) << point.messages();
  EXPECT_EQ(point.model->parameters.at(0).second, 0.25);
  EXPECT_EQ(Reading(folder, k_square + "$PARAMETER\n a = 1\n$SWEEP PARAMETER=a\n 1\n"
                                       "$SWEEP PARAMETER=a\n 2\n$END\n")
                .codes(),
            "E391");
  EXPECT_EQ(Reading(folder, k_square + "$PARAMETER\n a = 1\n b = 1\n"
                                       "$SWEEP PARAMETER=a WITH=b\n 1 2 3\n$END\n")
                .codes(),
            "E115");
}

TEST(ReadDeck, IncludesAreLimited) {
  const Folder folder;
  for (int i = 0; i < 20; ++i) {
    folder.write("i" + std::to_string(i), "$INCLUDE FILE='i" + std::to_string(i + 1) + "'\n");
  }
  const Reading deep(folder, k_square + "$INCLUDE FILE='i0'\n$END\n");
  EXPECT_EQ(deep.codes(), "E113") << deep.messages();
  const Reading itself(folder, k_square + "$INCLUDE FILE='test.deck'\n$END\n");
  EXPECT_EQ(itself.codes(), "E113") << itself.messages();
}

TEST(ReadDeck, SixteenIncludesDeepIsDeepEnough) {
  const Folder folder;
  for (int i = 1; i < 16; ++i) {
    folder.write("i" + std::to_string(i), "$INCLUDE FILE='i" + std::to_string(i + 1) + "'\n");
  }
  folder.write("i16", "$NSET NAME=DEEP\n 1\n");
  const Reading r(folder, k_square + "$INCLUDE FILE='i1'\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  EXPECT_EQ(r.model->mesh.node_sets.at(0).name, "DEEP");
}

TEST(ReadDeck, LineEndsOfEverySystem) {
  const Folder folder;
  std::string deck =
      "\xEF\xBB\xBF! \xC3\xB6\n" + k_square + "$NSET NAME=A\n\t1\t2 ! \xE2\x88\x92\n$END\n";
  for (const std::string end : {"\r\n", "\r", "\n"}) {
    std::string text;
    for (const char c : deck) {
      text += c == '\n' ? end : std::string(1, c);
    }
    const Reading r(folder, text);
    ASSERT_TRUE(r.model) << r.messages();
    EXPECT_EQ(r.model->mesh.node_sets.at(0).nodes.size(), 2U);
  }
}

TEST(ReadDeck, DevicesAndLongNamesAreNoFiles) {
  const Folder folder;
  const Reading device(folder, k_square + "$INCLUDE FILE='/dev/zero'\n$END\n");
  EXPECT_EQ(device.codes(), "E113") << device.messages();
  const std::string name(5000, 'a');
  const Reading longer(folder, k_square + "$INCLUDE FILE='" + name + "'\n$END\n");
  EXPECT_EQ(longer.codes(), "E113") << longer.messages();
  const Reading mesh(folder, k_square + "$IMPORT FILE='" + name + "' FORMAT=MSH\n$END\n");
  EXPECT_EQ(mesh.codes(), "E308") << mesh.messages();
}

TEST(ReadDeck, RangesAreAsLongAsTheNumbersThereAre) {
  const Folder folder;
  const Reading r(folder,
                  "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR DIM=2\n 1 0 0\n 2000000000 1 0\n"
                  " 9000000000000000 1 1\n 4 0 1\n"
                  "$ELEMENT TYPE=QUAM4 ESET=PLATE\n 1 1 2000000000 9000000000000000 4\n"
                  "$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n"
                  "$PROPERTY ESET=PLATE MATERIAL=STEEL STATE=STRESS\n"
                  "$NSET NAME=ALL\n 1 : 9223372036854775807\n"
                  "$NSET NAME=EVEN\n 2 : 9223372036854775807 : 2\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  EXPECT_EQ(r.model->mesh.node_sets.at(0).nodes.size(), 4U);
  std::vector<base::Label> even;
  for (const base::NodeId n : r.model->mesh.node_sets.at(1).nodes) {
    even.push_back(r.model->mesh.node_label[n.index()]);
  }
  EXPECT_EQ(even, (std::vector<base::Label>{4, 2000000000, 9000000000000000}));
}

TEST(ReadDeck, MeshesTooLargeAreRefused) {
  const Folder folder;
  const auto codes = [&](const std::string& keys) {
    return Reading(folder, k_square + "$NET NAME=A\n$MESH " + keys + "\n$ENDNET\n$END\n").codes();
  };
  EXPECT_EQ(codes("SHAPE=BLOCK TYPE=QUAMC8 LX=1 LY=1 NX=1000000 NY=1000000"), "E321");
  EXPECT_EQ(codes("SHAPE=RING TYPE=QUAM4 RI=0 RO=1 NT=1000000"), "E321"); // the core of the disc
  EXPECT_EQ(codes("SHAPE=LUG TYPE=QUAM4 RI=1 W=4 L=1e12"), "E321");       // the shank
}

TEST(ReadDeck, NetsQualifyNames) {
  const Folder folder;
  const std::string ring = " SHAPE=RING TYPE=QUAMC8 NR=1 NT=8 ";
  const Reading r(folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n$MATERIAL NAME=M E=1 NU=0\n"
                          "$NET NAME=HUB\n$MESH" +
                              ring +
                              "RI=2 RO=3\n"
                              "$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN\n$ENDNET\n"
                              "$NET NAME=PIN\n$MESH" +
                              ring +
                              "RI=1 RO=2\n$ENDNET\n"
                              "$PROPERTY ESET=PIN.BODY MATERIAL=M STATE=STRESS\n"
                              "$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER GAP=0\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  const model::Model& m = *r.model;
  EXPECT_EQ(m.mesh.set_with_id(m.contacts[0].slave).name, "PIN.OUTER");
  EXPECT_EQ(m.mesh.set_with_id(m.contacts[0].master).name, "HUB.INNER");
  EXPECT_EQ(m.element_property(m.mesh, base::ElementId(0)).state, model::StressState::plane_strain);
}

TEST(ReadDeck, WhatHasNoAnalysisIsNotedNotIgnored) {
  const Folder folder;
  const Reading r(folder, k_square + "$RIGID NAME=WALL SHAPE=LINE X0=0 Y0=0 X1=1 Y1=0\n"
                                     "$FSET NAME=TOP WHERE=(y == 1)\n"
                                     "$CONTACT NAME=C SLAVE=TOP MASTER=WALL MU=0.1\n"
                                     "$STEP NAME=S\n DISMOUNT C\n"
                                     "$CONTROL TOL=1e-9\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  std::vector<std::string> what;
  for (const model::UnimplementedAnalysis& u : r.model->unavailable) {
    what.push_back(u.what);
    EXPECT_TRUE(u.span.valid());
  }
  EXPECT_EQ(what, (std::vector<std::string>{"$CONTROL TOL"}));
}

TEST(ReadDeck, ANameDefinedTwiceDoesNotShiftThoseBehindIt) {
  const Folder folder;
  const std::string line = " SHAPE=LINE X0=0 Y0=1 X1=1 Y1=1\n";
  // Were the second WALL counted, BACK would be taken for FLAT, a target of solids, and FLAT for
  // none.
  for (const std::string target : {"BACK", "WALL"}) {
    const Reading r(folder, k_square + "$RIGID NAME=WALL" + line + "$RIGID NAME=WALL" + line +
                                "$RIGID NAME=BACK" + line +
                                "$RIGID NAME=FLAT SHAPE=PLANE X0=0 Y0=0 Z0=0 X1=0 Y1=0 Z1=1\n"
                                "$FSET NAME=TOP WHERE=(y == 1)\n"
                                "$CONTACT NAME=C SLAVE=TOP MASTER=" +
                                target + "\n$END\n");
    EXPECT_EQ(r.codes(), "E302") << r.messages();
  }
}

TEST(ReadDeck, LoadValuesAndPrescribedFreedoms) {
  const Folder folder;
  const auto read = [&](const std::string& load) {
    return Reading(folder, k_square +
                               "$NSET NAME=A\n 1 2\n$NSET NAME=B\n 3\n"
                               "$FREEDOM CLASS=PRESCRIBED DOF=X\n A\n$LOAD CASE=C TYPE=" +
                               load + "\n$END\n");
  };
  const Reading one = read("DISP\n A 1");
  ASSERT_TRUE(one.model) << one.messages();
  EXPECT_EQ(one.model->cases[0].loads[0].value.size(), 2U); // what is left out is zero
  EXPECT_EQ(read("DISP\n A 1 1").codes(), "E319");
  EXPECT_EQ(read("DISP\n B 1 0").codes(), "E319");
  EXPECT_EQ(read("DISP\n A 1 0 0").codes(), "E312");
  EXPECT_EQ(read("FORCE\n A").codes(), "E312");
  EXPECT_EQ(read("PRESSURE\n A 1 2").codes(), "E312");
  EXPECT_EQ(read("PRESSURE\n B 1").codes(), "E311");
  EXPECT_EQ(read("TRACTION\n A 1[N]").codes(), "E205");
  EXPECT_EQ(read("BODY\n A 1").codes(), "E301");
  EXPECT_EQ(read("RESULTANT\n PLATE 1[kN]").codes(), "");
}

TEST(ReadDeck, AFreeCrackOfOnePointAndGrowth) {
  const Folder folder;
  const Reading r(folder, k_square + "$CRACK NAME=C ANGLE=90[deg] A0=0.2\n 0.5 0\n"
                                     "$TIPNET CRACK=C RADIUS=0.05 PATCH=YES\n"
                                     "$VCE CRACK=C DOMAINS=1,2,3\n"
                                     "$STEP NAME=S\n$GROW LAW=INCREMENT KMAX=S CRACKS=C\n"
                                     " 0.2 (0.1*3)\n 0.4\n"
                                     "$CHECK\n K1(C.2, S, (0.1*3)) = 1 ABS 1\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  const model::Model& m = *r.model;
  EXPECT_EQ(m.cracks.at(0).kind, model::CrackDefinitionKind::free);
  EXPECT_EQ(m.cracks[0].points.size(), 1U);
  EXPECT_DOUBLE_EQ(*m.cracks[0].angle, 1.5707963267948966);
  EXPECT_EQ(m.vces.at(0).domains, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(m.growth->lengths.size(), 3U);
  EXPECT_EQ(std::get<std::string>(m.checks.at(0).arguments.at(0)), "C.2");
}

TEST(ReadDeck, ATipMeshWhoseSizesTheDeckGives) {
  const Folder folder;
  const auto sizes_are_given = [&](const std::string& keys) {
    const Reading r(folder, k_square +
                                "$CRACK NAME=C ANGLE=90[deg] A0=0.2\n 0.5 0\n$TIPNET CRACK=C" +
                                keys + "\n$STEP NAME=S\n$END\n");
    EXPECT_TRUE(r.model) << r.messages();
    return r.model && r.model->tip_nets.at(0).sizes_given;
  };
  EXPECT_FALSE(sizes_are_given(" RADIUS=0.05 FINER=2"));
  EXPECT_TRUE(sizes_are_given(" RINGS=5")); // the usual number, but the deck's own
  EXPECT_TRUE(sizes_are_given(" SECTORS=24"));
  EXPECT_TRUE(sizes_are_given(" SIZE=0.01"));
}

TEST(ReadDeck, ChecksAtAPoint) {
  const Folder folder;
  const auto arguments = [&](const std::string& quantity) {
    const Reading r(folder,
                    k_square + "$PARAMETER\n h = 2\n p = 3\n$STEP NAME=S\n$STEP NAME=P\n$CHECK\n " +
                        quantity + " = 1 ABS 1\n$END\n");
    EXPECT_TRUE(r.model) << r.messages();
    return r.model ? r.model->checks.at(0).arguments.size() : 0;
  };
  EXPECT_EQ(arguments("U.X.AT(1, h/2, S)"), 3U);
  EXPECT_EQ(arguments("U.X.AT(1, 2, h, S)"), 4U);
  EXPECT_EQ(arguments("U.X.AT(1, 2, S, 0.5)"), 4U);
  EXPECT_EQ(arguments("U.X.AT(1, 2, 3, S, 0.5)"), 5U);
  EXPECT_EQ(arguments("U.X.AT(1, 2, P)"), 3U); // a step with the name of a parameter
  EXPECT_EQ(arguments("U.X.AT(1, 2, P, S)"), 4U);
}

TEST(ReadDeck, ADeckThatCannotBeReadThrows) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  EXPECT_THROW(read_deck("/nowhere/at/all.deck", {}, sources, diagnostics), std::system_error);
  EXPECT_THROW(read_deck("/", {}, sources, diagnostics), std::system_error);
}

} // namespace
} // namespace spricka::deck::test_read_deck
