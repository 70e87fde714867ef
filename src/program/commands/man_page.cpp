// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/exit_codes.hpp"
#include "program/commands/program_text.hpp"
#include "program/shell/command_table.hpp"

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Text of roff: no line starts a request, and hyphens stay hyphens.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += "\\&";
    }
    out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return out;
}

std::string option_entry(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  }
  if (!option.value.empty() && !option.positional) {
    names += fmt::format(" \\fI{}\\fR", roff(option.value));
  }
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.doc));
}

std::string synopsis(const CommandText& command) {
  std::string out = fmt::format(".br\n\\fBspricka {}\\fR", roff(command.name));
  bool options = false;
  std::string arguments;
  for (const OptionText& option : command.options) {
    if (option.positional) {
      arguments += fmt::format(" {}\\fI{}\\fR{}", option.required ? "" : "[",
                               roff(option.names.front()), option.required ? "" : "]");
    } else {
      options = true;
    }
  }
  return out + (options ? " [\\fIoptions\\fR]" : "") + arguments + '\n';
}

std::string command_section(const CommandText& command) {
  std::string out = fmt::format(".SS spricka {}\n{}.\n", roff(command.name), roff(command.doc));
  for (const OptionText& option : command.options) {
    out += option_entry(option);
  }
  if (!command.examples.empty()) {
    out += fmt::format(".PP\n.nf\n.RS\n{}\n.RE\n.fi\n", roff(command.examples));
  }
  return out;
}

} // namespace

std::string man_page(const ProgramText& program) {
  std::string out = fmt::format(".TH SPRICKA 1 \"\" \"spricka {}\" \"User Commands\"\n"
                                ".SH NAME\nspricka \\- {}\n.SH SYNOPSIS\n",
                                program.version, roff(program.doc));
  for (const CommandText& command : program.commands) {
    out += synopsis(command);
  }
  out += ".SH DESCRIPTION\n"
         "A deck of cards describes bodies, contacts, cracks and steps; the program reads it, "
         "solves contact and\nstress intensity factors together, and writes a folder with listing, "
         "tables, pictures and a report.\n"
         "Results go to standard output, messages to standard error.\n.SH OPTIONS\n";
  for (const OptionText& option : program.options) {
    out += option_entry(option);
  }
  out += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands) {
    out += command_section(command);
  }
  out += ".SH COMMANDS AT THE PROMPT OF SPRICKA SHELL\n";
  for (const ShellCommand& command : shell_commands()) {
    out += fmt::format(".TP\n\\fB{}\\fR {}\n{}.\n", roff(command.word), roff(command.arguments),
                       roff(command.doc));
  }
  out += ".SH EXIT STATUS\n";
  for (const base::ExitCodeEntry& exit : base::exit_code_table) {
    out += fmt::format(".TP\n.B {}\n{}\n", exit.code, roff(exit.meaning));
  }
  out += ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nWhen set and not empty, messages have no colour. They "
         "have none either where standard error is no terminal.\n";
  return out;
}

} // namespace spricka::program
