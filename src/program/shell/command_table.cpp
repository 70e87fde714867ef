// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/command_table.hpp"

#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "grammar/lexeme.hpp"
#include "program/shell/actions.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/plots.hpp"
#include "program/shell/reply_text.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return out;
}

std::vector<std::string> command_words() {
  std::vector<std::string> words;
  for (const ShellCommand& command : shell_commands()) {
    words.emplace_back(command.word);
  }
  return words;
}

std::string usage_of(const ShellCommand& command) {
  return fmt::format("{}{}{}", command.word, command.arguments.empty() ? "" : " ",
                     command.arguments);
}

base::OperationFailure unknown(const std::string& word) {
  const std::vector<std::string> words = command_words();
  std::string hint = base::suggest_spelling(word, words);
  return invalid_input(fmt::format("there is no command '{}'", word),
                       hint.empty() ? "help lists them" : std::move(hint));
}

} // namespace

const std::vector<ShellCommand>& shell_commands() {
  static const std::vector<ShellCommand> all{
      {"help", "[COMMAND]", "w", "the commands, or what one of them does", ""},
      {"show", "", "", "loads, fits, lengths and steps as they are set", ""},
      {"step", "NAME", "s", "goes to the state at the end of a step of the deck",
       "Changes made since are dropped; lengths, interferences and parameters stay."},
      {"load", "CASE FACTOR", "o.", "the factor of a load case, from the next solve on",
       "Every question solves first what is pending."},
      {"fit", "CONTACT FACTOR | CONTACT = INTERFERENCE", "p.",
       "the factor of a declared fit, or the interference itself",
       "fit BUSH 1.2 scales what the deck declares, as FIT of $STEP does. fit BUSH = 0.05[mm] sets "
       "the normal interference itself (on the radius), negative: a clearance; its factor becomes "
       "1, and the way is solved again from its beginning."},
      {"mount", "CONTACT", "p", "a contact comes into force, as MOUNT of $STEP", ""},
      {"dismount", "CONTACT", "p", "a contact is taken away", ""},
      {"length", "CRACK A [C]", "c..",
       "cuts a crack to another length and solves the same way again",
       "What the crack does not touch stays condensed. In space A and C are the axes of an "
       "ellipse; "
       "without C their ratio is kept."},
      {"set", "NAME = EXPRESSION", "v.", "a parameter of the deck, which is read again",
       "What was set by name is kept, and a note says where it hides the parameter."},
      {"solve", "[SUBSTEPS]", ".", "makes the changes that are pending",
       "With friction from the last state on, in 10 substeps if nothing is said; else the state "
       "does not depend on the way to it."},
      {"K", "[CRACK]", "c", "stress intensity factors with their error bars",
       "In space the points of each front with the smallest and the largest K1, of a crack that is "
       "named all points."},
      {"pressure", "CONTACT [THETA | X Y [Z]]", "p...",
       "pressure along a contact, at an angle of a bore, or near a point",
       "An angle without a unit is in radians, as in the deck: pressure BUSH 95[deg]."},
      {"arc", "CONTACT", "p", "where a contact is closed, part by part", ""},
      {"reaction", "SET", "n", "force of the supports on a set", ""},
      {"displacement", "X Y [Z]", "...", "displacement at a point", ""},
      {"stress", "X Y [Z]", "...", "stresses at a point", ""},
      {"map", "LOADPATH | CASE FROM TO", "M..",
       "K along a load, every breakpoint, without friction",
       "A load path runs over its t; a load case over its factor, all else as it is set."},
      {"sensitivity", "", "", "what K changes by with loads, fits, moduli and lengths", ""},
      {"plot", "k|pressure|mesh|path FILE.svg [replace]", "kf", "a picture into a file",
       "k: K1 over the lengths tried with these loads and fits, in space K along the front; path: "
       "the "
       "last map. A file that is there is left as it is unless replace stands behind its name."},
      {"save", "FILE.deck [replace]", "f", "the deck with what is set now in it",
       "Lengths, interferences and parameters in their cards, loads and fits in a step NOW; $GROW, "
       "$SWEEP, $RESTART and checks of other values become comments. A file that is there is left "
       "as "
       "it is unless replace stands behind its name."},
      {"reset", "", "", "reads the deck again and begins anew", ""},
      {"history", "", "", "what was typed so far", ""},
      {"quit", "", "", "leaves; so does end of file (Ctrl-D)", ""},
  };
  return all;
}

