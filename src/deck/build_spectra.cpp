// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/number_file.hpp"
#include "deck/spectrum_columns.hpp"
#include "deck/spectrum_keys.hpp"
#include "deck/spectrum_scale.hpp"
#include "model/model.hpp"
#include "model/reduce_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

constexpr double same_place = 1e-9; // of a load path's length, as its own rows are rounded
constexpr std::size_t most_points = 20'000'000; // of a sequence

// Where a line of numbers stands.
struct LinePlace {
  base::SourceSpan span;
  std::size_t line = 0; ///< of the file; 0: the span says it
};

// The first of several columns that always ascends, evenly or for long, is a time or a number.
class TimeColumn {
public:
  void look_at(std::span<const double> numbers) {
    constexpr double even = 1e-6;
    const double first = numbers.front();
    if (lines_ == 0) {
      columns_ = numbers.size();
      first_ = first;
    } else {
      step_ = lines_ == 1 ? first - last_ : step_;
      ascends_ = ascends_ && numbers.size() == columns_ && first > last_;
      evenly_ = evenly_ && std::abs(first - last_ - step_) <= even * step_;
    }
    last_ = first;
    ++lines_;
  }
  [[nodiscard]] bool is_likely() const {
    constexpr std::size_t least = 4;
    constexpr std::size_t long_enough = 10;
    return columns_ > 1 && lines_ >= least && ascends_ && (evenly_ || lines_ >= long_enough);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("every line of the file has {} numbers, and the first of them ascends from "
                       "{:.6g} to {:.6g} like a time or a number: all of them count as loads",
                       columns_, first_, last_);
  }

private:
  std::size_t columns_ = 0, lines_ = 0;
  double first_ = 0.0, last_ = 0.0, step_ = 0.0;
  bool ascends_ = true, evenly_ = true;
};

class SpectrumReader {
public:
  SpectrumReader(DeckContext& c, const CheckedCard& card)
      : c_(c), card_(card), scale_(c, card), columns_(c, card),
        good_(scale_.sound() && columns_.sound()) {}

  void read() {
    spectrum_.name = card_.word_value("NAME");
    spectrum_.sequence = !card_.key_has_word("TYPE", "BLOCKS");
    spectrum_.counting = card_.key_has_word("COUNT", "PAIRS") ? model::CycleCounting::pairs
                                                              : model::CycleCounting::rainflow;
    spectrum_.values = scale_.values();
    spectrum_.span = card_.span;
    const NameDefinition* path =
        find_referenced_definition(c_, EntityKind::path, card_.name_reference("PATH"));
    if (path != nullptr && path->index < c_.model.load_paths.size()) {
      spectrum_.path = path->index;
      last_ = c_.model.load_paths[path->index].beyond;
    }
    if (card_.key_has_word("TYPE", "TWIST")) {
      from_twist();
    } else if (card_.has_key("FILE")) {
      from_file();
    } else {
      from_rows();
    }
    finish();
    c_.model.spectra.push_back(std::move(spectrum_));
  }

private:
  void finish() {
    if (!good_ || card_.rows_bad || off_path_) {
      return;
    }
    if (!has_cycle()) {
      c_.error(card_.span, "E325", fmt::format("spectrum {} has no cycle", spectrum_.name),
               spectrum_.sequence ? "a sequence has two or more different turning points"
                                  : "a line of TYPE=BLOCKS is low high count");
      return;
    }
    if (const auto clip = scale_.load_of_key("CLIP")) {
      spectrum_.clip = scale_.place_of_load(*clip);
    }
    if (const auto omit = scale_.load_of_key("OMIT")) {
      spectrum_.omit = scale_.range_of_loads(*omit);
    }
    model::reduce_spectrum(spectrum_);
    if (!has_cycle()) {
      c_.error(card_.has_key("OMIT") ? card_.find("OMIT")->span : card_.find("CLIP")->span, "E325",
               fmt::format("CLIP and OMIT leave no cycle of spectrum {}", spectrum_.name),
               "OMIT is a range of loads, CLIP a load, both in the unit of the loads");
      return;
    }
    set_life_unit(c_, card_, flights_, spectrum_);
  }

