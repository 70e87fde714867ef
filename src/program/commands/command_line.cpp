// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/command_line.hpp"

#include "base/diagnostics.hpp"
#include "base/exit_codes.hpp"
#include "program/commands/command_tree.hpp"
#include "program/job/failures.hpp"
#include "program/job/log.hpp"
#include "program/job/standard_streams.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <csignal>
#include <exception>

#include <fmt/format.h>

namespace spricka::program {

namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

std::vector<std::string> command_names(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

// What was not understood, and what was probably meant.
base::OperationFailure explain(CommandTree& tree, const CLI::ParseError& error) {
  const CLI::App* command = tree.parsed_command();
  const CLI::App& place = command != nullptr ? *command : tree.app();
  const std::vector<std::string> extras = place.remaining();
  const auto option = std::find_if(extras.begin(), extras.end(), is_option);
  if (option != extras.end()) {
    const std::string name = option->substr(0, option->find('='));
    return invalid_input(fmt::format("there is no option {}", name),
                         base::make_spelling_hint(name, option_names(place)));
  }
  if (command == nullptr && !extras.empty() && extras.front().ends_with(".deck")) {
    return invalid_input("a command is missing",
                         fmt::format("did you mean spricka run {}?", extras.front()));
  }
  if (command == nullptr && !extras.empty()) {
    return invalid_input(fmt::format("there is no command '{}'", extras.front()),
                         base::make_spelling_hint(extras.front(), command_names(tree.app())));
  }
  if (command == nullptr) {
    return invalid_input("a command is missing",
                         fmt::format("one of: {}", fmt::join(command_names(tree.app()), ", ")));
  }
  if (!extras.empty()) {
    return invalid_input(fmt::format("'{}' is one argument too many", extras.front()));
  }
  return invalid_input(error.what());
}

base::ProgramOutcome report(CommandTree& tree, const CLI::ParseError& error) {
  const base::OperationFailure answer = explain(tree, error);
  const std::string called = tree.parsed_command() == nullptr
                                 ? "spricka"
                                 : fmt::format("spricka {}", tree.parsed_command()->get_name());
  write_to_stderr(fmt::format("{}: {}\n", called, answer.why));
  if (!answer.hint.empty()) {
    write_to_stderr(fmt::format("       = {}\n", answer.hint));
  }
  write_to_stderr(fmt::format("       = {} --help shows how it is called\n", called));
  return answer.kind;
}

} // namespace

namespace {

base::ProgramOutcome act(CommandTree& tree, int argc, const char* const* argv) {
  try {
    tree.app().parse(argc, argv);
  } catch (const CLI::Success& asked) { // --help, --version
    tree.app().exit(asked);
    return base::ProgramOutcome::done;
  } catch (const CLI::ParseError& error) {
    return report(tree, error);
  }
  try {
    return tree.execute_command();
  } catch (const std::exception& e) {
    if (is_out_of_memory(e)) {
      Log(tree.log_format()).report_message(base::Severity::error, "E466", out_of_memory_message());
      return base::ProgramOutcome::not_solvable;
    }
    write_to_stderr(fmt::format("spricka: internal error: {}\n", e.what()));
    return base::ProgramOutcome::defect;
  }
}

} // namespace

int run_command_line(int argc, const char* const* argv, const std::string& source_digest) {
  ensure_standard_streams_open();
  std::signal(SIGXFSZ, SIG_IGN); // the limit on the size of files: the write fails, and is told
  CommandTree tree(source_digest);
  const base::ProgramOutcome outcome = act(tree, argc, argv);
  const bool whole = check_streams_written(tree.log_format());
  return base::exit_code(outcome == base::ProgramOutcome::done && !whole
                             ? base::ProgramOutcome::file_trouble
                             : outcome);
}

} // namespace spricka::program
