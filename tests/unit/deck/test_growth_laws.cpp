// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/growth_laws.hpp"
#include "deck/law_constants.hpp"
#include "deck_text.hpp"
#include "life/growth_law.hpp"
#include "tests/places.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// Growth laws by name: on $LAW, in a file beside the deck, and those that ship.
namespace spricka::deck::test_growth_laws {
namespace {

constexpr double ksi_sqrt_inch = 1.0988434941087548; // MPa m^0.5

/// A deck that could grow a crack by the law that `grow` says.
std::string deck(const std::string& grow, const std::string& more = {},
                 const std::string& units = "LENGTH=mm FORCE=N") {
  return "$DECK VERSION=1 " + units +
         "\n$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=20 NX=4 NY=8\n"
         "$NSET NAME=PATH WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
         "$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n"
         "$PROPERTY ESET=BODY MATERIAL=STEEL STATE=STRAIN\n"
         "$FREEDOM CLASS=SUPPRESSED DOF=XY\n PATH\n"
         "$CRACK NAME=C PATH=PATH A0=2\n"
         "$LOAD CASE=PULL TYPE=TRACTION\n YMAX 0 1\n"
         "$STEP NAME=FULL\n LOAD PULL 1\n$STEP NAME=NONE\n LOAD PULL 0\n" +
         more + "$GROW KMAX=FULL KMIN=NONE " + grow + "\n$END\n";
}

const std::string nasgro_constants =
    "C=0.8e-8 M=3.2 P=0.25 Q=1 DK1=1.22 CTHP=1.21 CTHM=0.1 "
    "K1C=30 YIELD=53[ksi] AK=1 BK=1.5 KUNIT='ksi*in^0.5' AUNIT='in' AINTRINSIC=0.0015[in]";

double rate_at(const model::CrackGrowthSettings& growth, double K_max, double R) {
  return life::GrowthRateLaw(growth.law, growth.constants).growth_rate(K_max, R * K_max);
}

TEST(GrowthLaws, AreTheSameByNameAndOnGrow) {
  const Folder folder;
  const Reading on_grow(folder, deck("LAW=NASGRO THICK=3 " + nasgro_constants));
  const Reading by_name(folder,
                        deck("MATERIAL=SHEET THICK=3",
                             "$LAW NAME=SHEET TYPE=NASGRO SCATTER=0.2 DKMIN=3[MPa*m^0.5] RMAX=0.7 "
                             "SOURCE='a book' FORM='sheet' ORIENTATION='L-T' THICK=2\n& " +
                                 nasgro_constants + "\n"));
  ASSERT_TRUE(on_grow.model) << on_grow.messages();
  ASSERT_TRUE(by_name.model) << by_name.messages();
  EXPECT_TRUE(by_name.diagnostics.messages().empty()) << by_name.messages();
  const model::CrackGrowthSettings& growth = *by_name.model->growth;
  for (const double R : {-1.0, 0.0, 0.5}) {
    EXPECT_EQ(rate_at(*on_grow.model->growth, 600.0, R), rate_at(growth, 600.0, R));
  }
  EXPECT_EQ(*growth.constants.k_c, *on_grow.model->growth->constants.k_c);
  EXPECT_EQ(growth.data.name, "SHEET");
  EXPECT_EQ(growth.data.source, "a book");
  EXPECT_EQ(growth.data.scatter, 0.2);
  EXPECT_EQ(growth.data.highest_ratio, 0.7);
  EXPECT_NEAR(*growth.data.lowest_delta_k, 3.0 * std::sqrt(1000.0), 1e-9);
  EXPECT_EQ(growth.data.thickness, 3.0);
}

TEST(GrowthLaws, TheThicknessOfTheLawHoldsWhereGrowHasNone) {
  const Folder folder;
  const std::string law = "$LAW NAME=SHEET TYPE=NASGRO " + nasgro_constants;
  const Reading own(folder, deck("MATERIAL=SHEET", law + " THICK=2.54\n"));
  ASSERT_TRUE(own.model) << own.messages();
  EXPECT_NEAR(*own.model->growth->constants.k_c / std::sqrt(1000.0), 81.64853456, 1e-6);
  EXPECT_EQ(Reading(folder, deck("MATERIAL=SHEET", law + "\n")).codes(), "E106");
  EXPECT_EQ(Reading(folder, deck("MATERIAL=P THICK=2", "$LAW NAME=P TYPE=PARIS C=1e-9 M=3 KC=40 "
                                                       "KUNIT='MPa*m^0.5' AUNIT='m'\n"))
                .codes(),
            "E110");
}

// A file of inches beside a deck of millimetres.
TEST(GrowthLaws, OfAFileBesideTheDeckKeepTheirUnits) {
  const Folder folder;
  folder.write("materials.deck", "$DECK VERSION=1 LENGTH=IN FORCE=LBF\n"
                                 "$LAW NAME=SHEET TYPE=NASGRO C=0.8e-8 M=3.2 P=0.25 Q=1 DK1=1.22 "
                                 "CTHP=1.21 CTHM=0.1 AINTRINSIC=0.0015 K1C=30 YIELD=53e3 AK=1 "
                                 "BK=1.5 THICK=0.1 KUNIT='ksi*in^0.5' AUNIT='in' DKMAX=40\n$END\n");
  const Reading found(folder, deck("MATERIAL=SHEET"));
  const Reading same(folder, deck("LAW=NASGRO THICK=2.54 " + nasgro_constants));
  ASSERT_TRUE(found.model) << found.messages();
  ASSERT_TRUE(same.model) << same.messages();
  const model::CrackGrowthSettings& growth = *found.model->growth;
  EXPECT_EQ(growth.data.place, "materials.deck beside the deck");
  EXPECT_NEAR(*growth.data.highest_delta_k, 40.0 * ksi_sqrt_inch * std::sqrt(1000.0), 1e-9);
  for (const double R : {-1.0, 0.0, 0.5}) {
    EXPECT_NEAR(rate_at(growth, 600.0, R) / rate_at(*same.model->growth, 600.0, R), 1.0, 1e-12);
  }
  EXPECT_NEAR(*growth.constants.k_c / *same.model->growth->constants.k_c, 1.0, 1e-12);
  EXPECT_NEAR(growth.constants.threshold_over_ratio->intrinsic_length, 0.0381, 1e-12);
}

TEST(GrowthLaws, TheDeckComesFirstAndThenTheFileBesideIt) {
  const Folder folder;
  const auto law = [](const std::string& name, const std::string& C) {
    return "$LAW NAME=" + name + " TYPE=PARIS M=3 KUNIT='MPa*m^0.5' AUNIT='m' C=" + C + "\n";
  };
  const std::string head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";
  folder.write("materials.deck",
               head + law("A", "2e-12") + law("AL2024_T3_SHEET_LT", "3e-12") + "$END\n");
  const auto C = [&](const std::string& name) {
    const Reading read(folder, deck("MATERIAL=" + name, law("A", "1e-12")));
    EXPECT_TRUE(read.model) << read.messages();
    return read.model ? read.model->growth->constants.C : 0.0;
  };
  EXPECT_EQ(C("A"), 1e-12);
  EXPECT_EQ(C("AL2024_T3_SHEET_LT"), 3e-12);
  EXPECT_EQ(C("AL7075_T651_PLATE_LT"), 0.3e-7);
}

TEST(GrowthLaws, AFileOfLawsHasNothingElse) {
  const Folder folder;
  folder.write("materials.deck", "$DECK VERSION=1 LENGTH=mm FORCE=N\n$STEP NAME=S\n$END\n");
  EXPECT_EQ(Reading(folder, deck("MATERIAL=A")).codes(), "E329");
  EXPECT_EQ(Reading(folder, deck("LAW=PARIS C=1e-12 M=3 KUNIT='MPa*m^0.5' AUNIT='m'")).codes(), "");
}

TEST(GrowthLaws, ATableOverRatiosIsReadByColumns) {
  const Folder folder;
  const Reading read(folder, deck("MATERIAL=T", "$LAW NAME=T TYPE=TABLE KUNIT='MPa*m^0.5' "
                                                "AUNIT='mm'\n RATIO 0 0.5\n 1e-7 3.3 2.1\n"
                                                " 1e-6 4.6 3.1\n"));
  ASSERT_TRUE(read.model) << read.messages();
  const model::GrowthLawConstants& law = read.model->growth->constants;
  EXPECT_EQ(law.table_ratios, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(law.growth, (std::vector<double>{1e-7, 1e-6}));
  EXPECT_EQ(law.delta_k, (std::vector<double>{3.3, 4.6, 2.1, 3.1}));
}

/// What a source says of a law that ships, and an independent program makes of it: mm, MPa m^0.5.
struct ShippedRow {
  std::string name;
  double C;              ///< [mm per cycle at 1 MPa m^0.5]
  double rate;           ///< at delta K = 10, R = 0
  double toughness;      ///< as printed
  double toughness_unit; ///< [MPa m^0.5]
  double threshold;      ///< at R = 0 of a long crack; 0: it has none
};

const std::vector<ShippedRow> shipped_rows{
    {"AL2024_T3_SHEET_LT", 1.50289628785e-07, 6.98521817e-05, 74.3, ksi_sqrt_inch, 3.2023444629},
    {"AL2024_T3_SHEET_LT_WALKER", 3.115782828e-08, 5.84207569e-05, 74.3, ksi_sqrt_inch, 0.0},
    {"AL7075_T651_PLATE_LT", 5.85240827832e-07, 1.34821860e-04, 49.9, ksi_sqrt_inch, 1.9037369513},
    {"AL7075_T651_PLATE_LT_WALKER", 2.5381958875e-07, 1.56864668e-04, 49.9, ksi_sqrt_inch, 0.0},
    {"AL7475_T7351_PLATE_LT", 7.951709778622722e-07, 1.17743200e-04, 48.2, ksi_sqrt_inch,
     2.9365508981},
    {"TI6AL4V_AC33_14", 9.25e-10, 6.857119732e-06, 64.5, 1.0, 0.0}};

bool differ(double value, double expected, double relative) {
  return !(std::abs(value - expected) <= relative * std::abs(expected));
}

/// What is wrong with a row; a law in mm and N.
std::string fault(const model::GrowthLawDefinition& law, const ShippedRow& row) {
  const double K = std::sqrt(1000.0); // one MPa m^0.5
  const model::GrowthLawConstants& c = law.constants;
  if (differ(c.C * c.a_unit * std::pow(K / c.k_unit, c.m), row.C, 1e-6)) {
    return "C in its unit";
  }
  const life::GrowthRateLaw rates(law.law, c);
  const double rate = rates.growth_rate(10.0 * K, 0.0);
  if (!(rate > 1e-6 && rate < 1e-2) || differ(rate, row.rate, 1e-6)) {
    return "rate at delta K = 10";
  }
  if (!c.k_c || std::abs(*c.k_c / K / row.toughness_unit - row.toughness) > 0.05) {
    return "toughness as printed";
  }
  const double threshold = rates.threshold(0.0) / K;
  if (std::abs(threshold - row.threshold) > 1e-6 * row.threshold) {
    return "threshold at R = 0";
  }
  if (row.threshold > 0.0) { // the other key makes the same
    model::GrowthLawConstants other = c;
    other.threshold_over_ratio->delta_k = row.threshold * K;
    other.threshold_over_ratio->at_zero_ratio = true;
    const life::GrowthRateLaw by_zero(law.law, other);
    for (const double R : {-1.0, 0.5}) {
      if (differ(by_zero.threshold(R), rates.threshold(R), 1e-6)) {
        return "threshold from DK0";
      }
    }
  }
  return law.data.source.empty() || law.data.form.empty() ? "where it is from" : "";
}

std::string shipped_text() {
  std::ifstream file(test::source_folder() + "/materials/materials.deck");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The faults of all rows of a file with this text, by the name of the row.
std::vector<std::string> faults(const std::string& text) {
  const Folder folder;
  folder.write("materials.deck", text);
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::vector<model::GrowthLawDefinition> laws =
      read_growth_law_file(folder.path / "materials.deck", {}, sources, diagnostics);
  std::vector<std::string> found;
  if (diagnostics.has_errors() || laws.size() != shipped_rows.size()) {
    found.push_back("cannot be read: " + base::format_messages(sources, diagnostics));
  }
  for (std::size_t i = 0; i < laws.size() && found.empty(); ++i) {
    EXPECT_EQ(laws[i].data.name, shipped_rows[i].name);
  }
  for (std::size_t i = 0; i < std::min(laws.size(), shipped_rows.size()); ++i) {
    if (const std::string wrong = fault(laws[i], shipped_rows[i]); !wrong.empty()) {
      found.push_back(shipped_rows[i].name + ": " + wrong);
    }
  }
  return found;
}

TEST(ShippedLaws, AreThoseOfTheirSources) {
  EXPECT_EQ(faults(shipped_text()), std::vector<std::string>());
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::filesystem::path shipped = find_shipped_growth_laws();
  ASSERT_FALSE(shipped.empty());
  EXPECT_EQ(read_growth_law_file(shipped, {}, sources, diagnostics).size(), shipped_rows.size());
  EXPECT_TRUE(diagnostics.messages().empty()) << base::format_messages(sources, diagnostics);
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

// Faults that libraries of others have.
TEST(ShippedLaws, ARowWithAnUsualFaultIsFound) {
  const std::string text = shipped_text();
  const std::vector<std::string> C{"AL2024_T3_SHEET_LT: C in its unit"};
  EXPECT_EQ(faults(with(with(text, "M=3.2 ", "M=30 "), "K1C=30 ", "K1C=3.2 ")), C);
  // the length in mm, K as it was
  const std::string in_mm = with(text, "AUNIT='in'", "AUNIT='mm'");
  EXPECT_EQ(faults(with(with(in_mm, "0.8e-8", "2.032e-7"), "ksi*in^0.5", "MPa*m^0.5")), C);
  EXPECT_EQ(faults(with(text, "DK1=1.22", "DK0=1.22")),
            std::vector<std::string>{"AL2024_T3_SHEET_LT: rate at delta K = 10"});
  EXPECT_EQ(faults(with(text, "BK=1.5 THICK=0.1", "BK=1 THICK=0.1")).size(), 1U);
  EXPECT_EQ(faults(with(text, "KC=64.5", "KC=64.5[ksi*in^0.5]")),
            std::vector<std::string>{"TI6AL4V_AC33_14: toughness as printed"});
}

} // namespace
} // namespace spricka::deck::test_growth_laws
