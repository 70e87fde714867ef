// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/catalogue.hpp"
#include "program/commands/program_text.hpp"

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string names_of(const std::vector<OptionText>& options) {
  std::string out;
  for (const OptionText& option : options) {
    for (const std::string& name : option.names) {
      out += option.positional ? "" : (out.empty() ? "" : " ") + name;
    }
  }
  return out;
}

std::string topics() {
  std::string out = "quantities functions units codes words";
  for (const grammar::CardSpec& card : grammar::card_catalogue()) {
    out += fmt::format(" {}", card.name);
  }
  return out;
}

bool takes_deck(const CommandText& command) {
  for (const OptionText& option : command.options) {
    if (option.positional && option.names.front() == "DECK") {
      return true;
    }
  }
  return false;
}

} // namespace

std::string bash_completion(const ProgramText& program) {
  std::string commands;
  std::string cases;
  for (const CommandText& command : program.commands) {
    commands += fmt::format("{}{}", commands.empty() ? "" : " ", command.name);
    cases += fmt::format("    {}) options='{}' deck={} ;;\n", command.name,
                         names_of(command.options), takes_deck(command) ? "yes" : "no");
  }
  return fmt::format(
      R"(# bash completion of spricka, made by `spricka completion bash`; do not edit.
_spricka_decks() {{
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -X '!*.deck' -- "$1"; compgen -d -- "$1")
}}
_spricka_words() {{
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}}
_spricka() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= options= deck=no i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${{COMP_WORDS[i]}} in
    -*) ;;
    *) command=${{COMP_WORDS[i]}}; break ;;
    esac
  done
  if [ -z "$command" ]; then
    _spricka_words '{commands} {options}' "$word"
    return
  fi
  case $command in
{cases}  esac
  case $before in
    --out) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
    --log-format) _spricka_words 'text json' "$word"; return ;;
    --engine) _spricka_words 'auto cholesky mumps multigrid' "$word"; return ;;
    --threads | -D) return ;;
  esac
  case $word in
    -*) _spricka_words "$options" "$word"; return ;;
  esac
  case $command in
    help) _spricka_words '{topics} {commands}' "${{word^^[a-z]}}"
          [ ${{#COMPREPLY[@]}} -gt 0 ] || _spricka_words '{topics} {commands}' "$word" ;;
    editor) _spricka_words 'vim vscode' "$word" ;;
    completion) _spricka_words 'bash' "$word" ;;
    *) [ $deck = no ] || _spricka_decks "$word" ;;
  esac
}}
complete -F _spricka spricka
)",
      fmt::arg("commands", commands), fmt::arg("options", names_of(program.options)),
      fmt::arg("cases", cases), fmt::arg("topics", topics()));
}

} // namespace spricka::program
