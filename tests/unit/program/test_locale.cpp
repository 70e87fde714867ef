// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/run_text.hpp"

#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "model/model.hpp"

#include <array>
#include <cctype>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <map>
#include <random>

#include <fmt/format.h>

/// A comma as decimal sign in the user's locale changes nothing: neither what is read, nor what is
/// worked out, nor what is written.
namespace spricka::test_locale {
namespace {

using test::Folder;
using test::Outcome;
using test::run_text;

/// The whole process in a locale that writes 0,5; found on the machine or made in a folder.
class CommaLocale {
public:
  explicit CommaLocale(const Folder& folder) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "sv_SE.UTF-8", "fr_FR.UTF-8"}) {
      active_ = active_ || enter(name);
    }
    if (!active_) {
      const std::string made = (folder.path() / "de_DE.UTF-8").string();
      const std::string command = "localedef -i de_DE -f UTF-8 '" + made + "' > /dev/null 2>&1";
      // a warning gives exit code 1, the locale is there all the same
      [[maybe_unused]] const int code = std::system(command.c_str());
      setenv("LOCPATH", folder.path().c_str(), 1);
      active_ = enter("de_DE.UTF-8");
    }
  }
  ~CommaLocale() {
    std::locale::global(std::locale::classic());
    unsetenv("LOCPATH");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  /// Numbers of the C library and of streams have a comma now.
  [[nodiscard]] bool active() const {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%.1f", 0.5);
    return active_ && std::string(text.data()) == "0,5";
  }

private:
  static bool enter(const char* name) {
    try {
      std::locale::global(std::locale(name));
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  }
  bool active_ = false;
};

const std::string plate = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$PARAMETER
  half = 0.5*sqrt(1.21)
$NET NAME=A
  $IMPORT FILE='plate.geo' FORMAT=GEO TYPE=QUADRATIC SCALE=1.25
$ENDNET
$MATERIAL NAME=M E=1234.5 NU=0.3
$PROPERTY ESET=A.PLATE MATERIAL=M STATE=STRESS THICK=1.5
$FREEDOM CLASS=SUPPRESSED DOF=XY
  A.LEFT
$CRACK NAME=C NET=A A0=0.4375 ANGLE=(0.25*pi)
  (1.25*half) 0
$LOAD CASE=PULL TYPE=TRACTION
  A.RIGHT  (half*y) 0.125
$STEP NAME=S
  LOAD PULL 0.75
$OUTPUT FILE='u.csv' FORMAT=CSV
  U A.RIGHT
$OUTPUT FILE='u.vtu' FORMAT=VTU
  U A.PLATE
  S A.PLATE
$END
)";
const std::string geometry = R"(DefineConstant[ half = 9.5 ];
size = 0.17;
Point(1) = {0, 0, 0, size};
Point(2) = {2*half, 0, 0, size};
Point(3) = {2*half, 1.5, 0, size};
Point(4) = {0, 1.5, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Physical Surface("plate") = {1};
Physical Curve("left") = {4};
Physical Curve("right") = {2};
)";

// The files of a run by name, those left out that hold times.
std::map<std::string, std::string> results(const Folder& folder) {
  std::ofstream(folder.path() / "plate.geo", std::ios::binary) << geometry;
  const Outcome outcome = run_text(folder, plate);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "out")) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && (name.ends_with(".csv") || name.ends_with(".vtu"))) {
      files[name] = test::slurp(entry.path());
    }
  }
  return files;
}

TEST(Locale, ADecimalCommaChangesNoResult) {
  const Folder plain;
  const auto expected = results(plain);
  ASSERT_GE(expected.size(), 3U);
  const Folder folder;
  const CommaLocale comma(folder);
  if (!comma.active()) {
    GTEST_SKIP() << "no locale with a decimal comma here, and none could be made";
  }
  const auto found = results(folder);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, text] : expected) {
    EXPECT_EQ(found.at(name), text) << name;
  }
  const std::string listing = test::slurp(folder.path() / "out" / "listing.txt");
  EXPECT_NE(listing.find("1234.5"), std::string::npos);
  const auto digit = [&](std::size_t i) {
    return std::isdigit(static_cast<unsigned char>(listing[i]));
  };
  for (std::size_t i = 1; i + 1 < listing.size(); ++i) {
    EXPECT_FALSE(listing[i] == ',' && digit(i - 1) && digit(i + 1)) << listing.substr(i - 1, 40);
  }
}

TEST(Locale, CoordinatesComeBackBitwise) {
  const Folder folder;
  const CommaLocale comma(folder); // where there is none the round trip is tested all the same
  std::mt19937_64 random(7);
  std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR DIM=2\n 1 0 0\n 2 1 0\n 3 1 1\n"
                     " 4 0 1\n";
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) {
    const double mantissa = static_cast<double>(random() >> 11U) / 9007199254740992.0 - 0.5;
    values.push_back(std::ldexp(mantissa, static_cast<int>(random() % 400) - 200));
    deck += fmt::format(" {} {} {}\n", i + 5, values.back(), -values.back());
  }
  deck += "$ELEMENT TYPE=QUAM4 ESET=E\n 1 1 2 3 4\n$MATERIAL NAME=M E=1 NU=0.25\n"
          "$PROPERTY ESET=E MATERIAL=M STATE=STRESS\n$END\n";
  std::ofstream(folder.path() / "round.deck", std::ios::binary) << deck;
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const auto model = deck::read_deck(folder.path() / "round.deck", {}, sources, diagnostics);
  ASSERT_TRUE(model) << base::format_messages(sources, diagnostics);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(model->mesh.x[i + 4].x(), values[i]);
    EXPECT_EQ(model->mesh.x[i + 4].y(), -values[i]);
  }
  EXPECT_EQ(model->materials[0].nu, 0.25);
}

} // namespace
} // namespace spricka::test_locale
