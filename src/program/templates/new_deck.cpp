// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/templates/new_deck.hpp"

#include "archive/safe_file.hpp"
#include "base/diagnostics.hpp"
#include "base/printable.hpp"
#include "base/shipped_files.hpp"
#include "deck/read_deck.hpp"
#include "grammar/lexeme.hpp"
#include "program/job/failures.hpp"
#include "program/job/log.hpp"
#include "program/job/standard_streams.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> template_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".deck") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

base::ProgramOutcome list_templates(const fs::path& folder) {
  std::string text;
  for (const std::string& name : template_names(folder)) {
    const DeckTemplate deck(folder / (name + ".deck"), TemplateUnits::millimetres);
    text += fmt::format("  {:<22} {}\n", name, deck.subject());
  }
  write_to_stdout(text + "\nspricka new NAME asks for the dimensions and writes NAME.deck\n");
  return base::ProgramOutcome::done;
}

/// "40 mm"; an expression, or a value with its own unit, as it is.
std::string value_with_unit(const TemplateDimension& dimension) {
  const bool number = dimension.value.find_first_not_of("0123456789.eE+-") == std::string::npos;
  return number && !dimension.unit.empty() ? dimension.value + " " + dimension.unit
                                           : dimension.value;
}

/// "d = 40 mm  diameter of the bore", a line for each.
std::string dimension_listing(const DeckTemplate& deck) {
  std::size_t width = 0;
  const auto value = [](const TemplateDimension& dimension) {
    return fmt::format("{} = {}", dimension.name, value_with_unit(dimension));
  };
  for (const TemplateDimension& dimension : deck.dimensions()) {
    width = std::max(width, value(dimension).size());
  }
  std::string text;
  for (const TemplateDimension& dimension : deck.dimensions()) {
    text += fmt::format("  {:<{}}  {}\n", value(dimension), width, dimension.meaning);
  }
  return text;
}

/// What is wrong with the deck of that text, reported to the log. Whether it is sound.
bool check_text(const fs::path& out, const std::string& text, const Log& log) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  deck::DeckReadOptions options;
  options.text = text;
  const bool sound = deck::read_deck(out, options, sources, diagnostics).has_value();
  log.report_diagnostics(sources, diagnostics);
  return sound;
}

/// Whether the first dimensions of a template are expressions; what is wrong is reported.
bool check_dimensions(const DeckTemplate& deck, std::size_t count, const Log& log) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  deck::DeckReadOptions options;
  options.text = deck.deck_of_dimensions(count);
  deck::read_deck("answer", options, sources, diagnostics);
  base::Diagnostics of_values; // not that the deck has no mesh
  for (const base::Diagnostic& message : diagnostics.messages()) {
    const bool of_value = message.code.starts_with("E1") || message.code.starts_with("E2");
    if (message.severity == base::Severity::error && of_value) {
      of_values.error(message.span, message.code, message.text, message.hint);
    }
  }
  log.report_diagnostics(sources, of_values);
  return !of_values.has_errors();
}

/// Asks for each dimension; an empty answer leaves its value. False at the end of the input.
bool ask_dimensions(DeckTemplate& deck, const std::vector<std::string>& given, const Log& log) {
  write_to_stdout(
      "Enter takes what stands in brackets; 15[ksi] or 2.5[in] is a value with a unit.\n");
  for (std::size_t i = 0; i < deck.dimensions().size(); ++i) {
    const TemplateDimension dimension = deck.dimensions()[i];
    if (std::ranges::find(given, grammar::to_upper(dimension.name)) != given.end()) {
      continue;
    }
    for (bool sound = false; !sound;) {
      write_to_stdout(fmt::format("  {}, {} [{}]: ", dimension.meaning, dimension.name,
                                  value_with_unit(dimension)));
      std::cout.flush();
      std::string answer;
      if (!std::getline(std::cin, answer)) {
        return false;
      }
      const std::size_t first = answer.find_first_not_of(" \t\r");
      deck.set_value(dimension.name,
                     first == std::string::npos
                         ? dimension.value
                         : answer.substr(first, answer.find_last_not_of(" \t\r") + 1 - first));
      sound = check_dimensions(deck, i + 1, log);
    }
  }
  return true;
}

