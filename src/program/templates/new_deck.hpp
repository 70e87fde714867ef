// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/templates/deck_template.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

struct NewDeckOptions {
  std::string name;                                         ///< of the template; empty: list them
  std::filesystem::path out;                                ///< empty: the template's name
  std::vector<std::pair<std::string, std::string>> defines; ///< dimensions that are not asked
  TemplateUnits units = TemplateUnits::millimetres;
  bool ask = false;      ///< although standard input is no terminal
  bool defaults = false; ///< ask nothing at a terminal either
  bool replace = false;  ///< a deck of that name that is there already
};

/// Writes a deck from a template that ships: asks for the dimensions of the drawing at a terminal,
/// else takes -D and the defaults, and says them. Dimensions that contradict each other are refused
/// by the deck's own $REQUIRE (deck_error; at a terminal they are asked again) and nothing is
/// written.
base::ProgramOutcome new_deck(const NewDeckOptions& options);

} // namespace spricka::program
