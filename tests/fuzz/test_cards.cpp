// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus.hpp"
#include "grammar/catalogue.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <variant>

#include <gtest/gtest.h>

/// Every card and key of the catalogue stands in a deck that is accepted; what has no analysis is
/// named with its place, and all of it is in the model.
namespace spricka::fuzz::test_cards {
namespace {

const Deck& deck_of(const std::string& name) {
  return *std::find_if(corpus().begin(), corpus().end(),
                       [&](const Deck& d) { return d.name == name; });
}

std::set<std::string> words_used() {
  std::set<std::string> used;
  for (const char* name : {"cards_plane", "cards_space", "import", "import_solid"}) {
    std::string word;
    for (const char c : deck_of(name).text) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '$') {
        word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      } else {
        used.insert(c == '=' ? word + "=" : word);
        word.clear();
      }
    }
  }
  return used;
}

TEST(Cards, EveryCardAndKeyIsRead) {
  const std::set<std::string> used = words_used();
  for (const grammar::CardSpec& card : grammar::card_catalogue()) {
    EXPECT_TRUE(used.contains("$" + std::string(card.name))) << card.name;
    for (const grammar::KeySpec& key : card.keys) {
      EXPECT_TRUE(used.contains(std::string(key.name) + "=")) << card.name << ' ' << key.name;
    }
  }
  for (const char* name : {"cards_plane", "cards_space", "import", "import_solid"}) {
    EXPECT_TRUE(deck_of(name).sound) << Reader().read(deck_of(name).text).messages();
  }
}

TEST(Cards, ThePlaneDeckIsInTheModel) {
  const Outcome outcome = Reader().read(deck_of("cards_plane").text);
  ASSERT_TRUE(outcome.model) << outcome.messages();
  const model::Model& m = *outcome.model;
  ASSERT_EQ(m.mpcs.size(), 3U);
  const auto& equation = std::get<model::ConstraintEquation>(m.mpcs[0]);
  EXPECT_EQ(equation.rhs, 0.5);
  ASSERT_EQ(equation.terms.size(), 3U);
  EXPECT_EQ(equation.terms[1].coefficient, -1.0);
  EXPECT_EQ(m.mesh.node_label[equation.terms[1].node.index()], 2);
  EXPECT_EQ(equation.terms[1].dof, 0);
  EXPECT_EQ(m.nets[m.mesh.node_net[equation.terms[2].node.index()].index()].name, "PLATE");
  EXPECT_EQ(equation.terms[2].dof, 1);
  const auto& transition = std::get<model::TransitionTie>(m.mpcs[1]);
  EXPECT_EQ(m.mesh.set_with_id(transition.slave).name, "SOME");
  EXPECT_EQ(m.mesh.set_with_id(transition.master).name, "PLATE.XMAX");
  EXPECT_EQ(m.mesh.set_with_id(std::get<model::RigidTie>(m.mpcs[2]).slave).nodes.size(), 4U);
  ASSERT_EQ(m.rigids.size(), 2U);
  EXPECT_EQ(m.rigids[0].second, base::Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(m.rigids[1].radius, 1.9);
  EXPECT_EQ(m.contacts[1].rigid, base::RigidId(0));
  EXPECT_EQ(m.contacts[2].rigid, base::RigidId(1));
  EXPECT_FALSE(m.contacts[2].master.valid());
  EXPECT_FALSE(m.contacts[0].rigid.valid());
}

TEST(Cards, GrowthAndRestartAreInTheModel) {
  const Outcome outcome = Reader().read(deck_of("cards_plane").text);
  ASSERT_TRUE(outcome.model) << outcome.messages();
  const model::Model& m = *outcome.model;
  const model::GrowthLawConstants& law = m.growth->constants;
  EXPECT_EQ(law.C, 2e-11);
  EXPECT_EQ(law.m, 3.1);
  EXPECT_DOUBLE_EQ(law.k_unit, std::sqrt(1000.0)); // MPa*m^0.5 in MPa*mm^0.5
  EXPECT_EQ(law.a_unit, 1000.0);                   // m in mm
  EXPECT_DOUBLE_EQ(*law.k_c, 60.0 * std::sqrt(1000.0));
  EXPECT_DOUBLE_EQ(law.threshold, 2.0 * std::sqrt(1000.0)); // in KUNIT, as all constants
  EXPECT_EQ(law.p + law.q + law.alpha + law.stress_ratio, 3.3);
  EXPECT_EQ(m.growth->largest_advance, 0.1);
  EXPECT_EQ(m.growth->last_length, 2.0);
  EXPECT_EQ(m.growth->cycles, 1e6);
  EXPECT_EQ(m.restart->write, "b.rst");
  EXPECT_EQ(m.restart->every, 2);
  EXPECT_EQ(m.cases.back().loads.size(), 1U);
  EXPECT_TRUE(m.cases[3].loads[0].faces.valid()); // FACES: those of the crack
  EXPECT_TRUE(m.cases[2].loads[0].elements.valid());
}

TEST(Cards, AStateToGoOnFromIsInTheModel) {
  const Outcome outcome = Reader().read(deck_of("import").text);
  ASSERT_TRUE(outcome.model) << outcome.messages();
  EXPECT_EQ(outcome.model->restart->read, "a.rst");
  EXPECT_EQ(outcome.model->restart->at, 3);
}

TEST(Cards, AGrowthTestIsInTheModel) {
  const Outcome outcome = Reader().read(deck_of("cards_plane").text);
  ASSERT_TRUE(outcome.model) << outcome.messages();
  ASSERT_EQ(outcome.model->tests.size(), 1U);
  const model::GrowthTestReadings& test = outcome.model->tests[0];
  EXPECT_EQ(test.method, model::TestRateMethod::e647);
  EXPECT_EQ(test.window, 5);
  ASSERT_EQ(test.readings.size(), 5U);
  EXPECT_EQ(test.readings[4][0], 400.0);
  EXPECT_EQ(test.readings[4][1], 0.96);
  EXPECT_EQ(test.reference.delta_k, (std::vector<double>{5.0, 20.0, 60.0})); // tests/fuzz/rates.inc
  EXPECT_EQ(test.reference.growth[2], 1e-5);
  EXPECT_EQ(test.ratio, 0.1);
  EXPECT_DOUBLE_EQ(test.reference.k_unit, std::sqrt(1000.0));
  EXPECT_EQ(test.reference.a_unit, 1000.0);
}

TEST(Cards, WhatHasNoAnalysisIsNamedWithItsLine) {
  const Outcome outcome = Reader().read(deck_of("cards_plane").text);
  ASSERT_TRUE(outcome.model) << outcome.messages();
  for (const model::UnimplementedAnalysis& u : outcome.model->unavailable) {
    ASSERT_TRUE(u.span.valid()) << u.what;
    const std::string line(outcome.sources.line_at(u.span.file, u.span.begin));
    const std::string card = u.what.substr(0, u.what.find(' '));
    const bool action = u.what.ends_with("DISMOUNT"); // stands in a data line
    EXPECT_NE(line.find(action ? "DISMOUNT" : card), std::string::npos) << u.what << ": " << line;
  }
}

} // namespace
} // namespace spricka::fuzz::test_cards
