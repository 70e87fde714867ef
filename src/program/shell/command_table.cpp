// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/command_table.hpp"

#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "grammar/catalogue.hpp"
#include "grammar/lexeme.hpp"
#include "program/shell/actions.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/trouble.hpp"
#include "program/shell/typed_words.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string usage_of(const ShellCommand& command) {
  return fmt::format("{}{}{}", command.word, command.arguments.empty() ? "" : " ",
                     command.arguments);
}

// Words of former versions, and what says the same now.
constexpr std::array former_words{
    std::pair{"length", "$CRACK NAME=C A0=5"},
    std::pair{"set", "NAME = EXPRESSION"},
    std::pair{"show", "list"},
    std::pair{"history", "list history"},
    std::pair{"K", "list K"},
    std::pair{"sensitivity", "list sensitivity"},
    std::pair{"pressure", "list pressure CONTACT, or CPRESS.AT(CONTACT,NOW,95[deg])"},
    std::pair{"arc", "ARC.FROM(CONTACT,NOW) and ARC.TO(CONTACT,NOW)"},
    std::pair{"reaction", "REACTION(SET,NOW,X)"},
    std::pair{"displacement", "U.X.AT(0,40,NOW)"},
    std::pair{"stress", "S.XX.AT(0,40,NOW)"},
};

base::OperationFailure unknown(const std::string& word) {
  for (const auto& [former, now] : former_words) {
    if (same_word(former, word)) {
      return invalid_input(fmt::format("'{}' is written otherwise: {}", former, now));
    }
  }
  std::string hint = base::make_spelling_hint(word, command_words());
  return invalid_input(fmt::format("there is no command '{}'", word),
                       hint.empty() ? "help lists them" : std::move(hint));
}

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
  return out + "\nA card with other keys is typed as in the deck: $CRACK NAME=TOP A0=(0.3*R); a "
               "parameter, too:\nF = 110[kN]. Any result that $CHECK can name is a question: "
               "K1(TOP,NOW), S.XX.AT(0,40,NOW).\nNOW is the present state, other steps are those "
               "of the deck.\n";
}

base::OptionalFailure help(const ShellCall& call) {
  if (call.words.size() < 2) {
    call.reply.out = help_text();
    return {};
  }
  const std::string& word = call.words[1];
  for (const ShellCommand& command : shell_commands()) {
    if (same_word(command.word, word)) {
      call.reply.out = fmt::format("{}: {}.\n", usage_of(command), command.doc);
      call.reply.out += command.more.empty() ? "" : fmt::format("{}\n", command.more);
      return {};
    }
  }
  const grammar::ResultQuantity* quantity = grammar::find_result_quantity(grammar::to_upper(word));
  if (quantity == nullptr) {
    return unknown(word);
  }
  call.reply.out = fmt::format("{}: {}\n", quantity->name, quantity->doc);
  return {};
}

// Half a sentence may be meant for something else.
base::OptionalFailure leave(const ShellCall& call) {
  if (call.words.size() > 1) {
    return invalid_input(fmt::format("use: {}", call.words.front()));
  }
  call.reply.quit = true;
  return {};
}

} // namespace

