// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::Field;

constexpr double same_place = 1e-9; // of a load path's length, as its own rows are rounded

/// Numbers of a line and the place for messages about it.
struct Line {
  std::vector<double> numbers;
  base::Span span;
  std::string where; ///< "line 17 of 'f.txt': "; empty: the span says it
};

std::optional<std::vector<double>> numbers_in(std::string_view line) {
  std::vector<double> numbers;
  const std::string_view text = line.substr(0, line.find_first_of("!#"));
  const char* at = text.data();
  const char* end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r' || *at == ';') {
      ++at;
      continue;
    }
    at += *at == '+' ? 1 : 0;
    double value = 0.0;
    const auto [behind, trouble] = std::from_chars(at, end, value);
    if (trouble != std::errc()) {
      return std::nullopt;
    }
    numbers.push_back(value);
    at = behind;
  }
  return numbers;
}

class SpectrumReader {
public:
  SpectrumReader(Context& c, const BoundCard& card) : c_(c), card_(card) {}

  void read() {
    spectrum_.name = card_.word("NAME");
    spectrum_.sequence = card_.is("TYPE", "SEQUENCE");
    spectrum_.span = card_.span;
    const Definition* path = look_up(c_, Kind::path, card_.reference("PATH"));
    if (path != nullptr && path->index < c_.model.load_paths.size()) {
      spectrum_.path = path->index;
      last_ = c_.model.load_paths[path->index].beyond;
    }
    if (card_.has("FILE")) {
      from_file();
    } else {
      from_rows();
    }
    if (good_ && !card_.rows_bad && !has_cycle()) {
      c_.error(card_.span, "E325", fmt::format("spectrum {} has no cycle", card_.word("NAME")),
               spectrum_.sequence ? "a sequence has two or more different turning points"
                                  : "a line of TYPE=BLOCKS is low high count");
    }
    c_.model.spectra.push_back(std::move(spectrum_));
  }

private:
  void from_rows() {
    for (const grammar::Row& row : card_.rows) {
      Line line;
      line.span = row.span;
      for (const Field& field : row.fields) {
        const auto number = number_of(field, grammar::Quantity::number, "a place t on the path",
                                      c_.scope, c_.diagnostics);
        good_ = good_ && number.has_value();
        line.numbers.push_back(number.value_or(0.0));
      }
      if (good_) {
        take(line);
      }
    }
  }

  void from_file() {
    const base::Span span = card_.find("FILE")->span;
    const std::filesystem::path file =
        std::filesystem::path(c_.sources.name(card_.span.file)).parent_path() /
        std::string(card_.word("FILE"));
    if (!card_.rows.empty()) {
      c_.error(card_.rows.front().span, "E115", "with FILE there are no data lines");
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      c_.error(span, "E308", fmt::format("cannot read '{}'", file.string()));
      good_ = false;
      return;
    }
    c_.model.imported_files.push_back(file.string());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size() && good_;) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const auto found = numbers_in(std::string_view(text).substr(at, end - at));
      const std::string where = fmt::format("line {} of '{}': ", ++number, file.string());
      if (!found) {
        c_.error(span, "E115", where + "not a number");
        good_ = false;
      } else if (!found->empty()) {
        take({*found, span, where});
      }
      at = end + 1;
    }
  }

  void take(const Line& line) {
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
    const double low = std::min(line.numbers[0], line.numbers[1]);
    const double high = std::max(line.numbers[0], line.numbers[1]);
    if (line.numbers[2] <= 0.0) {
      wrong(line, "E109", fmt::format("{} cycles: a count is positive", line.numbers[2]));
    } else if (on_path(line, low) && on_path(line, high) && low < high) {
      spectrum_.cycles.push_back({place(low), place(high), line.numbers[2]});
    }
  }

  [[nodiscard]] double place(double t) const {
    return std::clamp(t * card_.number("FACTOR"), 0.0, last_);
  }

  bool on_path(const Line& line, double t) {
    const double at = t * card_.number("FACTOR");
    if (at >= -same_place * last_ && at <= last_ * (1.0 + same_place)) {
      return true;
    }
    wrong(line, "E325",
          fmt::format("t = {:.6g} lies beyond load path {}, 0 to {:.6g}", at,
                      card_.reference("PATH").name, last_),
          at > 0.0 ? "give $LOADPATH a larger BEYOND" : "let the path begin at the smallest load");
    return false;
  }

  void wrong(const Line& line, const char* code, const std::string& text, std::string hint = {}) {
    c_.error(line.span, code, line.where + text, std::move(hint));
    good_ = good_ && line.where.empty(); // one complaint about a file is enough
  }

  [[nodiscard]] bool has_cycle() const {
    const auto [low, high] = std::ranges::minmax_element(spectrum_.turning_points);
    return !spectrum_.cycles.empty() || (!spectrum_.turning_points.empty() && *low < *high);
  }

  Context& c_;
  const BoundCard& card_;
  model::Spectrum spectrum_;
  double last_ = 1.0; ///< t at the end of the path
  bool good_ = true;
};

} // namespace

void build_spectra(Context& context) {
  for (const BoundCard& card : context.cards) {
    if (card.spec->name == "SPECTRUM" && !card.bad) {
      SpectrumReader(context, card).read();
    }
  }
}

} // namespace spricka::deck
