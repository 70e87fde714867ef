// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/number_file.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

constexpr double same_place = 1e-9; // of a load path's length, as its own rows are rounded

class SpectrumReader {
public:
  SpectrumReader(DeckContext& c, const CheckedCard& card) : c_(c), card_(card) {}

  void read() {
    spectrum_.name = card_.word_value("NAME");
    spectrum_.sequence = card_.key_has_word("TYPE", "SEQUENCE");
    spectrum_.counting = card_.key_has_word("COUNT", "PAIRS") ? model::CycleCounting::pairs
                                                              : model::CycleCounting::rainflow;
    spectrum_.span = card_.span;
    const NameDefinition* path =
        find_referenced_definition(c_, EntityKind::path, card_.name_reference("PATH"));
    if (path != nullptr && path->index < c_.model.load_paths.size()) {
      spectrum_.path = path->index;
      last_ = c_.model.load_paths[path->index].beyond;
    }
    if (card_.has_key("FILE")) {
      from_file();
    } else {
      from_rows();
    }
    if (good_ && !card_.rows_bad && !off_path_ && !has_cycle()) {
      c_.error(card_.span, "E325",
               fmt::format("spectrum {} has no cycle", card_.word_value("NAME")),
               spectrum_.sequence ? "a sequence has two or more different turning points"
                                  : "a line of TYPE=BLOCKS is low high count");
    }
    c_.model.spectra.push_back(std::move(spectrum_));
  }

private:
  void from_rows() {
    for (const grammar::DataRow& row : card_.rows) {
      NumberLine line;
      line.span = row.span;
      for (const CardField& field : row.fields) {
        const auto number =
            c_.read_number(field, grammar::QuantityKind::number, "a place t on the path");
        good_ = good_ && number.has_value();
        line.numbers.push_back(number.value_or(0.0));
      }
      if (good_) {
        take(line);
      }
    }
  }

  void from_file() {
    if (!card_.rows.empty()) {
      c_.error(card_.rows.front().span, "E115", "with FILE there are no data lines");
    }
    const auto lines = read_number_file(c_, card_, "FILE");
    good_ = good_ && lines.has_value();
    if (good_ && spectrum_.sequence) {
      warn_of_columns(*lines);
    }
    for (std::size_t i = 0; good_ && i < lines->size(); ++i) {
      const NumberLine& line = (*lines)[i];
      if (line.sound) {
        take(line);
      } else {
        wrong(line, "E115", "not a number");
      }
    }
  }

  void take(const NumberLine& line) {
    if (spectrum_.sequence) {
      for (const double t : line.numbers) {
        if (on_path(line, t)) {
          spectrum_.turning_points.push_back(place(t));
        }
      }
      return;
    }
    if (line.numbers.size() != 3) {
      wrong(line, "E115", "a line of TYPE=BLOCKS is low high count");
      return;
    }
    warn_of_high_low(line);
    const double low = std::min(line.numbers[0], line.numbers[1]);
    const double high = std::max(line.numbers[0], line.numbers[1]);
    if (line.numbers[2] <= 0.0) {
      wrong(line, "E109", fmt::format("{} cycles: a count is positive", line.numbers[2]));
    } else if (on_path(line, low) && on_path(line, high) && low < high) {
      spectrum_.cycles.push_back({place(low), place(high), line.numbers[2]});
    }
  }

  // Either order makes the same cycle, but mean, amplitude, count and count, low, high do not.
  void warn_of_high_low(const NumberLine& line) {
    if (!high_low_ && line.numbers[0] > line.numbers[1]) {
      high_low_ = true;
      c_.warning(
          line.span, "W368",
          fmt::format(
              "{}low {:.6g} above high {:.6g}: it is taken as a cycle from {:.6g} to {:.6g}",
              line.where, line.numbers[0], line.numbers[1], line.numbers[1], line.numbers[0]),
          "a line of TYPE=BLOCKS is low high count, not high low count or mean amplitude count");
    }
  }

  // The first of several columns that always ascends, evenly or for long, is a time or a number.
  void warn_of_columns(const std::vector<NumberLine>& lines) {
    constexpr std::size_t least = 4;
    constexpr std::size_t long_enough = 10;
    constexpr double even = 1e-6;
    const std::size_t columns = lines.empty() ? 0 : lines.front().numbers.size();
    if (columns < 2 || lines.size() < least) {
      return;
    }
    const auto first = [&](std::size_t i) { return lines[i].numbers.front(); };
    const double step = first(1) - first(0);
    bool ascends = true;
    bool evenly = true;
    for (std::size_t i = 1; i < lines.size() && ascends; ++i) {
      ascends = lines[i].numbers.size() == columns && first(i) > first(i - 1);
      evenly = evenly && std::abs(first(i) - first(i - 1) - step) <= even * step;
    }
    if (ascends && (evenly || lines.size() >= long_enough)) {
      c_.warning(
          card_.find("FILE")->span, "W369",
          fmt::format("every line of the file has {} numbers, and the first of them ascends from "
                      "{:.6g} to {:.6g} like a time or a number: all of them count as places t",
                      columns, first(0), first(lines.size() - 1)),
          "a sequence has nothing but the places t one after another");
    }
  }

  [[nodiscard]] double place(double t) const {
    return std::clamp(t * card_.number_value("FACTOR"), 0.0, last_);
  }

  bool on_path(const NumberLine& line, double t) {
    const double at = t * card_.number_value("FACTOR");
    if (at >= -same_place * last_ && at <= last_ * (1.0 + same_place)) {
      return true;
    }
    off_path_ = true;
    wrong(line, "E325",
          fmt::format("t = {:.6g} lies beyond load path {}, 0 to {:.6g}", at,
                      card_.name_reference("PATH").name, last_),
          hint_beyond(at));
    return false;
  }

  // A little beyond the end the path is too short; far beyond it t is no part of its load but a
  // load, a stress or per cent.
  [[nodiscard]] std::string hint_beyond(double at) const {
    constexpr double far = 3.0;
    if (std::abs(at) > far * last_) {
      return "t counts in parts of the path: 0 is its step FROM, 1 its step TO; FACTOR of "
             "$SPECTRUM "
             "brings per cent (FACTOR=0.01), loads or stresses to that";
    }
    return at > 0.0 ? "give $LOADPATH a larger BEYOND" : "let the path begin at the smallest load";
  }

  void wrong(const NumberLine& line, const char* code, const std::string& text,
             std::string hint = {}) {
    c_.error(line.span, code, line.where + text, std::move(hint));
    good_ = good_ && line.where.empty(); // one complaint about a file is enough
  }

  [[nodiscard]] bool has_cycle() const {
    const auto [low, high] = std::ranges::minmax_element(spectrum_.turning_points);
    return !spectrum_.cycles.empty() || (!spectrum_.turning_points.empty() && *low < *high);
  }

  DeckContext& c_;
  const CheckedCard& card_;
  model::SpectrumDefinition spectrum_;
  double last_ = 1.0; ///< t at the end of the path
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
