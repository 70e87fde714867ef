// SPDX-License-Identifier: GPL-3.0-or-later
// The words of $CHECK in the catalogue and the quantities that the results have agree.
#include "grammar/catalogue.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "results/contact_result.hpp"
#include "results/k_quantities.hpp"
#include "results/results.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::program::test_check_words {
namespace {

TEST(CheckWords, AllOfTheCatalogueAreAvailable) {
  for (const grammar::ResultQuantity& word : grammar::result_quantities()) {
    EXPECT_TRUE(is_checkable_quantity(word.name)) << word.name;
  }
  EXPECT_FALSE(is_checkable_quantity("NONSENSE"));
}

template <class Quantity>
void expect_in_catalogue(const std::string& word, const Quantity& q, std::string_view arguments) {
  const grammar::ResultQuantity* const listed = grammar::find_result_quantity(word);
  ASSERT_NE(listed, nullptr) << word << " is no word of grammar/catalogue.cpp";
  EXPECT_EQ(listed->quantity, q.kind) << word;
  EXPECT_EQ(listed->doc, q.doc) << word;
  EXPECT_EQ(listed->arguments, arguments) << word;
}

TEST(CheckWords, OfTipsAndContactsSayTheSameInTheCatalogue) {
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_check, 2)) {
      expect_in_catalogue(q.check_word(), q, "cs?aa");
    }
  }
  for (const results::ContactQuantity& q : results::contact_quantities) {
    if (!q.check.empty()) {
      expect_in_catalogue(std::string(q.check), q, "ps?a");
    }
  }
}

// What is checked of fronts in space has its places in the catalogue, and nothing else has.
TEST(CheckWords, OfFrontsAreInTheCatalogueByTheirPlaces) {
  for (const results::KQuantity& q : results::k_quantities) {
    for (const char* place : {".AT", ".PHI", ".MIN", ".MAX"}) {
      const std::string word = q.check_word() + place;
      const grammar::ResultQuantity* const listed = grammar::find_result_quantity(word);
      ASSERT_EQ(listed != nullptr, q.appears_in(results::in_check, 3)) << word;
      if (listed != nullptr) {
        EXPECT_EQ(listed->quantity, q.kind) << word;
      }
    }
  }
}

// Every front has the derivatives by the axes of both ellipses; asked for are those of its own.
TEST(CheckWords, DerivativesByAnAxisAreOfTheCrackThatIsNamed) {
  model::Model model;
  results::RunResult run;
  results::LoadStepResult& step = run.increments.emplace_back().steps.emplace_back();
  step.step = "PULL";
  for (const char* crack : {"C1", "C2.1"}) {
    results::FrontResult& front = step.fronts.emplace_back();
    front.name = crack;
    front.length = 1.0;
    for (const double x : {0.0, 1.0}) {
      results::FrontPointResult& point = front.points.emplace_back();
      point.x = {x, 0.0, 0.0};
      point.s = x;
    }
    for (const auto& [cause, slope] : {std::pair("C1", 10.0), std::pair("C2", 20.0)}) {
      results::Sensitivity& by = front.sensitivities.by_parameter.emplace_back();
      by.cause = results::SensitivityParameter::length;
      by.name = cause;
      by.value = 2.0;
      by.below = by.above = {{slope, 0.0, 0.0}, {slope, 0.0, 0.0}};
    }
  }
  for (const char* crack : {"C1", "C2"}) {
    model::ResultCheck& check = model.checks.emplace_back();
    check.quantity = "DK1.A.AT";
    check.arguments = {std::string(crack), 0.5, 0.0, 0.0, std::string("PULL")};
  }
  const std::vector<results::CheckResult> found = evaluate_checks(model, run);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].found, 20.0) << found[0].trouble;
  EXPECT_EQ(found[1].found, 40.0) << found[1].trouble;
}

} // namespace
} // namespace spricka::program::test_check_words