namespace {

std::string help_text() {
  std::size_t width = 0;
  for (const ShellCommand& command : shell_commands()) {
    width = std::max(width, std::min<std::size_t>(usage_of(command).size(), 32));
  }
  std::string out;
  for (const ShellCommand& command : shell_commands()) {
    const std::string usage = usage_of(command);
    out += usage.size() > width ? fmt::format("{}\n{:<{}}  {}\n", usage, "", width, command.doc)
                                : fmt::format("{:<{}}  {}\n", usage, width, command.doc);
  }
  return out + "\nAny result that $CHECK can name may be typed: K1(TOP,NOW), S.XX.AT(0,40,NOW). "
               "NOW is the\npresent state, other steps are those of the deck. Numbers are "
               "expressions: 0.3*R, 5[kN].\n";
}

base::Trouble help(const std::string& word, std::string& out) {
  if (word.empty()) {
    out = help_text();
    return {};
  }
  for (const ShellCommand& command : shell_commands()) {
    if (same_word(command.word, word)) {
      out = fmt::format("{}: {}.\n", usage_of(command), command.doc);
      out += command.more.empty() ? "" : fmt::format("{}\n", command.more);
      return {};
    }
  }
  const grammar::ResultQuantity* quantity = grammar::find_quantity(grammar::to_upper(word));
  if (quantity != nullptr) {
    out = fmt::format("{}: {}\n", quantity->name, quantity->doc);
    return {};
  }
  return unknown(word);
}

// Half a sentence may be meant for something else.
base::Trouble leave(const std::vector<ShellWord>& words, ShellReply& reply) {
  if (words.size() > 1) {
    return invalid_input(fmt::format("use: {}", words.front().text));
  }
  reply.quit = true;
  return {};
}

base::Trouble act(ShellSession& session, const ShellHistory& history, const std::string& line,
                  ShellReply& reply) {
  if (base::Trouble trouble = session.restore_after_failure()) {
    return trouble;
  }
  if (asks_quantity(line)) {
    return answer_quantity(session, std::string(without_comment(line)), reply);
  }
  const std::vector<ShellWord> words = shell_words(line);
  const auto command = std::ranges::find_if(shell_commands(), [&](const ShellCommand& c) {
    return same_word(c.word, words.front().text);
  });
  if (command == shell_commands().end()) {
    if (same_word(words.front().text, "exit")) {
      return leave(words, reply);
    }
    return unknown(words.front().text);
  }
  if (command->word == "help") {
    return help(words.size() > 1 ? words[1].text : std::string(), reply.out);
  }
  if (command->word == "history") {
    for (std::size_t i = 0; i < history.size(); ++i) {
      reply.out += fmt::format("{:4}  {}\n", i + 1, history[i]);
    }
    return {};
  }
  if (command->word == "quit") {
    return leave(words, reply);
  }
  const ShellCall call{session, words, line, usage_of(*command), reply};
  return run_shell_command(command->word, call);
}

} // namespace

ShellReply run_shell_line(ShellSession& session, const ShellHistory& history,
                          const std::string& line) {
  ShellReply reply;
  if (without_comment(line).empty()) {
    return reply;
  }
  const base::Stopwatch watch;
  base::Trouble trouble;
  try {
    trouble = act(session, history, line, reply);
  } catch (const std::system_error& file) {
    trouble = base::OperationFailure{.kind = base::Outcome::file_trouble, .why = file.what()};
  }
  if (trouble) {
    reply.outcome = trouble->kind;
    if (trouble->complete) {
      reply.messages += trouble->why;
    } else {
      reply.messages += fmt::format("error: {}\n", trouble->why);
      reply.messages += trouble->hint.empty() ? "" : fmt::format("     = {}\n", trouble->hint);
    }
  }
  reply.cpu = watch.cpu_time();
  return reply;
}

