// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/format_line.hpp"

#include "grammar/lexeme.hpp"

#include <algorithm>

namespace spricka::grammar {

namespace {

// End of a text, an expression in brackets or a unit at `p`, and of what is joined to it without a
// blank. `depth` counts brackets that are still open at `last`.
const char* token_end(const char* p, const char* last, int& depth) {
  bool quoted = false;
  bool unit = false;
  for (; p < last; ++p) {
    if (unit) { // any byte may stand in one until ]
      unit = *p != ']';
    } else if (*p == '\'') {
      quoted = !quoted;
    } else if (quoted) {
      continue;
    } else if (*p == '[') {
      unit = true;
    } else if (*p == '(' || *p == ')') {
      depth = std::max(depth + (*p == '(' ? 1 : -1), 0);
    } else if (depth == 0 && (is_blank(*p) || *p == '=' || *p == ',')) {
      break;
    }
  }
  return p;
}

std::string_view without_trailing_blanks(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

} // namespace

std::string HeaderFormatter::format_header_line(std::string_view code) {
  std::string out;
  const char* p = code.data();
  const char* const last = p + code.size();
  while (p < last) {
    if (is_blank(*p)) {
      ++p;
    } else if (depth_ == 0 && (*p == '=' || *p == ',')) {
      out += *p++;
      value_ = true;
    } else {
      const bool joined = out.empty() || out.back() == '=' || out.back() == ',';
      const bool open = depth_ > 0;
      const char* const end = std::max(token_end(p, last, depth_), p + 1);
      const std::string_view text = without_trailing_blanks({p, end});
      out += joined ? "" : " ";
      out += open ? std::string(text) : token(text);
      p = end;
    }
  }
  return out;
}

std::string HeaderFormatter::token(std::string_view text) {
  if (value_) {
    value_ = false;
    return word(text);
  }
  std::string upper = to_upper(text); // the card or a key
  key_ = spec_ == nullptr ? nullptr : spec_->find(upper);
  return upper;
}

std::string HeaderFormatter::word(std::string_view text) {
  const bool is_word = key_ != nullptr && !key_->words.empty();
  return is_word && is_letter(text.front()) ? to_upper(text) : std::string(text);
}

DataLineCapitaliser::DataLineCapitaliser(const CardSpec& spec)
    : check_(spec.name == "CHECK"), everywhere_(check_ || spec.name == "TASK") {
  const std::string_view form =
      spec.data == DataLineForm::rows ? spec.data_form : std::string_view();
  const char* p = form.data();
  const char* const last = p + form.size();
  while (p < last) {
    const char* const end = scan_name(p, last);
    std::string word(p, end);
    if (!word.empty() && word == to_upper(word) && word != "SET") {
      words_.push_back(std::move(word)); // what the form has in capitals is the language's
    }
    p = std::max(end, p + 1);
  }
}

bool DataLineCapitaliser::is_word(const std::string& upper, bool called) const {
  if (check_ && called) {
    return find_result_quantity(upper) != nullptr;
  }
  return (first_ || everywhere_) && std::find(words_.begin(), words_.end(), upper) != words_.end();
}

std::string DataLineCapitaliser::format_data_line(std::string_view code) {
  std::string out;
  const char* p = code.data();
  const char* const last = p + code.size();
  while (p < last) {
    if (depth_ == 0 && is_letter(*p)) {
      const char* const end = scan_qualified_name(p, last);
      const std::string upper = to_upper({p, end});
      out += is_word(upper, end < last && *end == '(') ? upper : std::string(p, end);
      p = end;
      first_ = false;
    } else if (is_blank(*p) || *p == ',' || *p == '=') {
      out += *p++;
    } else {
      const char* const end = std::max(token_end(p, last, depth_), p + 1);
      out.append(p, end);
      p = end;
      first_ = false;
    }
  }
  return out;
}

} // namespace spricka::grammar
