// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/number_file.hpp"

#include "base/input_file.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

bool separates_numbers(char letter) {
  return letter == ' ' || letter == '\t' || letter == ',' || letter == ';' || letter == '\r';
}

// Takes the lines of a text apart; the numbers of one line are kept until the next.
class NumberLineParser {
public:
  explicit NumberLineParser(const NumberFileLayout& layout) : layout_(layout) {}

  // Whether the line has numbers or is a mark.
  bool parse(std::string_view text, NumberRow& row) {
    numbers_.clear();
    row.sound = true;
    row.mark = is_mark(text);
    const char* at = text.data();
    const char* const end = at + text.size();
    while (!row.mark && row.sound && at != end) {
      if (separates_numbers(*at)) {
        ++at;
        continue;
      }
      if (is_comment(at, end)) {
        break;
      }
      double value = 0.0;
      const auto [behind, trouble] = std::from_chars(at + (*at == '+' ? 1 : 0), end, value);
      row.sound = trouble == std::errc();
      numbers_.push_back(value);
      at = behind;
    }
    row.numbers = numbers_;
    return row.mark || !numbers_.empty();
  }

private:
  [[nodiscard]] bool is_comment(const char* at, const char* end) const {
    return layout_.comment.empty() ? *at == '!' || *at == '#'
                                   : std::string_view(at, static_cast<std::size_t>(end - at))
                                         .starts_with(layout_.comment);
  }

  [[nodiscard]] bool is_mark(std::string_view text) const {
    if (layout_.mark.empty()) {
      return false;
    }
    const std::size_t first = text.find_first_not_of(" \t");
    return first != std::string_view::npos && text.substr(first).starts_with(layout_.mark);
  }

  const NumberFileLayout& layout_;
  std::vector<double> numbers_;
};

} // namespace

std::string describe_file_line(std::string_view file, std::size_t line) {
  return fmt::format("line {} of '{}': ", line, file);
}

std::string visit_number_file(DeckContext& context, const CheckedCard& card, std::string_view key,
                              const NumberFileLayout& layout,
                              const std::function<bool(const NumberRow&)>& take) {
  const std::filesystem::path path =
      std::filesystem::path(context.sources.file_name(card.span.file)).parent_path() /
      std::string(card.word_value(key));
  std::string all;
  try {
    all = base::read_file(path, base::largest_number_file);
  } catch (const base::UnreadableFile& trouble) {
    context.error(card.find(key)->span, "E308", trouble.what());
    return {};
  }
  context.model.imported_files.push_back(path.string());
  NumberLineParser parser(layout);
  NumberRow row;
  std::string_view rest = all;
  for (row.line = 1; !rest.empty(); ++row.line) {
    const std::string_view text = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(text.size() + 1, rest.size()));
    if (row.line > layout.skipped_lines && parser.parse(text, row) && !take(row)) {
      break;
    }
  }
  return path.string();
}

std::optional<std::vector<NumberLine>>
read_number_file(DeckContext& context, const CheckedCard& card, std::string_view key) {
  std::vector<NumberLine> lines;
  std::vector<std::size_t> places;
  const std::string file = visit_number_file(context, card, key, {}, [&](const NumberRow& row) {
    lines.push_back(
        {{row.numbers.begin(), row.numbers.end()}, card.find(key)->span, {}, row.sound});
    places.push_back(row.line);
    return row.sound; // one complaint about a file is enough
  });
  if (file.empty()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].where = describe_file_line(file, places[i]);
  }
  return lines;
}

} // namespace spricka::deck
