// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/commands/commands.hpp"
#include "program/commands/convert.hpp"
#include "program/job/run_options.hpp"
#include "program/shell/shell.hpp"
#include "program/study/ladder.hpp"
#include "program/study/study.hpp"
#include "program/templates/new_deck.hpp"
#include "program/verify/verify.hpp"

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace spricka::program {

/// All commands with their options, and where CLI11 puts what the user gave. A new command is one
/// function that calls add() and a line in the constructor.
class CommandTree {
public:
  /// The digest of the sources is what cmake/source_digest prints.
  explicit CommandTree(const std::string& source_digest);
  CommandTree(const CommandTree&) = delete;
  CommandTree& operator=(const CommandTree&) = delete;

  [[nodiscard]] CLI::App& app() { return app_; }
  /// The command that was parsed; null without one.
  [[nodiscard]] const CLI::App* parsed_command() const;
  /// Runs it.
  [[nodiscard]] base::ProgramOutcome execute_command() const;
  /// How messages are wanted, as far as the command line has been read.
  [[nodiscard]] LogFormat log_format() const { return run_.log_format; }
  /// Everything in words, for completion and man page.
  [[nodiscard]] ProgramText describe_program() const;

private:
  struct Command {
    CLI::App* app = nullptr;
    std::string examples;
    std::function<base::ProgramOutcome()> act;
  };

  /// The command that was parsed; null without one.
  [[nodiscard]] const Command* find_parsed() const;
  CLI::App& add(const std::string& name, const std::string& doc, std::string examples,
                std::function<base::ProgramOutcome()> act);
  void add_run();
  void add_sweep();
  void add_check();
  void add_shell();
  void add_study();
  void add_ladder();
  void add_new();
  void add_convert();
  void add_verify();
  void add_help();
  void add_format();
  void add_for_editors();
  void add_for_the_system();

  CLI::App app_;
  std::vector<Command> commands_;
  RunOptions run_;
  ShellOptions session_;
  NewDeckOptions new_;
  ConvertOptions convert_;
  VerifyOptions verify_;
  StudyOptions study_;
  SimplerModelRunOptions ladder_;
  HelpOptions help_;
  FormatOptions format_;
  std::string editor_;
  std::string shell_;
};

} // namespace spricka::program
