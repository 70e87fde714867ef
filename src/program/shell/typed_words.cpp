// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/typed_words.hpp"

#include "grammar/lexeme.hpp"

namespace spricka::program {

std::string_view strip_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    quoted = quoted != (line[i] == '\'');
    if (line[i] == '!' && !quoted && !(i + 1 < line.size() && line[i + 1] == '=')) {
      line = line.substr(0, i);
      break;
    }
  }
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos
             ? std::string_view()
             : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split_shell_words(std::string_view line) {
  std::vector<std::string> words;
  int depth = 0;
  bool open = false; // a word has begun
  bool quoted = false;
  for (const char c : strip_comment(line)) {
    if (c == '\'') {
      quoted = !quoted;
      if (quoted && !open) {
        words.emplace_back();
      }
      open = quoted;
      continue;
    }
    depth += c == '(' || c == '[' ? 1 : (c == ')' || c == ']' ? -1 : 0);
    if (!quoted && depth <= 0 && (c == ' ' || c == '\t')) {
      open = false;
      continue;
    }
    if (!open) {
      words.emplace_back();
      open = true;
    }
    words.back() += c;
  }
  return words;
}

ShellLineForm classify_shell_line(std::string_view line) {
  line = strip_comment(line);
  if (line.empty()) {
    return ShellLineForm::nothing;
  }
  if (line.front() == '$') {
    return ShellLineForm::card;
  }
  const char* const last = line.data() + line.size();
  const char* end = grammar::scan_qualified_name(line.data(), last);
  while (end != last && end != line.data() && *end == '.') {
    end = grammar::scan_qualified_name(end + 1, last);
  }
  if (end == line.data() || end == last) {
    return ShellLineForm::command;
  }
  if (*end == '(') {
    return ShellLineForm::result;
  }
  const std::size_t next =
      line.find_first_not_of(" \t", static_cast<std::size_t>(end - line.data()));
  return next != std::string_view::npos && line[next] == '=' ? ShellLineForm::parameter
                                                             : ShellLineForm::command;
}

} // namespace spricka::program
