// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/dimension_rules.hpp"
#include "deck/number_file.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

/// Numbers of a line and the place for messages about it.
struct DeckTestReading {
  double first = 0.0, second = 0.0;
  std::optional<double> third = {};
  base::SourceSpan span;
  std::string where; ///< "line 17 of 'f.txt': "; empty: the span says it
};

class TestReader {
public:
  TestReader(DeckContext& c, const CheckedCard& card) : c_(c), card_(card) {}

  void read() {
    test_.name = card_.word_value("NAME");
    test_.method = card_.key_has_word("METHOD", "SECANT")   ? model::TestRateMethod::secant
                   : card_.key_has_word("METHOD", "E647")   ? model::TestRateMethod::e647
                   : card_.key_has_word("METHOD", "SPLINE") ? model::TestRateMethod::spline
                                                            : model::TestRateMethod::polynomial;
    test_.window = card_.integer_value("POINTS");
    test_.ratio = card_.optional_number("RATIO");
    test_.reference.k_unit = c_.key_unit_factor(card_, "KUNIT");
    test_.reference.a_unit = c_.key_unit_factor(card_, "AUNIT");
    test_.on_c = card_.key_has_word("AXIS", "C");
    test_.span = card_.span;
    if (const NameDefinition* crack =
            find_referenced_definition(c_, EntityKind::crack, card_.name_reference("CRACK"));
        crack != nullptr && crack->index < c_.model.cracks.size()) { // else its card is wrong
      test_.crack = base::CrackId(crack->index);
    }
    if (test_.window % 2 == 0) {
      wrong({.span = card_.find("POINTS")->span, .where = {}}, "E109",
            fmt::format("POINTS: {} is even: a parabola has its reading in the middle",
                        test_.window));
    }
    rows();
    file("FILE", most_lengths() + 1, [this](const DeckTestReading& line) { reading(line); });
    file("REFERENCE", 2, [this](const DeckTestReading& pair) { rate(pair); });
    if (good_ && !card_.rows_bad) {
      look_at_the_whole();
    }
    c_.model.tests.push_back(std::move(test_));
  }

private:
  // A crack in space has two half axes that can be read.
  [[nodiscard]] std::size_t most_lengths() const { return c_.is_certainly_plane() ? 1 : 2; }

  void rows() {
    for (const grammar::DataRow& row : card_.rows) {
      const bool of_reference = row.fields.front().is_name() && row.fields.front().text == "RATE";
      const std::string_view other = of_reference ? "REFERENCE" : "FILE";
      const std::size_t first = of_reference ? 1 : 0;
      const std::size_t count = row.fields.size() - first;
      const std::size_t most = of_reference ? 2 : most_lengths() + 1;
      if (count < 2 || count > most) {
        wrong({.span = row.span, .where = {}}, "E115",
              fmt::format("a line is N a{}, or RATE delta_K da/dN",
                          most_lengths() > 1 ? " [c]" : ""));
        continue;
      }
      if (card_.has_key(other)) {
        wrong({.span = row.span, .where = {}}, "E115",
              fmt::format("with {} there are no such data lines", other));
        return;
      }
      const auto x = c_.read_number(row.fields[first], grammar::QuantityKind::number,
                                    of_reference ? "a range of K" : "a number of cycles");
      const auto y = c_.read_number(row.fields[first + 1],
                                    of_reference ? grammar::QuantityKind::number
                                                 : grammar::QuantityKind::length,
                                    of_reference ? "a growth per cycle" : "a crack length");
      const auto third = count < 3 ? std::optional<double>()
                                   : c_.read_number(row.fields[first + 2],
                                                    grammar::QuantityKind::length, "a half axis");
      const bool sound = x && y && third.has_value() == (count == 3);
      good_ = good_ && sound;
      if (sound) {
        const DeckTestReading line{*x, *y, third, row.span, {}};
        of_reference ? rate(line) : reading(line);
      }
    }
  }

  template <class Take> void file(std::string_view key, std::size_t most, Take&& take) {
    if (!card_.has_key(key)) {
      return;
    }
    const auto lines = read_number_file(c_, card_, key);
    good_ = good_ && lines.has_value();
    for (std::size_t i = 0; good_ && i < lines->size(); ++i) {
      const NumberLine& line = (*lines)[i];
      const std::size_t count = line.numbers.size();
      if (!line.sound || count < 2 || count > most) {
        wrong({.span = line.span, .where = line.where}, "E115",
              most > 2 ? "a line holds two numbers or three" : "a line holds two numbers");
      } else {
        const auto third = count > 2 ? std::optional(line.numbers[2]) : std::nullopt;
        take(DeckTestReading{line.numbers[0], line.numbers[1], third, line.span, line.where});
      }
    }
  }

