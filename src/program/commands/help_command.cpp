// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnostics.hpp"
#include "base/result_concern.hpp"
#include "grammar/field_words.hpp"
#include "grammar/help.hpp"
#include "grammar/lexeme.hpp"
#include "grammar/wrap.hpp"
#include "program/commands/code_texts.hpp"
#include "program/commands/commands.hpp"
#include "program/commands/materials_help.hpp"
#include "program/job/standard_streams.hpp"

#include <cstdio>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string overview(std::size_t width) {
  return "The cards of the deck language, by group. spricka help CARD explains one of them.\n\n" +
         grammar::card_list_help(width) +
         "Words of damage tolerance lead on as well: spricka help flaw, bushing, beta, "
         "inspection;\n"
         "spricka help words lists them.\n\n"
         "More: spricka help quantities, functions, units, codes, materials (growth laws that\n"
         "ship), or an error code such as E108;\n"
         "spricka COMMAND --help for the commands.\n";
}

// What a warning says of the results.
std::string kind_of(const CodeMeaning& code) {
  return code.code.starts_with('W')
             ? std::string(base::display_word(base::concern_of_warning_code(code.code)))
             : std::string();
}

std::string code_help(const CodeMeaning& code, std::size_t width) {
  const std::string_view advice = message_code_advice(code.code);
  const std::string kind = kind_of(code);
  return fmt::format("{}: {}{}\n", code.code, code.meaning,
                     kind.empty() ? "" : fmt::format(" ({})", kind)) +
         (advice.empty() ? "" : grammar::wrap_paragraph(advice, 2, width));
}

std::string codes_help(std::size_t width) {
  grammar::TextColumns table{{}, {6, 0}};
  for (const CodeMeaning& code : all_message_codes()) {
    table.rows.push_back({std::string(code.code), std::string(code.meaning)});
  }
  return "Errors E and warnings W; spricka help E108 says more about one:\n" +
         table.format_columns(width);
}

// Codes whose meaning has a word, given in capitals.
std::string codes_with(const std::string& topic, std::size_t width) {
  grammar::TextColumns table{{}, {6, 0}};
  for (const CodeMeaning& code : all_message_codes()) {
    if (topic.size() > 2 && grammar::to_upper(code.meaning).find(topic) != std::string::npos) {
      table.rows.push_back({std::string(code.code), std::string(code.meaning)});
    }
  }
  return table.rows.empty() ? std::string() : table.format_columns(width);
}

std::string codes_markdown() {
  std::string out =
      "# Error codes\n\nMade by `spricka help codes --markdown`; do not edit. Codes are "
      "stable. On the terminal:\n`spricka help E108`.\n\n"
      "Warnings (W) are of three kinds, and the worst come first, on the terminal, in the listing "
      "and in the report:\n*no answer*, a number that answers nothing; *less exact*, a number "
      "that is off by more than others of its kind;\n*odd*, the number that the deck asks for, "
      "which may not be the one that is meant.\n\n"
      "| code | kind | meaning | what to do |\n|---|---|---|---|\n";
  for (const CodeMeaning& code : all_message_codes()) {
    out += fmt::format("| {} | {} | {} | {} |\n", code.code, kind_of(code), code.meaning,
                       message_code_advice(code.code));
  }
  return out;
}

std::optional<std::string> list_help(const std::string& topic, std::size_t width) {
  if (topic == "QUANTITIES") {
    return grammar::result_quantities_help(width);
  }
  if (topic == "FUNCTIONS") {
    return grammar::functions_help(width);
  }
  if (topic == "UNITS") {
    return grammar::units_help(width);
  }
  if (topic == "CODES") {
    return codes_help(width);
  }
  if (topic == "MATERIALS") {
    return list_shipped_growth_laws(width);
  }
  if (topic == "WORDS") {
    return grammar::list_damage_tolerance_terms(width);
  }
  return std::nullopt;
}

const CommandText* find_command(const ProgramText& program, std::string_view name) {
  for (const CommandText& command : program.commands) {
    if (grammar::to_upper(command.name) == name) {
      return &command;
    }
  }
  return nullptr;
}

// The help on a topic given in capitals, without $; empty when there is none.
std::optional<std::string> help_on(const std::string& topic, const ProgramText& program,
                                   std::size_t width) {
  const CommandText* command = find_command(program, topic);
  if (const grammar::CardSpec* card = grammar::find_card(topic)) {
    return grammar::card_help(*card, width) +
           (command == nullptr ? ""
                               : fmt::format("\nThe command: spricka {} --help\n", command->name));
  }
  if (auto list = list_help(topic, width)) {
    return list;
  }
  for (const CodeMeaning& code : all_message_codes()) {
    if (code.code == topic) {
      return code_help(code, width);
    }
  }
  if (const grammar::ResultQuantity* quantity = grammar::find_result_quantity(topic)) {
    return grammar::result_quantities_help(width, quantity);
  }
  if (std::string words = grammar::language_word_help(topic, width); !words.empty()) {
    return words;
  }
  if (command != nullptr) {
    return fmt::format("spricka {}: {}\n\nspricka {} --help says more.\n", command->name,
                       command->doc, command->name);
  }
  return std::nullopt;
}

// The help on a word of the language, on one of damage tolerance, or on both.
std::string help_or_field_help(const std::string& topic, const ProgramText& program,
                               std::size_t width) {
  std::string text = help_on(topic, program, width).value_or("");
  const std::string field = grammar::damage_tolerance_help(topic, width);
  text += text.empty() || field.empty() ? "" : "\n";
  return text + field;
}

std::string nearest(const std::string& topic, const ProgramText& program) {
  std::vector<std::string> known{"quantities", "functions", "units", "codes", "materials", "words"};
  for (const grammar::CardSpec& card : grammar::card_catalogue()) {
    known.emplace_back(card.name);
  }
  for (const grammar::ResultQuantity& quantity : grammar::result_quantities()) {
    known.emplace_back(quantity.name);
  }
  for (const CommandText& command : program.commands) {
    known.push_back(command.name);
  }
  for (const grammar::DamageToleranceTerm& word : grammar::damage_tolerance_terms()) {
    const auto names = grammar::term_synonyms(word);
    known.insert(known.end(), names.begin(), names.end());
  }
  return base::make_spelling_hint(topic, known);
}

} // namespace

base::ProgramOutcome help_command(const HelpOptions& options, const ProgramText& program) {
  const std::size_t width = text_columns();
  std::string topic = grammar::to_upper(options.topic);
  topic.erase(0, topic.starts_with('$') ? 1 : 0);
  if (options.markdown && (topic.empty() || topic == "CODES")) {
    write_to_stdout(topic.empty() ? grammar::card_reference_markdown() : codes_markdown());
    return base::ProgramOutcome::done;
  }
  if (topic.empty()) {
    write_to_stdout(overview(width));
    return base::ProgramOutcome::done;
  }
  if (const std::string text = help_or_field_help(topic, program, width); !text.empty()) {
    write_to_stdout(text);
    return base::ProgramOutcome::done;
  }
  if (const std::string found =
          grammar::search_help_texts(options.topic, width) + codes_with(topic, width);
      !found.empty()) {
    fmt::print("'{}' is no word of the language; it stands in the texts of\n{}", options.topic,
               found);
    return base::ProgramOutcome::done;
  }
  const std::string hint = nearest(topic, program);
  write_to_stderr(fmt::format("spricka help: nothing is known about '{}'\n{}", options.topic,
                              hint.empty() ? "       = spricka help lists the cards\n"
                                           : fmt::format("       = {}\n", hint)));
  return base::ProgramOutcome::usage;
}

} // namespace spricka::program
