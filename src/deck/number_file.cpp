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

NumberLine numbers_in(std::string_view text) {
  NumberLine line;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end && line.sound) {
    if (std::string_view(" \t,;\r").find(*at) != std::string_view::npos) {
      ++at;
      continue;
    }
    double value = 0.0;
    const auto [behind, trouble] = std::from_chars(at + (*at == '+' ? 1 : 0), end, value);
    line.sound = trouble == std::errc();
    line.numbers.push_back(value);
    at = behind;
  }
  return line;
}

} // namespace

std::optional<std::vector<NumberLine>>
read_number_file(DeckContext& context, const CheckedCard& card, std::string_view key) {
  const base::SourceSpan span = card.find(key)->span;
  const std::filesystem::path path =
      std::filesystem::path(context.sources.file_name(card.span.file)).parent_path() /
      std::string(card.word_value(key));
  std::string all;
  try {
    all = base::read_file(path, base::largest_number_file);
  } catch (const base::UnreadableFile& trouble) {
    context.error(span, "E308", trouble.what());
    return std::nullopt;
  }
  context.model.imported_files.push_back(path.string());
  std::vector<NumberLine> lines;
  std::string_view rest = all;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view text = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(text.size() + 1, rest.size()));
    NumberLine line = numbers_in(text.substr(0, text.find_first_of("!#")));
    if (!line.sound || !line.numbers.empty()) {
      line.span = span;
      line.where = fmt::format("line {} of '{}': ", number, path.string());
      lines.push_back(std::move(line));
    }
    if (!lines.empty() && !lines.back().sound) {
      break; // one complaint about a file is enough
    }
  }
  return lines;
}

} // namespace spricka::deck
