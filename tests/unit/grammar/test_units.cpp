// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/tidy.hpp"
#include "base/units.hpp"

#include <gtest/gtest.h>

namespace spricka::base::test_units {
namespace {

TEST(Units, FactorsBetweenDeckUnitsAreExactWhereTheyAreDecimal) {
  const UnitSystem mm = *make_unit_system("MM", "N");
  const UnitSystem inch = *make_unit_system("in", "lbf");
  const UnitSystem metre = *make_unit_system("M", "KN");
  EXPECT_EQ(factor_to_deck_units(*parse_unit("GPa"), mm), 1000.0);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("mm"), mm), 1.0);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("um"), mm), 1e-3);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("in"), mm), 25.4);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("psi"), inch), 1.0);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("ksi"), inch), 1000.0);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("MPa"), metre), 1000.0);
  EXPECT_DOUBLE_EQ(factor_to_deck_units(*parse_unit("MPa*m^0.5"), mm), 31.622776601683793);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("N/mm^2"), mm), 1.0);
}

TEST(Units, DimensionsFollowTheExponents) {
  EXPECT_EQ(parse_unit("MPa*m^0.5")->dimension, (PhysicalDimension{-1.5, 1.0, 0.0}));
  EXPECT_EQ(parse_unit("kN/m^2")->dimension, parse_unit("psi")->dimension);
  EXPECT_EQ(parse_unit("m/m")->dimension, PhysicalDimension{});
  EXPECT_EQ(parse_unit("deg")->dimension, (PhysicalDimension{0.0, 0.0, 1.0}));
  EXPECT_EQ(parse_unit("m^-1")->dimension, (PhysicalDimension{-1.0, 0.0, 0.0}));
}

TEST(Units, RootsAreHalfPowers) {
  const UnitSystem mm = *make_unit_system("MM", "N");
  EXPECT_EQ(parse_unit("MPa*sqrt(m)")->dimension, parse_unit("MPa*m^0.5")->dimension);
  EXPECT_EQ(factor_to_deck_units(*parse_unit("MPa*sqrt(m)"), mm),
            factor_to_deck_units(*parse_unit("MPa*m^0.5"), mm));
  EXPECT_EQ(parse_unit("N/sqrt(mm)")->dimension, (PhysicalDimension{-0.5, 1.0, 0.0}));
}

// By definition: inch and pound-force in m and N, so K by hand (1 ksi sqrt(in)) and by NIST SP 811.
TEST(Units, OutputUnitsHaveTheFactorsOfTheirDefinitions) {
  const UnitSystem mm = *make_unit_system("MM", "N");
  const UnitSystem metre = *make_unit_system("M", "N");
  const auto deck_units = [](const char* unit, const UnitSystem& of) {
    return make_output_unit(unit, of)->to_deck(1.0);
  };
  const double K = 1e-6 * deck_units("ksi*sqrt(in)", metre);
  EXPECT_NEAR(K, 1.0988434941087548, 1e-15);
  EXPECT_NEAR(deck_units("MPa*sqrt(m)", mm), 31.622776601683793, 1e-14);
  EXPECT_NEAR(deck_units("ksi", mm), 6.894757293168361, 1e-15);
  EXPECT_NEAR(deck_units("kip", mm), 4448.2216152605, 1e-11);
  EXPECT_EQ(deck_units("N/mm^1.5", mm), 1.0);
  EXPECT_EQ(deck_units("m", mm), 1000.0);
  EXPECT_EQ(make_output_unit("m", mm)->from_deck(1700.0), 1.7) << "a quotient is rounded once";
  EXPECT_DOUBLE_EQ(make_output_unit("mm", metre)->from_deck(0.0051), 5.1);
  EXPECT_FALSE(make_output_unit("furlong", mm));
}

TEST(Units, OutputIsInTheDecksUnitsUnlessItChoosesOthers) {
  UnitSystem units = *make_unit_system("MM", "N");
  EXPECT_EQ(units.output_stress_intensity().name, "MPa*mm^0.5");
  EXPECT_EQ(units.output_length().from_deck(0.1), 0.1);
  EXPECT_FALSE(units.output.is_any());
  units.output.stress_intensity = make_output_unit("ksi*sqrt(in)", units);
  EXPECT_EQ(units.output_stress_intensity().name, "ksi*in^0.5") << "as print sets it";
  EXPECT_EQ(units.output_stress().name, "MPa") << "each quantity has a choice of its own";
  EXPECT_TRUE(units.output.is_any());
}

TEST(Units, ProductsOfOutputUnitsConvertAsTheirParts) {
  const UnitSystem mm = *make_unit_system("MM", "N");
  const OutputUnit inch = *make_output_unit("in", mm);
  const OutputUnit kip = *make_output_unit("kip", mm);
  EXPECT_EQ((kip / inch).name, "kip/in");
  EXPECT_NEAR((kip / inch).to_deck(1.0), 4448.2216152605 / 25.4, 1e-10);
  EXPECT_NEAR((kip * inch).from_deck(1e6), 1e6 / 4448.2216152605 / 25.4, 1e-12);
  EXPECT_EQ(raised(inch, 2).name, "in^2");
  EXPECT_NEAR(raised(inch, 2).to_deck(1.0), 645.16, 1e-12);
  EXPECT_EQ(inch.text(12.7, 4), "0.5 in");
}

// 18.8 - 15.2 is 3.6 but for rounding; pi is no short number, and what differs more stays.
TEST(Units, NumbersLoseTheRoundingOfSums) {
  EXPECT_EQ(restore_short_decimal(3.6000000000000014), 3.6);
  EXPECT_EQ(restore_short_decimal(18.8 - 15.2), 3.6);
  EXPECT_EQ(restore_short_decimal(3.14159265358979), 3.14159265358979);
  EXPECT_EQ(restore_short_decimal(3.6000000001), 3.6000000001);
  EXPECT_EQ(restore_short_decimal(0.0), 0.0);
  EXPECT_EQ(restore_short_decimal(-0.30000000000000004), -0.3);
}

TEST(Units, UnknownFormsAreRefused) {
  for (const char* text :
       {"", "foo", "sqrt(m", "sqrt(m^2)", "sqrt()", "MPa sqrt(m)", "mm^", "mm*", "*mm", "mm mm",
        "MM", "mm^1e400", "mm^nan", "^2", "mm^99", "mm/", "\xC2\xB5m"}) {
    EXPECT_FALSE(parse_unit(text)) << text;
  }
  EXPECT_FALSE(make_unit_system("cm", "N"));
  EXPECT_FALSE(make_unit_system("mm", ""));
}

TEST(Units, SystemsNameTheirStress) {
  EXPECT_EQ(make_unit_system("mm", "n")->stress_name(), "MPa");
  EXPECT_EQ(make_unit_system("in", "lbf")->stress_intensity_name(), "psi*in^0.5");
  EXPECT_EQ(make_unit_system("in", "N")->stress_name(), "N/in^2");
}

} // namespace
} // namespace spricka::base::test_units