  void from_twist() {
    if (!card_.rows.empty()) {
      c_.error(card_.rows.front().span, "E115", "TYPE=TWIST takes no data lines");
    }
    const std::optional<model::TwistSettings> settings = read_twist_settings(c_, card_);
    good_ = good_ && settings.has_value();
    const std::optional<double> mean = scale_.load_of_key("MEAN");
    good_ = good_ && scale_.sound();
    if (!good_ || !mean) {
      return;
    }
    const model::TwistHistory twist = model::generate_twist_history(*settings);
    const LinePlace here{card_.span};
    for (const double x : twist.points) {
      if (!take_place(scale_.place_of_load(*mean * x), here)) {
        good_ = false; // one complaint is enough
        return;
      }
    }
    flights_ = twist.flights;
    spectrum_.origin = model::describe_twist_history(*settings);
  }

  void from_rows() {
    std::vector<double> numbers;
    for (const grammar::DataRow& row : card_.rows) {
      numbers.clear();
      for (const CardField& field : row.fields) {
        const auto number = c_.read_number(field, grammar::QuantityKind::number, "a load");
        good_ = good_ && number.has_value();
        numbers.push_back(number.value_or(0.0));
      }
      if (good_) {
        take(numbers, {row.span});
      }
    }
  }

  void from_file() {
    if (!card_.rows.empty()) {
      c_.error(card_.rows.front().span, "E115", "with FILE there are no data lines");
    }
    const NumberFileLayout layout{.skipped_lines =
                                      static_cast<std::size_t>(card_.integer_value("SKIP")),
                                  .comment = std::string(card_.word_value("COMMENT")),
                                  .mark = std::string(card_.word_value("MARK"))};
    const base::SourceSpan span = card_.find("FILE")->span;
    TimeColumn time;
    const auto take_row = [&](const NumberRow& row) {
      const LinePlace place{span, row.line};
      if (row.mark) {
        flights_ += 1.0;
      } else if (!row.sound) {
        wrong(place, "E115", "not a number",
              row.line <= first_lines ? "SKIP=n leaves out header lines" : "");
      } else {
        if (columns_.any_number()) {
          time.look_at(row.numbers);
        }
        take(row.numbers, place);
      }
      return good_;
    };
    const bool was_good = good_;
    const std::string file = visit_number_file(c_, card_, "FILE", layout, take_row);
    good_ = was_good && good_ && !file.empty();
    if (good_ && time.is_likely()) {
      c_.warning(span, "W369", time.text(),
                 "ORDER=SKIP,VALUE leaves the first column out; without ORDER a sequence has "
                 "nothing but loads one after another");
    }
    if (good_ && card_.has_key("MARK") && flights_ == 0.0) {
      c_.error(card_.find("MARK")->span, "E115",
               fmt::format("no line of '{}' begins with '{}'", file, card_.word_value("MARK")));
    }
  }

  void take(std::span<const double> numbers, const LinePlace& place) {
    if (!columns_.any_number() && numbers.size() != columns_.count()) {
      wrong(place, "E115",
            card_.has_key("ORDER") ? fmt::format("{} numbers, where ORDER names {} columns: {}",
                                                 numbers.size(), columns_.count(), columns_.text())
                                   : "a line of TYPE=BLOCKS is low high count");
    } else if (columns_.has_loads()) {
      loads_.clear();
      columns_.append_loads(numbers, loads_);
      for (const double load : loads_) {
        take_place(scale_.place(load), place);
      }
    } else {
      take_cycle(columns_.cycle(numbers), place);
    }
  }

  void take_cycle(std::optional<CycleOfColumns> cycle, const LinePlace& place) {
    if (!cycle) {
      wrong(place, "E115", "these two numbers make no cycle: its ends are not known");
      return;
    }
    warn_of_high_low(*cycle, place);
    if (cycle->count <= 0.0) {
      wrong(place, "E109", fmt::format("{} cycles: a count is positive", cycle->count));
      return;
    }
    const auto [low, high] = std::minmax({scale_.place(cycle->low), scale_.place(cycle->high)});
    if (!on_path(low, place) || !on_path(high, place) || !(low < high)) {
      return;
    }
    if (!spectrum_.sequence) {
      spectrum_.cycles.push_back({kept(low), kept(high), cycle->count});
      return;
    }
    if (cycle->count != std::floor(cycle->count) ||
        cycle->count > static_cast<double>(most_points - spectrum_.turning_points.size()) / 2.0) {
      wrong(place, "E109",
            fmt::format("{} cycles one after another: of TYPE=SEQUENCE a count is a whole number, "
                        "and there are at most {} turning points",
                        cycle->count, most_points),
            "TYPE=BLOCKS takes any count");
      return;
    }
    for (double n = 0.0; n < cycle->count; n += 1.0) {
      spectrum_.turning_points.push_back(kept(cycle->high_first ? high : low));
      spectrum_.turning_points.push_back(kept(cycle->high_first ? low : high));
    }
  }