  void reading(const DeckTestReading& line) {
    const bool both = line.third.has_value();
    const double least = both ? std::min(line.second, *line.third) : line.second;
    if (!test_.readings.empty() && line.first <= test_.readings.back()[0]) {
      wrong(line, "E109",
            fmt::format("{} cycles do not come after {}", line.first, test_.readings.back()[0]));
    } else if (least <= 0.0) {
      wrong(line, "E109", fmt::format("{} is no crack length: it is positive", least));
    } else if (!test_.readings.empty() && both == test_.other.empty()) {
      wrong(line, "E109", "either all lines have both half axes, or none");
    } else {
      // A length alone is that of AXIS.
      const bool second = both && test_.on_c;
      test_.readings.push_back({line.first, second ? *line.third : line.second});
      if (both) {
        test_.other.push_back(second ? line.second : *line.third);
      }
    }
  }

  void rate(const DeckTestReading& pair) {
    const double last_k = test_.reference.delta_k.empty() ? 0.0 : test_.reference.delta_k.back();
    const double last_rate = test_.reference.growth.empty() ? 0.0 : test_.reference.growth.back();
    if (pair.first <= last_k || pair.second <= last_rate) {
      wrong(pair, "E109", "delta_K and da/dN of a reference are positive and grow line by line");
    } else {
      test_.reference.delta_k.push_back(pair.first);
      test_.reference.growth.push_back(pair.second);
    }
  }

  void look_at_the_whole() {
    const auto lacks = [this](const std::string& text, std::string hint) {
      c_.error(card_.span, "E326", fmt::format("$TEST {}: {}", test_.name, text), std::move(hint));
    };
    const std::size_t needed = model::readings_needed(test_.method, test_.window);
    if (test_.readings.size() < needed) {
      lacks(fmt::format("{} readings, METHOD={} needs {}", test_.readings.size(),
                        card_.word_value("METHOD"), needed),
            "data lines N a, or FILE");
    }
    if (test_.reference.delta_k.size() == 1) {
      lacks("a reference has two or more rates", "RATE delta_K da/dN");
    }
    const bool units = card_.has_key("KUNIT") || card_.has_key("AUNIT");
    if (units && test_.reference.delta_k.empty()) {
      lacks("KUNIT and AUNIT are those of RATE and REFERENCE, and there is neither",
            "$GROW has units for its own law");
    }
    if (!test_.reference.delta_k.empty() && !(card_.has_key("KUNIT") && card_.has_key("AUNIT"))) {
      lacks(fmt::format("{} is not given: the rates of a reference have units",
                        card_.has_key("KUNIT") ? "AUNIT" : "KUNIT"),
            "KUNIT='MPa*m^0.5' AUNIT='m/cycle', or those of the reference");
    }
    look_at_the_crack(lacks);
    if (!c_.has_bad_card("GROW")) {
      look_at_the_growth(lacks);
    }
  }

  template <class Lacks> void look_at_the_crack(Lacks&& lacks) {
    if (c_.is_certainly_plane() && card_.has_key("AXIS")) {
      lacks("AXIS is of a crack in space", "in the plane a crack has one length");
    }
    if (dimension_rules.at(c_.model.mesh.dim).ends_in_fronts && test_.crack.valid() &&
        c_.model.cracks[test_.crack.index()].kind != model::CrackDefinitionKind::ellipse) {
      lacks(fmt::format("{} has no half axes to read", c_.model.cracks[test_.crack.index()].name),
            "in space tests are of cracks with A and C");
    }
  }

  template <class Lacks> void look_at_the_growth(Lacks&& lacks) {
    const std::optional<model::CrackGrowthSettings>& growth = c_.model.growth;
    if (!growth || !growth->kmax.valid()) {
      lacks("K is compared over crack lengths, at the step KMAX of $GROW",
            "$GROW LAW=INCREMENT KMAX=.. KMIN=.. with the lengths of the test");
      return;
    }
    if (!growth->kmin.valid() && !test_.ratio) {
      lacks("K_min/K_max is not known", "KMIN in $GROW, or RATIO here");
    }
    if (test_.reference.delta_k.empty() && growth->law == model::CrackGrowthLaw::increment) {
      lacks("$GROW has no law that could be the reference",
            "lines RATE delta_K da/dN, or REFERENCE");
    }
  }

  void wrong(const DeckTestReading& place, const char* code, const std::string& text) {
    c_.error(place.span, code, place.where + text);
    good_ = false;
  }

  DeckContext& c_;
  const CheckedCard& card_;
  model::GrowthTestReadings test_;
  bool good_ = true;
};

} // namespace

void build_growth_tests(DeckContext& context) {
  context.for_each_sound_card("TEST",
                              [&](const CheckedCard& card) { TestReader(context, card).read(); });
}

} // namespace spricka::deck
