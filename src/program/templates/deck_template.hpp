// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::program {

enum class TemplateUnits { millimetres, inches };

/// A size of the drawing that a template asks for.
struct TemplateDimension {
  std::string name;    ///< of the deck's parameter
  std::string value;   ///< as it stands in the deck: a number or an expression, perhaps with a unit
  std::string meaning; ///< "diameter of the bore"
  std::string unit;    ///< of a bare number; empty for one without
};

/// A deck that ships as the beginning of one's own. It is a deck that runs as it stands, in mm and
/// N. Each parameter of its first $PARAMETER card is a dimension: `name = value ! meaning`, behind
/// the meaning `| value unit` for who works in inches and pounds.
class DeckTemplate {
public:
  /// Throws std::system_error.
  DeckTemplate(const std::filesystem::path& file, TemplateUnits units);

  /// What the comment at the head of the deck says first.
  [[nodiscard]] std::string subject() const;
  [[nodiscard]] const std::vector<TemplateDimension>& dimensions() const { return dimensions_; }
  /// Gives a dimension another value. False if there is none of that name, in whatever case.
  bool set_value(std::string_view name, const std::string& value);
  /// The deck with its values, in its units.
  [[nodiscard]] std::string deck_text() const;
  /// A deck of the dimensions alone, to see whether their values are expressions.
  [[nodiscard]] std::string deck_of_dimensions(std::size_t count) const;

private:
  [[nodiscard]] std::string dimension_lines() const;
  void read_dimension(const std::string& line, TemplateUnits units);

  std::string before_; ///< text of the deck up to the dimensions, with the units of choice
  std::string after_;
  std::vector<TemplateDimension> dimensions_;
};

} // namespace spricka::program
