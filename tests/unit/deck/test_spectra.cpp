// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"

#include <cmath>

#include <gtest/gtest.h>

/// $SPECTRUM: columns of files, loads in units of the deck, flights, CLIP and OMIT, TWIST.
namespace spricka::deck::test_spectra {
namespace {

// A deck with one spectrum on a path from 0 to 1.5.
std::string with_spectrum(const std::string& card) {
  return k_square + "$STEP NAME=S\n$STEP NAME=T\n$LOADPATH NAME=UP FROM=S TO=T BEYOND=1.5\n" +
         card + "\n$END\n";
}

model::SpectrumDefinition spectrum_of(const Reading& r) {
  EXPECT_TRUE(r.model) << r.messages();
  return r.model && !r.model->spectra.empty() ? r.model->spectra.front()
                                              : model::SpectrumDefinition();
}

TEST(Spectra, ColumnsInAnyOrder) {
  const std::vector<std::pair<std::string, std::string>> same{
      {"MAX,MIN,COUNT", "90 30 7"},
      {"SKIP,VALLEY,PEAK,CYCLES", "1 30 90 7"},
      {"COUNT,MEAN,AMPLITUDE", "7 60 30"},
      {"RANGE,MEAN,COUNT", "60;60;7"},
      {"MAX,RATIO,COUNT", "90,0.3333333333333333,7"},
      {"AMPLITUDE,RATIO,COUNT", "30 0.3333333333333333 7"},
      {"LOW,RANGE,COUNT,SKIP", "30 60 7 1e9"}};
  for (const auto& [order, line] : same) {
    const Folder folder;
    folder.write("a.txt", "a header 12\n" + line + " % behind\n");
    const Reading r(folder,
                    with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=BLOCKS FILE='a.txt' SKIP=1 "
                                  "COMMENT='%' FACTOR=0.01 ORDER=" +
                                  order));
    const model::SpectrumDefinition found = spectrum_of(r);
    ASSERT_EQ(found.cycles.size(), 1U) << order;
    EXPECT_NEAR(found.cycles[0][0], 0.3, 1e-12) << order;
    EXPECT_NEAR(found.cycles[0][1], 0.9, 1e-12) << order;
    EXPECT_EQ(found.cycles[0][2], 7.0) << order;
  }
}

TEST(Spectra, ASequenceOfColumns) {
  const Folder folder;
  folder.write("a.txt", "0 0.1\n1 0.9\n2 0.2\n3 0.7\n");
  const Reading timed(
      folder,
      with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=SEQUENCE ORDER=SKIP,VALUE FILE='a.txt'"));
  EXPECT_EQ(spectrum_of(timed).turning_points, (std::vector<double>{0.1, 0.9, 0.2, 0.7}));
  EXPECT_EQ(timed.messages().find("W369"), std::string::npos);
  folder.write("b.txt", "0.9 0.1 2\n0.7 0.2 1\n");
  const Reading counted(
      folder,
      with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=SEQUENCE ORDER=MAX,MIN,COUNT FILE='b.txt'"));
  EXPECT_EQ(spectrum_of(counted).turning_points,
            (std::vector<double>{0.9, 0.1, 0.9, 0.1, 0.7, 0.2}));
}

TEST(Spectra, LoadsInUnitsOfTheirOwn) {
  const Folder folder;
  const Reading r(folder,
                  with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=BLOCKS AT0=-50[MPa] AT1=150[MPa] "
                                "VALUES='ksi' CLIP=250[MPa]\n"
                                "  0 14.503773773020923 3\n"));
  const model::SpectrumDefinition found = spectrum_of(r);
  ASSERT_EQ(found.cycles.size(), 1U);
  EXPECT_NEAR(found.cycles[0][0], 0.25, 1e-12);
  EXPECT_NEAR(found.cycles[0][1], 0.75, 1e-12);
  ASSERT_TRUE(found.values && found.clip);
  EXPECT_EQ(found.values->unit, "ksi");
  EXPECT_NEAR(found.values->value_at(1.0), 150.0 / 6.894757293168361, 1e-9);
  EXPECT_NEAR(*found.clip, 1.5, 1e-12);

  const Reading deck_units(
      folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=SEQUENCE AT0=0 AT1=200[MPa] FACTOR=2 "
                            "OFFSET=-10\n  5 105\n"));
  const model::SpectrumDefinition own = spectrum_of(deck_units);
  ASSERT_EQ(own.turning_points.size(), 2U);
  EXPECT_NEAR(own.turning_points[0], 0.0, 1e-15);
  EXPECT_NEAR(own.turning_points[1], 1.0, 1e-15);
  ASSERT_TRUE(own.values);
  EXPECT_EQ(own.values->unit, "MPa");
}

TEST(Spectra, FlightsAreMarkedOrGiven) {
  using model::SpectrumLifeUnit;
  const Folder folder;
  folder.write("a.txt", "FLIGHT 1\n0 1\n0.5\nFLIGHT 2\n 0 0.9\n");
  const model::SpectrumDefinition marked = spectrum_of(Reading(
      folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=SEQUENCE FILE='a.txt' MARK='FLIGHT'")));
  EXPECT_EQ(marked.turning_points.size(), 5U);
  EXPECT_EQ(marked.life_unit, SpectrumLifeUnit::flights);
  EXPECT_EQ(marked.life_units_per_pass, 2.0);
  const auto unit = [&](const std::string& keys) {
    const model::SpectrumDefinition found = spectrum_of(Reading(
        folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=BLOCKS " + keys + "\n 0 1 5\n")));
    return std::pair(found.life_unit, found.life_units_per_pass);
  };
  EXPECT_EQ(unit("FLIGHTS=40"), std::pair(SpectrumLifeUnit::flights, 40.0));
  EXPECT_EQ(unit("FLIGHTS=40 HOURS=100 UNIT=HOURS"), std::pair(SpectrumLifeUnit::hours, 100.0));
  EXPECT_EQ(unit("HOURS=100"), std::pair(SpectrumLifeUnit::hours, 100.0));
  EXPECT_EQ(unit("FLIGHTS=40 UNIT=PASSES"), std::pair(SpectrumLifeUnit::passes, 1.0));
  EXPECT_EQ(unit("UNIT=CYCLES").first, SpectrumLifeUnit::cycles);
}

TEST(Spectra, LevelsAreCutAndSmallRangesLeftOut) {
  const Folder folder;
  const model::SpectrumDefinition found = spectrum_of(
      Reading(folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=SEQUENCE CLIP=1.2 OMIT=0.15\n"
                                    "  0 1.4 0.6 0.7 0.2 1.3 0.3 1\n")));
  EXPECT_EQ(found.turning_points, (std::vector<double>{0.0, 1.2, 0.2, 1.2, 0.3, 1.0}));
  ASSERT_TRUE(found.unreduced);
  EXPECT_EQ(found.unreduced->turning_points.size(), 8U);
  const model::SpectrumDefinition blocks = spectrum_of(
      Reading(folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=BLOCKS OMIT=50 AT0=0 AT1=100\n"
                                    "  10 130 1\n  60 100 500\n")));
  EXPECT_EQ(blocks.cycles.size(), 1U);
  EXPECT_EQ(blocks.unreduced->cycles.size(), 2U);
}

TEST(Spectra, TwistByItsTable) {
  const Folder folder;
  const model::SpectrumDefinition twist = spectrum_of(Reading(
      folder, with_spectrum("$SPECTRUM NAME=A PATH=UP TYPE=TWIST AT0=-52 AT1=104 VALUES='MPa' "
                            "MEAN=52[MPa] LOWEST=IX COUNT=PAIRS")));
  ASSERT_EQ(twist.turning_points.size(), 84422U);
  EXPECT_NEAR(twist.turning_points[0], 26.0 / 156.0, 1e-12);
  EXPECT_NEAR(twist.turning_points[1], (1.375 * 52.0 + 52.0) / 156.0, 1e-12);
  EXPECT_EQ(twist.life_units_per_pass, 4000.0);
  EXPECT_NE(twist.origin.find("not the standard's sequence"), std::string::npos);
}

TEST(Spectra, MistakesHaveAPlace) {
  const Folder folder;
  folder.write("a.txt", "low high\n0 1 5\n");
  folder.write("b.txt", "0 1 5\n0 1\n");
  const auto codes = [&](const std::string& card) {
    const Reading r(folder, with_spectrum("$SPECTRUM NAME=A PATH=UP " + card));
    return r.codes();
  };
  EXPECT_EQ(codes("TYPE=BLOCKS FILE='a.txt'"), "E115"); // a header
  EXPECT_EQ(codes("TYPE=BLOCKS FILE='b.txt' ORDER=MIN,MAX,COUNT"), "E115");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=MIN,COUNT\n 0 1"), "E110");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=AMPLITUDE,RANGE\n 0 1"), "E110");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=VALUE\n 0"), "E110");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=MIN,MAXI\n 0 1"), "E108");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=MAX,RATIO\n 1 0.5\n 1 1"), "");
  EXPECT_EQ(codes("TYPE=BLOCKS ORDER=RANGE,RATIO\n 0.5 0.5\n 0.5 1"), "E115");
  EXPECT_EQ(codes("TYPE=BLOCKS AT0=0 AT1=0\n 0 1 1"), "E109");
  EXPECT_EQ(codes("TYPE=BLOCKS AT0=0\n 0 1 1"), "E106");
  EXPECT_EQ(codes("TYPE=BLOCKS AT0=0 AT1=100[N] VALUES='MPa'\n 0 100 1"), "E205");
  EXPECT_EQ(codes("TYPE=BLOCKS CLIP=100[MPa]\n 0 1 1"), "E205");
  EXPECT_EQ(codes("TYPE=BLOCKS UNIT=FLIGHTS\n 0 1 1"), "E106");
  EXPECT_EQ(codes("TYPE=BLOCKS OMIT=2\n 0 1 1"), "E325");
  EXPECT_EQ(codes("TYPE=BLOCKS AT0=0 AT1=100\n 0 180 1"), "E325");
  EXPECT_EQ(codes("TYPE=BLOCKS SKIP=1\n 0 1 1"), "E106");
  EXPECT_EQ(codes("TYPE=TWIST MEAN=0.5"), "E325"); // its ground lies below the path
  EXPECT_EQ(codes("TYPE=TWIST MEAN=0.5 HIGHEST=V LOWEST=II"), "E109");
  EXPECT_EQ(codes("TYPE=SEQUENCE ORDER=MIN,MAX,COUNT\n 0 1 2.5\n 0 1 2"), "E109");
}

} // namespace
} // namespace spricka::deck::test_spectra
