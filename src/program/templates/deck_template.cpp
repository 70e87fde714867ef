// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/templates/deck_template.hpp"

#include "base/input_file.hpp"
#include "grammar/lexeme.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr std::string_view card_of_dimensions = "$PARAMETER\n";
constexpr std::string_view units_of_templates = "LENGTH=mm FORCE=N";
constexpr std::string_view inches_and_pounds = "LENGTH=in FORCE=lbf";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  const std::size_t last = text.find_last_not_of(' ');
  return first == std::string_view::npos ? std::string()
                                         : std::string(text.substr(first, last + 1 - first));
}

/// What a unit of inches and pounds is in millimetres and newtons.
std::string metric_unit(const std::string& unit) {
  return unit == "in" ? "mm" : unit == "lbf" ? "N" : unit == "psi" ? "MPa" : unit;
}

} // namespace

DeckTemplate::DeckTemplate(const std::filesystem::path& file, TemplateUnits units) {
  const std::string text = base::read_file(file, base::largest_deck);
  const std::size_t card = text.find(card_of_dimensions) + card_of_dimensions.size();
  const std::size_t end = text.find("\n$", card) + 1;
  before_ = text.substr(0, card);
  after_ = text.substr(end);
  for (std::size_t at = card; at < end;) {
    const std::size_t next = text.find('\n', at) + 1;
    read_dimension(text.substr(at, next - 1 - at), units);
    at = next;
  }
  const std::size_t metric = before_.find(units_of_templates);
  if (units == TemplateUnits::inches && metric != std::string::npos) {
    before_.replace(metric, units_of_templates.size(), inches_and_pounds);
  }
}

void DeckTemplate::read_dimension(const std::string& line, TemplateUnits units) {
  const std::size_t equal = line.find('=');
  const std::size_t mark = line.find('!');
  const std::size_t bar = line.find('|');
  TemplateDimension dimension;
  dimension.name = trimmed(line.substr(0, equal));
  dimension.value = trimmed(line.substr(equal + 1, mark - equal - 1));
  dimension.meaning =
      trimmed(line.substr(mark + 1, bar == std::string::npos ? bar : bar - mark - 1));
  if (bar != std::string::npos) {
    const std::string inch = trimmed(line.substr(bar + 1));
    const std::size_t blank = inch.rfind(' ');
    dimension.unit = inch.substr(blank + 1);
    if (units == TemplateUnits::inches) {
      dimension.value = inch.substr(0, blank);
    } else {
      dimension.unit = metric_unit(dimension.unit);
    }
  }
  dimensions_.push_back(std::move(dimension));
}

std::string DeckTemplate::subject() const {
  const std::size_t first = before_.find_first_not_of("! ");
  return before_.substr(first, before_.find('\n') - first);
}

bool DeckTemplate::set_value(std::string_view name, const std::string& value) {
  const auto found = std::ranges::find_if(dimensions_, [&](const TemplateDimension& dimension) {
    return grammar::to_upper(dimension.name) == grammar::to_upper(name);
  });
  if (found == dimensions_.end()) {
    return false;
  }
  found->value = value;
  return true;
}

std::string DeckTemplate::dimension_lines() const {
  std::size_t name_width = 0;
  std::size_t value_width = 0;
  for (const TemplateDimension& dimension : dimensions_) {
    name_width = std::max(name_width, dimension.name.size());
    value_width = std::max(value_width, dimension.value.size());
  }
  std::string lines;
  for (const TemplateDimension& dimension : dimensions_) {
    const std::string unit = dimension.unit.empty() ? "" : fmt::format(" [{}]", dimension.unit);
    lines += fmt::format("  {:<{}} = {:<{}}  ! {}{}\n", dimension.name, name_width, dimension.value,
                         value_width, dimension.meaning, unit);
  }
  return lines;
}

std::string DeckTemplate::deck_text() const {
  return before_ + dimension_lines() + after_;
}

std::string DeckTemplate::deck_of_dimensions(std::size_t count) const {
  const std::size_t deck = before_.find("$DECK");
  std::string text = before_.substr(deck);
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("  {} = {}\n", dimensions_[i].name, dimensions_[i].value);
  }
  return text + "$END\n";
}

} // namespace spricka::program
