// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_card.hpp"

#include "mesh/import/inp_text.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace spricka::mesh {
namespace {

constexpr std::size_t narrow = 8;     ///< columns of a small field, and of the first and last
constexpr std::size_t line_width = 8; ///< fields with data on a line, large ones are half as many
constexpr std::size_t end_of_fields =
    80; ///< columns; what stands behind is no part of a fixed line
constexpr std::string_view card_blanks = " \t\r";

std::string_view trim_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(card_blanks);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(card_blanks) + 1 - first);
}

/// Text with each tab as blanks up to the next small field.
std::string expand_tabs(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result.append(c == '\t' ? narrow - result.size() % narrow : 1, c == '\t' ? ' ' : c);
  }
  return result;
}

/// BEGIN BULK, which ends the control sections.
bool begins_bulk(std::string_view line) {
  const std::string_view bare = trim_blanks(line);
  return (bare.starts_with('B') || bare.starts_with('b')) &&
         upper_case(bare.substr(0, 5)) == "BEGIN" &&
         upper_case(bare).find("BULK") != std::string::npos;
}

/// CEND, which divides the control sections.
bool ends_executive_control(std::string_view line) {
  return upper_case(trim_blanks(line).substr(0, 4)) == "CEND";
}

bool has_line(std::string_view text, bool (*holds)(std::string_view)) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (holds(text.substr(at, end - at))) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

/// The name in a comment "<prefix> .. <name>", its prefix in whatever case; empty for others.
std::string_view text_behind(std::string_view comment, std::string_view prefix) {
  return upper_case(comment.substr(0, prefix.size())) == prefix
             ? trim_blanks(comment.substr(prefix.size()))
             : std::string_view();
}

/// Takes the digits that a text begins with.
std::optional<base::Label> take_number(std::string_view& text) {
  text = trim_blanks(text);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto number = parse_inp_integer(text.substr(0, digits));
  text = trim_blanks(text.substr(digits));
  return number;
}

/// Number and quoted name behind a prefix, as HyperMesh writes them: $HMSET 3 1 "bore".
std::optional<std::pair<base::Label, std::string>> quoted_name_in(std::string_view comment,
                                                                  std::string_view prefix) {
  std::string_view rest = text_behind(comment, prefix);
  const auto id = take_number(rest);
  const std::size_t quote = rest.find('"');
  if (!id || quote == std::string_view::npos) {
    return std::nullopt;
  }
  rest.remove_prefix(quote + 1);
  const std::string_view name = trim_blanks(rest.substr(0, rest.find('"')));
  return name.empty() ? std::nullopt : std::optional(std::pair(*id, std::string(name)));
}

/// Number and name of a property, as ANSA, HyperMesh and Femap write them into comments.
std::optional<std::pair<base::Label, std::string>> property_name_in(std::string_view comment) {
  if (auto named = quoted_name_in(comment, "$HMNAME PROP ")) {
    return named;
  }
  std::string_view rest = text_behind(comment, "$ANSA_NAME_COMMENT;");
  if (!rest.empty()) {
    const auto id = take_number(rest);
    const bool property = rest.starts_with(";PSOLID;") || rest.starts_with(";PSHELL;");
    rest.remove_prefix(property ? 8 : rest.size());
    const std::string_view name = trim_blanks(rest.substr(0, rest.find(';')));
    return id && !name.empty() ? std::optional(std::pair(*id, std::string(name))) : std::nullopt;
  }
  rest = text_behind(comment, "$ FEMAP ");
  const std::size_t at = rest.find("Property ");
  rest = rest.substr(at == std::string_view::npos ? rest.size() : at + 9);
  const auto id = take_number(rest);
  const std::string_view name = trim_blanks(rest.substr(std::min<std::size_t>(1, rest.size())));
  return id && rest.starts_with(':') && !name.empty()
             ? std::optional(std::pair(*id, std::string(name)))
             : std::nullopt;
}

} // namespace