/// The dimensions by -D. Empty after a name that the template does not have, which is told.
std::optional<std::vector<std::string>> apply_defines(DeckTemplate& deck,
                                                      const NewDeckOptions& options) {
  std::vector<std::string> names;
  for (const TemplateDimension& dimension : deck.dimensions()) {
    names.push_back(dimension.name);
  }
  std::vector<std::string> given;
  for (const auto& [name, value] : options.defines) {
    if (!deck.set_value(name, value)) {
      write_to_stderr(fmt::format("spricka new: {} has no dimension '{}'\n       = {}\n",
                                  options.name, base::make_printable(name),
                                  fmt::format("it has {}", fmt::join(names, ", "))));
      return std::nullopt;
    }
    given.push_back(grammar::to_upper(name)); // as the language takes it
  }
  return given;
}

fs::path deck_file(const NewDeckOptions& options) {
  fs::path out = options.out.empty() ? fs::path(options.name) : options.out;
  return out.has_extension() ? out : out.replace_extension(".deck");
}

void refuse_to_replace(const fs::path& out, const NewDeckOptions& options) {
  std::error_code unknown;
  if (!options.replace && fs::exists(out, unknown)) {
    throw archive::FileFailure("E464", fmt::format("there is a file {} already, and it is left as "
                                                   "it is; give another name, or --replace",
                                                   out.string()));
  }
}

base::ProgramOutcome write_new_deck(const fs::path& folder, const NewDeckOptions& options,
                                    const Log& log) {
  const fs::path out = deck_file(options);
  refuse_to_replace(out, options);
  DeckTemplate deck(folder / (options.name + ".deck"), options.units);
  std::optional<std::vector<std::string>> given = apply_defines(deck, options);
  if (!given) {
    return base::ProgramOutcome::usage;
  }
  const bool ask = !options.defaults && (options.ask || isatty(STDIN_FILENO) == 1);
  if (ask) {
    write_to_stdout(deck.subject() + "\n");
  }
  for (bool sound = false; !sound;) {
    if (ask && !ask_dimensions(deck, *given, log)) {
      write_to_stderr("\nspricka new: the answers end here; nothing is written\n");
      return base::ProgramOutcome::usage;
    }
    sound = check_text(out, deck.deck_text(), log);
    if (!sound && !ask) {
      write_to_stderr("spricka new: nothing is written\n");
      return base::ProgramOutcome::deck_error;
    }
    given->clear(); // a contradiction may lie in one that was given
  }
  report::write_file(out, deck.deck_text());
  const std::string name = base::make_printable(out.string());
  write_to_stdout(fmt::format("{}{}: {}\n{}Run it with: spricka run {}\n", ask ? "\n" : "", name,
                              deck.subject(), dimension_listing(deck), name));
  return base::ProgramOutcome::done;
}

} // namespace

base::ProgramOutcome new_deck(const NewDeckOptions& options) {
  const Log log(LogFormat::text);
  return run_reporting_file_failures(log, [&] {
    const fs::path folder = base::find_shipped_file("share/spricka/decks/templates");
    const std::vector<std::string> names = template_names(folder);
    if (names.empty()) {
      throw archive::FileFailure("E530", "the templates that ship with the program are not there");
    }
    if (options.name.empty()) {
      return list_templates(folder);
    }
    if (std::ranges::find(names, options.name) == names.end()) {
      const std::string hint = base::make_spelling_hint(options.name, names);
      write_to_stderr(
          fmt::format("spricka new: there is no template '{}'\n       = {}\n",
                      base::make_printable(options.name),
                      hint.empty() ? fmt::format("one of: {}", fmt::join(names, ", ")) : hint));
      return base::ProgramOutcome::usage;
    }
    return write_new_deck(folder, options, log);
  });
}

} // namespace spricka::program
