// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/code_texts.hpp"
#include "tests/places.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace spricka::program::test_code_texts {
namespace {

namespace fs = std::filesystem;

// Codes that the sources name, but for the tables that document them.
std::map<std::string, fs::path> codes_in_sources() {
  static const std::regex pattern("\"([EW][0-9]{3})\"");
  std::map<std::string, fs::path> found;
  for (const char* room : {"src", "grammar"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(test::source_folder()) / room)) {
      if (entry.path().extension() != ".cpp" || entry.path().stem() == "code_texts") {
        continue;
      }
      std::ifstream in(entry.path());
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
        found.emplace((*it)[1], entry.path());
      }
    }
  }
  found.erase("E647"); // a standard of the ASTM, METHOD of $TEST
  return found;
}

TEST(ErrorCodes, EveryCodeOfTheSourcesIsDocumentedOnce) {
  std::set<std::string> documented;
  for (const CodeMeaning& code : all_message_codes()) {
    EXPECT_TRUE(documented.insert(std::string(code.code)).second) << code.code << " twice";
    EXPECT_FALSE(code.meaning.empty()) << code.code;
  }
  const auto used = codes_in_sources();
  EXPECT_GE(used.size(), 60U);
  for (const auto& [code, file] : used) {
    EXPECT_TRUE(documented.contains(code)) << code << " of " << file << " is not documented";
  }
  for (const std::string& code : documented) {
    EXPECT_TRUE(used.contains(code)) << code << " is documented but never printed";
  }
}

TEST(ErrorCodes, AdviceIsOnCodesThatExist) {
  std::size_t advised = 0;
  for (const CodeMeaning& code : all_message_codes()) {
    advised += message_code_advice(code.code).empty() ? 0U : 1U;
  }
  EXPECT_GE(advised, 50U);
  EXPECT_TRUE(message_code_advice("E999").empty());
}

} // namespace
} // namespace spricka::program::test_code_texts
