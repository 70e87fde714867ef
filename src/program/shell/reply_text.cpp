// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/reply_text.hpp"

#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "grammar/argument_word.hpp"
#include "grammar/compile.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/parse.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// One line as a source of its own, with what its names stand for.
struct ShellInputLine {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  grammar::ExpressionScope scope;
  base::SourceSpan whole;

  ShellInputLine(const std::string& text, const model::Model& model) {
    const std::int32_t file = sources.add_text("shell", text);
    whole = {file, 0, static_cast<std::uint32_t>(text.size())};
    scope.sources = &sources;
    scope.units = model.units;
    for (const auto& [name, value] : model.parameters) {
      scope.values.emplace(grammar::to_upper(name), value);
    }
  }
  [[nodiscard]] base::Trouble trouble() const {
    return located_failure(base::Outcome::usage, base::format_messages(sources, diagnostics));
  }
};

base::Trouble no_such(const std::string& what, const std::string& name,
                      const std::vector<std::string>& names) {
  return invalid_input(fmt::format("there is no {} '{}'", what, name),
                       base::suggest_spelling(name, names));
}

// Tips of cracks with two: NAME.1, NAME.2.
bool is_name(char letter, const std::string& name, const std::vector<std::string>& names) {
  const std::size_t dot = name.rfind('.');
  const bool tip = letter == 'c' && dot != std::string::npos &&
                   (name.substr(dot) == ".1" || name.substr(dot) == ".2");
  return std::ranges::find(names, tip ? name.substr(0, dot) : name) != names.end();
}

base::Trouble read_argument(char letter, const grammar::ParsedExpression& expression,
                            const model::Model& model, ShellInputLine& line,
                            model::ResultCheck& check) {
  if (letter == 'a' || letter == 'z') {
    const std::optional<double> value = grammar::evaluate(expression, line.scope, line.diagnostics);
    check.arguments.emplace_back(value.value_or(0.0));
    return value ? base::Trouble() : line.trouble();
  }
  const std::string written(line.sources.text(expression.span));
  if (expression.terms.size() != 1 ||
      expression.terms[0].kind != grammar::ExpressionTerm::ExpressionTermKind::name) {
    return invalid_input(
        fmt::format("a {} is expected, not '{}'", grammar::argument_word(letter), written));
  }
  const std::string name = grammar::to_upper(written);
  const std::vector<std::string> names = argument_names(letter, model);
  if (!is_name(letter, name, names)) {
    return no_such(grammar::argument_word(letter), name, names);
  }
  check.arguments.emplace_back(name);
  return {};
}

// "(crack, step, [number])"
std::string form_of(const grammar::ResultQuantity& quantity, int dim) {
  std::string text;
  bool optional = false;
  for (const char letter : quantity.arguments) {
    optional = optional || letter == '?';
    if (letter == '?' || (letter == 'z' && dim == 2)) {
      continue;
    }
    text += text.empty() ? "" : ", ";
    text += optional ? fmt::format("[{}]", grammar::argument_word(letter))
                     : grammar::argument_word(letter);
  }
  return fmt::format("{}({})", quantity.name, text);
}

std::size_t least(const grammar::ResultQuantity& quantity, int dim) {
  const std::string_view all = quantity.arguments.substr(0, quantity.arguments.find('?'));
  return all.size() - (dim == 2 && all.find('z') != std::string_view::npos ? 1 : 0);
}

} // namespace

std::string_view without_comment(std::string_view line) {
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

std::vector<ShellWord> shell_words(std::string_view line) {
  std::vector<ShellWord> words;
  const std::string_view text = without_comment(line);
  const auto offset = static_cast<std::size_t>(text.data() - line.data());
  int depth = 0;
  bool open = false; // a word has begun
  const auto add = [&](std::size_t i, char c) {
    if (!open) {
      words.push_back({"", offset + i, false});
      open = true;
    }
    words.back().text += c;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\'') {
      words.push_back({"", offset + i, true});
      for (++i; i < text.size() && text[i] != '\''; ++i) {
        words.back().text += text[i];
      }
      open = false;
      continue;
    }
    depth += c == '(' || c == '[' ? 1 : (c == ')' || c == ']' ? -1 : 0);
    if (depth <= 0 && (c == ' ' || c == '\t')) {
      open = false;
    } else if (depth <= 0 && c == '=') {
      open = false;
      add(i, c);
      open = false;
    } else {
      add(i, c);
    }
  }
  return words;
}

