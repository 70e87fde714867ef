// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/format.hpp"

#include "grammar/format_line.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace spricka::grammar {

namespace {

constexpr std::size_t k_step = 2; ///< blanks of one indentation
constexpr std::size_t k_tab = 8;

enum class Role { blank, comment, header, row, table };

/// One line of the file, taken apart and laid out anew.
struct FormattedLine {
  Role role = Role::blank;
  std::size_t indent = 0;
  std::string code;
  std::string comment;    ///< from its ! on
  std::size_t column = 0; ///< where the comment began
};

// The column behind a text, from 0.
std::size_t width_of(std::string_view text) {
  std::size_t column = 0;
  for (const char c : text) {
    column = c == '\t' ? (column / k_tab + 1) * k_tab : column + 1;
  }
  return column;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '\r')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) {
    text.remove_suffix(1);
  }
  return text;
}

// Where the comment of a line starts; its length without one. A ! in a text or unit is none.
std::size_t comment_start(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') {
      quoted = !quoted;
    } else if (line[i] == '!' && !quoted) {
      return i;
    } else if (line[i] == '[' && !quoted) {
      const std::size_t close = line.find(']', i);
      i = close == std::string_view::npos ? i : close;
    }
  }
  return line.size();
}

/// Lays out the lines of one file, whose cards are known.
class Formatter {
public:
  Formatter(std::string_view text, const std::vector<CardHeader>& cards)
      : text_(text), cards_(cards) {}

  std::string run() {
    std::size_t at = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (at < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      std::string_view line = text_.substr(at, end - at);
      if (line.ends_with('\r')) {
        line.remove_suffix(1);
      }
      add(line, at);
      at = end + 1;
    }
    indent_comments();
    return written();
  }

private:
  void add(std::string_view text, std::size_t at) {
    const std::size_t mark = comment_start(text);
    const std::string_view code = trimmed(text.substr(0, mark));
    FormattedLine line;
    line.comment = text.substr(mark);
    line.column = width_of(text.substr(0, mark));
    if (code.empty()) {
      line.role = line.comment.empty() ? Role::blank : Role::comment;
      line.indent = line.column;
    } else if (enter_card(at, at + mark) || in_header(at)) {
      header(code, line);
    } else {
      data(text.substr(0, mark), code, line);
    }
    lines_.push_back(std::move(line));
  }

  // Whether a card starts between these bytes.
  bool enter_card(std::size_t begin, std::size_t end) {
    const std::size_t next = card_ + 1;
    if (next >= cards_.size() + 1 || next_begin() < begin || next_begin() >= end) {
      return false;
    }
    card_ = next;
    const CardHeader& card = cards_[card_ - 1];
    spec_ = find_card(card.name);
    if (card.name == "ENDNET") {
      in_net_ = false;
    }
    indent_ = in_net_ ? k_step : 0;
    if (card.name == "NET") {
      in_net_ = true;
    }
    header_ = HeaderFormatter(spec_);
    return true;
  }

  [[nodiscard]] std::size_t next_begin() const {
    return card_ < cards_.size() ? cards_[card_].header.begin : text_.size();
  }

  [[nodiscard]] bool in_header(std::size_t at) const {
    return card_ > 0 && at < cards_[card_ - 1].header.end;
  }

  void header(std::string_view code, FormattedLine& line) {
    line.role = Role::header;
    const bool continues = code.starts_with('&');
    line.indent = indent_ + (continues ? k_step : 0);
    line.code = continues ? "& " + header_.format_header_line(code.substr(1))
                          : header_.format_header_line(code);
  }

  void data(std::string_view whole, std::string_view code, FormattedLine& line) {
    if (spec_ == nullptr || spec_->data == DataLineForm::table ||
        spec_->data == DataLineForm::none) {
      line.role = Role::table;
      line.code = whole.substr(0, whole.find_last_not_of(" \t\r") + 1);
      return;
    }
    line.role = Role::row;
    line.indent = indent_ + k_step;
    const bool continues = code.starts_with('&');
    if (!continues) {
      row_ = DataLineCapitaliser(*spec_);
    }
    line.code = continues ? "& " + row_.format_data_line(trimmed(code.substr(1)))
                          : row_.format_data_line(code);
  }

  // A comment belongs to what follows it. Above a table's row it stays where it is.
  void indent_comments() {
    std::size_t indent = 0;
    bool keep = false;
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
      if (line->role == Role::comment) {
        line->indent = keep ? line->indent : indent;
      } else if (line->role != Role::blank) {
        indent = line->indent;
        keep = line->role == Role::table;
      }
    }
  }

  [[nodiscard]] std::string written() const {
    std::string out;
    bool gap = false; // a blank line is due before the next line with something on it
    for (const FormattedLine& line : lines_) {
      if (line.role == Role::blank) {
        gap = !out.empty();
        continue;
      }
      out += gap ? "\n" : "";
      gap = false;
      std::string text = std::string(line.indent, ' ') + line.code;
      if (line.role != Role::comment && !line.comment.empty()) {
        const std::size_t width = width_of(text);
        text.append(std::max(line.column, width + 2) - width, ' ');
      }
      out += text + line.comment + '\n';
    }
    return out;
  }

  std::string_view text_;
  const std::vector<CardHeader>& cards_;
  std::vector<FormattedLine> lines_;
  std::size_t card_ = 0; ///< cards entered so far; the last of them is open
  const CardSpec* spec_ = nullptr;
  std::size_t indent_ = 0;
  bool in_net_ = false;
  HeaderFormatter header_{nullptr};
  DataLineCapitaliser row_{{}};
};

} // namespace

std::optional<std::string> format_deck(const base::SourceTexts& sources, std::int32_t file,
                                       base::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  const std::vector<CardHeader> cards = parse_cards(sources, file, diagnostics);
  for (const CardHeader& card : cards) {
    const CardSpec* spec = find_card(card.name);
    if (spec != nullptr && spec->data == DataLineForm::rows) {
      parse_data_rows(sources, card.data, diagnostics);
    } else if (spec != nullptr && spec->data == DataLineForm::assignments) {
      parse_parameter_assignments(sources, card.data, diagnostics);
    }
  }
  if (diagnostics.error_count() > before) {
    return std::nullopt;
  }
  return Formatter(sources.text(file), cards).run();
}

} // namespace spricka::grammar