  // Either order makes the same cycle, but mean, amplitude, count and count, low, high do not.
  void warn_of_high_low(const CycleOfColumns& cycle, const LinePlace& place) {
    if (!high_low_ && cycle.low > cycle.high) {
      high_low_ = true;
      c_.warning(place.span, "W368",
                 fmt::format(
                     "{}low {:.6g} above high {:.6g}: it is taken as a cycle from {:.6g} to {:.6g}",
                     where(place), cycle.low, cycle.high, cycle.high, cycle.low),
                 "a line of TYPE=BLOCKS is low high count; ORDER says other columns, as "
                 "ORDER=MAX,MIN,COUNT");
    }
  }

  bool take_place(double t, const LinePlace& place) {
    if (!on_path(t, place)) {
      return false;
    }
    spectrum_.turning_points.push_back(kept(t));
    return true;
  }

  [[nodiscard]] double kept(double t) const { return std::clamp(t, 0.0, last_); }

  bool on_path(double t, const LinePlace& place) {
    if (t >= -same_place * last_ && t <= last_ * (1.0 + same_place)) {
      return true;
    }
    off_path_ = true;
    wrong(place, "E325",
          fmt::format("{} lies beyond load path {}, 0 to {:.6g}", scale_.describe(t),
                      card_.name_reference("PATH").name, last_),
          hint_beyond(t));
    return false;
  }

  // A little beyond the end the path is too short; far beyond it t is no part of its load but a
  // load, a stress or per cent.
  [[nodiscard]] std::string hint_beyond(double at) const {
    constexpr double far = 3.0;
    if (!scale_.values() && std::abs(at) > far * last_) {
      return "t counts in parts of the path: 0 is its step FROM, 1 its step TO; AT0 and AT1 of "
             "$SPECTRUM say which loads these stand for, FACTOR=0.01 brings per cent to t";
    }
    return at > 0.0 ? "give $LOADPATH a larger BEYOND" : "let the path begin at the smallest load";
  }

  [[nodiscard]] std::string where(const LinePlace& place) const {
    if (place.line == 0) {
      return {};
    }
    const std::filesystem::path file =
        std::filesystem::path(c_.sources.file_name(card_.span.file)).parent_path() /
        std::string(card_.word_value("FILE"));
    return describe_file_line(file.string(), place.line);
  }

  void wrong(const LinePlace& place, const char* code, const std::string& text,
             std::string hint = {}) {
    c_.error(place.span, code, where(place) + text, std::move(hint));
    good_ = good_ && place.line == 0; // one complaint about a file is enough
  }

  [[nodiscard]] bool has_cycle() const {
    const auto [low, high] = std::ranges::minmax_element(spectrum_.turning_points);
    return !spectrum_.cycles.empty() || (!spectrum_.turning_points.empty() && *low < *high);
  }

  static constexpr std::size_t first_lines = 20; ///< a file's header is hardly longer

  DeckContext& c_;
  const CheckedCard& card_;
  SpectrumScale scale_;
  SpectrumColumns columns_;
  model::SpectrumDefinition spectrum_;
  std::vector<double> loads_; ///< of a line
  double last_ = 1.0;         ///< t at the end of the path
  double flights_ = 0.0;      ///< that marks, or the generator, have counted
  bool good_ = true;
  bool off_path_ = false; ///< some t
  bool high_low_ = false; ///< some line, which is told
};

} // namespace

void build_spectra(DeckContext& context) {
  context.for_each_sound_card(
      "SPECTRUM", [&](const CheckedCard& card) { SpectrumReader(context, card).read(); });
}

} // namespace spricka::deck