base::Trouble read_number(const std::string& text, const model::Model& model,
                          grammar::Quantity quantity, double& value) {
  ShellInputLine line(text, model);
  const std::optional<grammar::ParsedExpression> expression =
      grammar::parse_expression(line.sources, line.whole, line.diagnostics);
  if (!expression) {
    return line.trouble();
  }
  const base::SourceSpan unit = grammar::explicit_unit(*expression);
  const std::optional<base::PhysicalUnit> known =
      unit.valid() ? base::parse_unit(line.sources.text(unit)) : std::nullopt;
  if (known && known->dimension != grammar::quantity_dimension(quantity)) {
    line.diagnostics.error(unit, "E205",
                           fmt::format("'{}' is not the unit of {}", line.sources.text(unit),
                                       grammar::display_name(quantity)));
    return line.trouble();
  }
  const std::optional<double> found = grammar::evaluate(*expression, line.scope, line.diagnostics);
  value = found.value_or(0.0);
  return found ? base::Trouble() : line.trouble();
}

bool asks_quantity(std::string_view line) {
  line = without_comment(line);
  const char* end = grammar::scan_qualified_name(line.data(), line.data() + line.size());
  while (end != line.data() + line.size() && end != line.data() && *end == '.') {
    end = grammar::scan_qualified_name(end + 1, line.data() + line.size());
  }
  return end != line.data() && end != line.data() + line.size() && *end == '(';
}

std::vector<std::string> argument_names(char letter, const model::Model& model) {
  switch (letter) {
  case 'c':
    return crack_names(model);
  case 'p':
    return pair_names(model);
  case 's': {
    std::vector<std::string> names = step_names(model);
    names.insert(names.begin(), "NOW");
    return names;
  }
  case 'o':
    return load_case_names(model);
  case 'm':
    return material_names(model);
  case 'l':
    return path_names(model);
  case 'n':
    return mesh_set_names(model);
  case 'd':
    return {"X", "Y", "Z"};
  case 'e':
    return net_names(model);
  default:
    return {};
  }
}

base::Trouble read_quantity(const std::string& text, const model::Model& model,
                            model::ResultCheck& check) {
  ShellInputLine line(text, model);
  const std::vector<grammar::DataRow> rows =
      grammar::parse_rows(line.sources, line.whole, line.diagnostics);
  if (line.diagnostics.has_errors()) {
    return line.trouble();
  }
  if (rows.size() != 1 || rows[0].fields.size() != 1 ||
      rows[0].fields[0].kind != grammar::CardField::CardFieldKind::quantity) {
    return invalid_input("one result with its arguments is expected", "K1(CRACK, NOW)");
  }
  const grammar::CardField& field = rows[0].fields[0];
  const grammar::ResultQuantity* is = grammar::find_quantity(field.text);
  if (is == nullptr) {
    return no_such("result", field.text, quantity_names());
  }
  if (is->name == "N" || is->name == "LIFE" || is->name.starts_with("TEST.")) {
    return invalid_input(fmt::format("{} needs a growth run; the shell looks at states", is->name));
  }
  const int dim = model.mesh.dim;
  const std::string letters = argument_letters(*is, dim);
  const std::size_t count = field.arguments.size();
  if (count < least(*is, dim) || count > letters.size()) {
    return invalid_input(fmt::format("write {}", form_of(*is, dim)));
  }
  check = {};
  check.quantity = field.text;
  check.relative = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (base::Trouble trouble = read_argument(letters[i], field.arguments[i], model, line, check)) {
      return trouble;
    }
  }
  return {};
}

} // namespace spricka::program