std::optional<double> parse_nastran_real(std::string_view text) {
  std::string number(text.starts_with('+') ? text.substr(1) : text);
  std::replace_if(
      number.begin(), number.end(), [](char c) { return c == 'E' || c == 'd' || c == 'D'; }, 'e');
  const std::size_t sign = number.find_first_of("+-", 1);
  if (sign != std::string::npos && number.find('e') == std::string::npos) {
    number.insert(sign, 1, 'e');
  }
  if (number.find_first_not_of("0123456789+-.e") != std::string::npos) {
    return std::nullopt; // inf and nan
  }
  double value = 0.0;
  const auto [end, status] = std::from_chars(number.data(), number.data() + number.size(), value);
  return status == std::errc() && end == number.data() + number.size() ? std::optional(value)
                                                                       : std::nullopt;
}

NastranCardReader::NastranCardReader(const std::filesystem::path& file, Complain complain)
    : complain_(std::move(complain)), files_(file, "INCLUDE", complain_) {
  in_bulk_ = !has_line(files_.first_text(), begins_bulk);
  if (in_bulk_ && has_line(files_.first_text(), ends_executive_control)) {
    complain_({}, "there is CEND, but no BEGIN BULK after it");
    files_.close();
  }
}

bool NastranCardReader::next_card() {
  while (line_waits_ || next_bulk_line()) {
    line_waits_ = false;
    if (line_.continues) {
      complain_(line_.place,
                fmt::format("the line continues '{}', and no entry stands before it", line_.first));
      continue;
    }
    card_.name = line_.first;
    card_.place = line_.place;
    card_.fields.clear();
    card_.title = std::exchange(title_, {});
    append_line();
    std::string mark = line_.mark;
    InpLocation at = line_.place;
    while (next_bulk_line()) {
      if (!line_.continues) {
        line_waits_ = true;
        break;
      }
      if (!mark.empty() && !line_.first.empty() && mark.substr(1) != line_.first) {
        complain_(line_.place,
                  fmt::format("the line continues '{}', and the one before it is continued by "
                              "'{}': lines out of order are not read",
                              line_.first, mark.substr(1)));
      }
      append_line();
      mark = line_.mark;
      at = line_.place;
      line_waits_ = false;
    }
    check_continuation_end(mark, at);
    return true;
  }
  return false;
}

void NastranCardReader::check_continuation_end(const std::string& mark, InpLocation at) {
  if (mark.starts_with('+') || mark.starts_with('*')) {
    complain_(at, fmt::format("the line ends with '{}', and no line continues it", mark));
  }
}

void NastranCardReader::append_line() {
  const std::size_t width = line_.large ? line_width / 2 : line_width;
  std::vector<NastranField>& fields = card_.fields;
  fields.resize((fields.size() + width - 1) / width * width);
  const std::size_t count = (line_.fields.size() + width - 1) / width * width;
  std::move(line_.fields.begin(), line_.fields.end(), std::back_inserter(fields));
  fields.resize(fields.size() + count - line_.fields.size());
}

/// Moves to the next line with data; false at ENDDATA or at the end of the files.
bool NastranCardReader::next_bulk_line() {
  while (files_.next_line()) {
    std::string_view text = files_.line();
    const std::string_view bare = trim_blanks(text);
    if (bare.empty()) {
      continue;
    }
    if (bare.front() == '$') {
      take_comment(bare);
      continue;
    }
    if (!in_bulk_) {
      in_bulk_ = begins_bulk(bare);
      continue;
    }
    const std::string word = upper_case(bare.substr(0, 8));
    if (word.starts_with("ENDDATA")) {
      files_.close();
      return false;
    }
    if (begins_bulk(bare)) { // in a file that is included
      continue;
    }
    if (word.starts_with("INCLUDE")) {
      include(bare.substr(7));
      continue;
    }
    text = text.substr(0, text.find('$'));
    line_ = {};
    line_.place = files_.location();
    if (text.substr(0, end_of_fields).find(',') == std::string_view::npos) {
      split_fixed(text);
    } else {
      split_free(text);
    }
    return true;
  }
  return false;
}