const std::vector<ShellCommand>& shell_commands() {
  static const std::vector<ShellCommand> all{
      {"help", "[COMMAND]", "w", "the commands, or what one of them or a result is", "", help},
      {"LOAD", "CASE FACTOR", "o.",
       "the factor of a load case, as in $STEP, from the next solve on",
       "Every question solves first what is pending.", do_add_step_action},
      {"FIT", "CONTACT FACTOR", "p.", "the factor of a declared fit, as in $STEP", "",
       do_add_step_action},
      {"MOUNT", "CONTACT", "p", "a contact comes into force, as in $STEP", "", do_add_step_action},
      {"DISMOUNT", "CONTACT", "p", "a contact is taken away", "", do_add_step_action},
      {"solve", "[SUBSTEPS]", ".", "makes the changes that are pending",
       "With friction from the last state on, in 10 substeps if nothing is said; else the state "
       "does not depend on the way to it.",
       do_solve},
      {"step", "NAME", "s", "goes to the state at the end of a step of the deck",
       "Loads, fits and mounts changed since are dropped; cards and parameters stay.",
       do_go_to_step},
      {"list", "[K [CRACK] | pressure CONTACT | sensitivity | history | CARD]", "qt",
       "what was changed and the state, a table, or cards as they are now",
       "K: stress intensity factors with their error bars, in space at all points. pressure: the "
       "points of a contact. sensitivity: what K changes by with loads, fits, moduli and lengths. "
       "history: what was typed so far. list STEP shows loads and fits, list CRACK the sizes.",
       do_list},
      {"map", "LOADPATH | CASE FROM TO", "M..",
       "K along a load, every breakpoint, without friction",
       "A load path runs over its t; a load case over its factor, all else as it is set.",
       do_follow_load_path},
      {"grow", "[anew]", ".", "the growth by $GROW: its stations, end and life",
       "Of the deck's own steps, with cards as they are now. Solved fronts serve other laws and "
       "spectra where these lead to them; anew solves all of them again.",
       do_grow},
      {"plot", "k|pressure|mesh|path FILE.svg [replace]", "kf", "a picture into a file",
       "k: K1 over the lengths tried with these loads and cards, in space K along the front; path: "
       "the last map. A file that is there is left as it is unless replace stands behind its name.",
       do_plot},
      {"save", "FILE.deck [replace]", "f", "the deck with what is set now in it",
       "Changed cards and parameters in their places, loads and fits in a step NOW; $GROW, $SWEEP, "
       "$RESTART, $TEST and checks of other values become comments. A file that is there is left "
       "as it is unless replace stands behind its name.",
       do_save},
      {"undo", "", "", "takes the last change back", "", do_undo},
      {"reset", "", "", "reads the deck again and begins anew", "", do_reset},
      {"quit", "", "", "leaves; so do exit and end of file (Ctrl-D)", "", leave},
  };
  return all;
}

std::vector<std::string> command_words() {
  std::vector<std::string> words;
  for (const ShellCommand& command : shell_commands()) {
    words.emplace_back(command.word);
  }
  return words;
}

namespace {

base::OptionalFailure act(ShellSession& session, const ShellHistory& history,
                          const std::string& line, ShellReply& reply) {
  if (base::OptionalFailure trouble = session.restore_after_failure()) {
    return trouble;
  }
  const ShellLineForm form = classify_shell_line(line);
  const std::string typed(strip_comment(line));
  if (form == ShellLineForm::result) {
    return evaluate_result_line(session, typed, reply);
  }
  if (form == ShellLineForm::card || form == ShellLineForm::parameter) {
    return apply_deck_change(session, typed, form == ShellLineForm::card, reply);
  }
  const std::vector<std::string> words = split_shell_words(line);
  const std::string_view word =
      same_word(words.front(), "exit") ? std::string_view("quit") : words.front();
  const auto command = std::ranges::find_if(
      shell_commands(), [&](const ShellCommand& c) { return same_word(c.word, word); });
  if (command == shell_commands().end()) {
    return unknown(words.front());
  }
  const std::string usage = usage_of(*command);
  return command->act({session, history, words, line, usage, reply});
}

} // namespace

ShellReply run_shell_line(ShellSession& session, const ShellHistory& history,
                          const std::string& line) {
  ShellReply reply;
  if (strip_comment(line).empty()) {
    return reply;
  }
  const base::Stopwatch watch;
  base::OptionalFailure trouble;
  try {
    trouble = act(session, history, line, reply);
  } catch (const std::system_error& file) {
    trouble =
        base::OperationFailure{.kind = base::ProgramOutcome::file_trouble, .why = file.what()};
  } catch (const std::range_error& engine) { // that iterates
    trouble =
        base::OperationFailure{.kind = base::ProgramOutcome::not_converged, .why = engine.what()};
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
      "{}{}{}{}> ", session.base_step_name(), session.changes().applied.empty() ? "" : "+",
      session.has_pending_changes() ? "*" : "", session.has_friction() ? " (path)" : "");
}

} // namespace spricka::program