namespace {

std::vector<std::string> candidates(const ShellSession& session, char letter) {
  const model::Model& model = session.model();
  switch (letter) {
  case 'w':
    return command_words();
  case 'k':
    return picture_kinds();
  case 'v':
    return parameter_names(model);
  case 's':
    return step_names(model);
  case 'M': {
    std::vector<std::string> names = path_names(model);
    const std::vector<std::string> cases = load_case_names(model);
    names.insert(names.end(), cases.begin(), cases.end());
    return names;
  }
  default:
    return argument_names(letter, model);
  }
}

std::string as_typed(const std::string& name, std::string_view typed) {
  const bool small = !typed.empty() && typed.front() >= 'a' && typed.front() <= 'z';
  return small ? lower(name) : name;
}

std::vector<std::string> beginning_with(const std::vector<std::string>& names,
                                        std::string_view typed, bool keep_case) {
  std::vector<std::string> out;
  for (const std::string& name : names) {
    if (name.size() >= typed.size() && same_word(name.substr(0, typed.size()), typed)) {
      out.push_back(keep_case ? name : as_typed(name, typed));
    }
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

} // namespace

std::vector<std::string> complete_shell_line(const ShellSession& session, std::string_view line,
                                             std::size_t begin) {
  const std::string_view typed = line.substr(std::min(begin, line.size()));
  const std::string_view before = line.substr(0, std::min(begin, line.size()));
  const std::size_t bracket = before.find('(');
  if (bracket != std::string_view::npos && asks_quantity(before)) { // an argument of a quantity
    const std::string name = grammar::to_upper(without_comment(before.substr(0, bracket)));
    const grammar::ResultQuantity* is = grammar::find_quantity(name);
    const auto at = static_cast<std::size_t>(std::ranges::count(before, ','));
    const std::string letters =
        is == nullptr ? "" : argument_letters(*is, session.model().mesh.dim);
    return at < letters.size()
               ? beginning_with(argument_names(letters[at], session.model()), typed, false)
               : std::vector<std::string>();
  }
  const std::vector<ShellWord> words = shell_words(before);
  if (words.empty()) {
    std::vector<std::string> names = beginning_with(command_words(), typed, true);
    if (!typed.empty()) {
      const std::vector<std::string> more = beginning_with(quantity_names(), typed, false);
      names.insert(names.end(), more.begin(), more.end());
    }
    return names;
  }
  const ShellCommand* command = nullptr;
  for (const ShellCommand& c : shell_commands()) {
    command = same_word(c.word, words.front().text) ? &c : command;
  }
  const std::size_t at = words.size() - 1;
  if (command == nullptr || at >= command->letters.size() || command->letters[at] == '.' ||
      command->letters[at] == 'f') {
    return {};
  }
  const char letter = command->letters[at];
  return beginning_with(candidates(session, letter), typed,
                        letter == 'w' || letter == 'k' || letter == 'v');
}

std::string shell_commands_markdown() {
  std::string out = "| command | what it does |\n|---|---|\n";
  for (const ShellCommand& command : shell_commands()) {
    std::string usage = usage_of(command);
    for (std::size_t at = 0; (at = usage.find('|', at)) != std::string::npos; at += 2) {
      usage.insert(at, "\\");
    }
    out += fmt::format("| `{}` | {}{}{} |\n", usage, command.doc, command.more.empty() ? "" : ". ",
                       command.more);
  }
  return out;
}

std::string shell_prompt(const ShellSession& session) {
  return fmt::format(
      "{}{}{}{}> ", session.base_step(), session.applied_changes().empty() ? "" : "+",
      session.has_pending_changes() ? "*" : "", session.has_friction() ? " (path)" : "");
}

} // namespace spricka::program