/// A path may be broken over lines, up to the quote that closes it.
void NastranCardReader::include(std::string_view text) {
  std::string path(trim_blanks(text));
  const InpLocation at = files_.location();
  const char quote = path.empty() ? ' ' : path.front();
  if (quote != '\'' && quote != '"') {
    files_.include(path, at);
    return;
  }
  path.erase(0, 1);
  while (path.find(quote) == std::string::npos) {
    if (!files_.next_line() || files_.location().file != at.file) {
      complain_(at, "INCLUDE: the quote is not closed");
      return;
    }
    path += trim_blanks(files_.line());
  }
  files_.include(path.substr(0, path.find(quote)), at);
}

void NastranCardReader::take_comment(std::string_view text) {
  if (auto named = property_name_in(text)) {
    property_names_.insert_or_assign(named->first, std::move(named->second));
  }
  if (auto named = quoted_name_in(text, "$HMSET ")) {
    set_names_.insert_or_assign(named->first, std::move(named->second));
  }
  for (const std::string_view prefix :
       {"$ ELEMENTS AND ELEMENT PROPERTIES FOR REGION", "$* PROPERTY"}) {
    if (const std::string_view name = text_behind(text, prefix); name.starts_with(':')) {
      title_ = trim_blanks(name.substr(1));
    }
  }
}

void NastranCardReader::take_first_field(std::string_view text) {
  std::string first = upper_case(trim_blanks(text));
  line_.continues = first.empty() || first.front() == '+' || first.front() == '*';
  line_.large = line_.continues ? first.starts_with('*') : first.ends_with('*');
  if (line_.continues) {
    first.erase(0, 1);
  } else if (line_.large) {
    first = trim_blanks(std::string_view(first).substr(0, first.size() - 1));
  }
  line_.first = std::move(first);
}

void NastranCardReader::split_fixed(std::string_view text) {
  const std::string columns = expand_tabs(text);
  const std::string_view line(columns);
  take_first_field(line.substr(0, narrow));
  const std::size_t width = line_.large ? 2 * narrow : narrow;
  const std::size_t end = narrow + line_width * narrow;
  for (std::size_t at = narrow; at < end; at += width) {
    const std::string_view field = at < line.size() ? line.substr(at, width) : std::string_view();
    line_.fields.push_back({std::string(trim_blanks(field)), line_.place, at + 1});
  }
  if (line.size() > end) {
    line_.mark = upper_case(trim_blanks(line.substr(end, narrow)));
  }
}

void NastranCardReader::split_free(std::string_view text) {
  std::size_t at = 0;
  const auto next = [&] {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    NastranField field{std::string(trim_blanks(text.substr(at, comma - at))), line_.place, at + 1};
    at = comma + 1;
    return field;
  };
  take_first_field(next().text);
  const std::size_t width = line_.large ? line_width / 2 : line_width;
  std::size_t on_line = 0;
  while (at <= text.size()) {
    NastranField field = next();
    const bool last = on_line++ == width;
    const bool mark = field.text.starts_with('*') ||
                      (field.text.starts_with('+') && !parse_nastran_real(field.text));
    if (last && (mark || field.text.empty())) {
      line_.mark = at > text.size() ? upper_case(field.text) : "";
      on_line = 0;
    } else if (last) { // more than a line holds: the rest continues it
      line_.fields.push_back(std::move(field));
      on_line = 1;
    } else if (mark && at > text.size()) { // a mark before the tenth field
      line_.mark = upper_case(field.text);
    } else {
      line_.fields.push_back(std::move(field));
    }
  }
}

} // namespace spricka::mesh
