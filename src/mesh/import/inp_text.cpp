// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_text.hpp"

#include "base/label.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <system_error>

namespace spricka::mesh {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string without_blanks(std::string_view text) {
  std::string result = upper_case(text);
  std::erase_if(result, [](char c) { return blanks.find(c) != std::string_view::npos; });
  return result;
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

/// Fortran writes 1.5D3.
std::optional<double> fortran(std::string_view text) {
  std::string copy(text);
  std::replace_if(
      copy.begin(), copy.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  double value = 0.0;
  const auto [end, status] = std::from_chars(copy.data(), copy.data() + copy.size(), value);
  return status == std::errc() && end == copy.data() + copy.size() ? std::optional(value)
                                                                   : std::nullopt;
}

std::string_view unsigned_part(std::string_view text) {
  return text.starts_with('+') ? text.substr(1) : text;
}

} // namespace

const std::string* InpKeyword::find(std::string_view key) const {
  const auto at = std::find_if(parameters.begin(), parameters.end(),
                               [&](const auto& p) { return p.first == key; });
  return at == parameters.end() ? nullptr : &at->second;
}

InpLineReader::InpLineReader(const std::filesystem::path& file, Complain complain)
    : complain_(std::move(complain)), files_(file, "*INCLUDE", complain_) {}

bool InpLineReader::raw_line() {
  while (files_.next_line()) {
    line_ = trimmed(files_.line());
    place_ = files_.location();
    if (!line_.empty() && !line_.starts_with("**")) {
      return true;
    }
  }
  return false;
}

bool InpLineReader::next_line() {
  while (raw_line()) {
    if (!is_at_keyword()) {
      return true;
    }
    read_keyword();
    if (keyword_.name != "INCLUDE") {
      return true;
    }
    include();
  }
  return false;
}

void InpLineReader::read_keyword() {
  keyword_ = {};
  keyword_.place = place_;
  std::string whole(line_);
  while (whole.ends_with(',') && raw_line()) {
    if (place_.file != keyword_.place.file) {
      complain_(keyword_.place, "a keyword line does not end in its file");
    }
    whole += line_;
  }
  line_ = "*";
  std::string_view rest = std::string_view(whole).substr(1);
  for (bool first = true; first || !rest.empty(); first = false) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view part = rest.substr(0, comma);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    const std::size_t equal = part.find('=');
    if (first) {
      keyword_.shown = upper_case(trimmed(part));
      keyword_.name = without_blanks(part);
    } else if (!trimmed(part).empty()) {
      keyword_.parameters.emplace_back(
          without_blanks(part.substr(0, equal)),
          equal == std::string_view::npos ? "" : unquoted(part.substr(equal + 1)));
    }
  }
}

void InpLineReader::include() {
  const std::string* input = keyword_.find("INPUT");
  if (input == nullptr) {
    complain_(keyword_.place, "*INCLUDE needs INPUT=");
    return;
  }
  files_.include(*input, keyword_.place);
}

std::string_view InpFieldReader::next_text() {
  const std::size_t comma = rest_.find(',');
  const std::string_view field = trimmed(rest_.substr(0, comma));
  // a comma at the end of the line opens no further field
  rest_ = comma == std::string_view::npos ? std::string_view() : rest_.substr(comma + 1);
  more_ = !rest_.empty();
  return field;
}

std::optional<double> InpFieldReader::next_real() {
  const std::string_view field = unsigned_part(next_text());
  if (field.empty()) {
    return 0.0;
  }
  const bool digit = field[0] == '-' || field[0] == '.' || (field[0] >= '0' && field[0] <= '9');
  double value = 0.0;
  const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (digit && status == std::errc() && end == field.data() + field.size()) {
    return value;
  }
  return digit ? fortran(field) : std::nullopt;
}

std::optional<std::int64_t> InpFieldReader::next_integer() {
  return parse_inp_integer(next_text());
}

std::optional<std::int64_t> parse_inp_integer(std::string_view text) {
  text = unsigned_part(text);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = status == std::errc() && end == text.data() + text.size();
  return whole && std::abs(value) <= base::largest_label ? std::optional(value) : std::nullopt;
}

} // namespace spricka::mesh
