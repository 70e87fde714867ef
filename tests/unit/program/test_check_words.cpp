// SPDX-License-Identifier: GPL-3.0-or-later
// The words of $CHECK in the catalogue and the quantities that the results have agree.
#include "grammar/catalogue.hpp"
#include "program/checks/check_quantities.hpp"
#include "results/contact_result.hpp"
#include "results/tip_result.hpp"

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
  const grammar::ResultQuantity* const listed = grammar::find_quantity(word);
  ASSERT_NE(listed, nullptr) << word << " is no word of grammar/catalogue.cpp";
  EXPECT_EQ(listed->quantity, q.kind) << word;
  EXPECT_EQ(listed->doc, q.doc) << word;
  EXPECT_EQ(listed->arguments, arguments) << word;
}

TEST(CheckWords, OfTipsAndContactsSayTheSameInTheCatalogue) {
  for (const results::TipQuantity& q : results::tip_quantities) {
    if (q.appears_in(results::in_check)) {
      expect_in_catalogue(q.check_word(), q, "cs?aa");
    }
  }
  for (const results::ContactQuantity& q : results::contact_quantities) {
    if (!q.check.empty()) {
      expect_in_catalogue(std::string(q.check), q, "ps?a");
    }
  }
}

} // namespace
} // namespace spricka::program::test_check_words
