// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// One deck for each kind of mistake and, beside it, the messages its author should see.
namespace spricka::deck::test_diagnostics {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  return test::source_folder() + "/tests/diagnostics";
}

std::vector<std::string> corpus() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
    if (entry.path().extension() == ".deck") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, MessagesAreAsExpected) {
  fs::current_path(folder()); // so that messages name the file alone
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto model = read_deck(GetParam() + ".deck", {}, sources, diagnostics);
  const std::string wanted = read_text(GetParam() + ".expect");
  const bool wrong = wanted.find(": error E") != std::string::npos; // else warnings alone
  EXPECT_EQ(model.has_value(), !wrong);
  EXPECT_EQ(diagnostics.has_errors(), wrong);
  EXPECT_FALSE(wanted.empty());
  EXPECT_EQ(base::format_messages(sources, diagnostics), wanted);
}

INSTANTIATE_TEST_SUITE_P(Diagnostics, Corpus, testing::ValuesIn(corpus()),
                         [](const auto& deck) { return deck.param; });

TEST(Corpus, IsComplete) {
  EXPECT_GE(corpus().size(), 120U);
  for (const std::string& name : corpus()) {
    EXPECT_TRUE(fs::exists(folder() / (name + ".expect"))) << name;
  }
}

} // namespace
} // namespace spricka::deck::test_diagnostics
