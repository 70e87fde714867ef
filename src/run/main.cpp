// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"
#include "run/run_deck.hpp"

#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using spricka::run::RunOptions;

// -D NAME=expression
bool add_define(const std::string& text, RunOptions& options) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal == 0) {
    return false;
  }
  options.defines.emplace_back(text.substr(0, equal), text.substr(equal + 1));
  return true;
}

void add_deck_options(CLI::App& command, RunOptions& options, std::vector<std::string>& defines) {
  command.add_option("deck", options.deck, "the deck file")->required();
  command.add_option("-D", defines, "NAME=expression, overrides a parameter of the deck")
      ->allow_extra_args(false);
}

} // namespace

int main(int argc, char** argv) {
  spricka::base::return_large_blocks();
  CLI::App app{"spricka: contact and stress intensity factors in one solution"};
  app.set_version_flag("--version", "spricka " SPRICKA_VERSION);
  app.require_subcommand(1);
  RunOptions options;
  std::vector<std::string> defines;
  CLI::App* run = app.add_subcommand("run", "run a deck and write its run folder");
  add_deck_options(*run, options, defines);
  run->add_option("--out", options.out, "run folder (default: the deck's name with .run)");
  run->add_option("--threads", options.threads, "threads, 0 = all cores")
      ->check(CLI::NonNegativeNumber);
  run->add_flag("--quiet", options.quiet, "print messages only");
  CLI::App* check = app.add_subcommand("check", "read and check a deck without solving it");
  add_deck_options(*check, options, defines);
  try {
    app.parse(argc, argv);
    options.check_only = check->parsed();
    for (const std::string& define : defines) {
      if (!add_define(define, options)) {
        throw CLI::ValidationError("-D", "write -D NAME=expression, not '" + define + "'");
      }
    }
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? spricka::run::exit_code::done : spricka::run::exit_code::usage;
  }
  try {
    return spricka::run::run_deck(options);
  } catch (const std::exception& e) {
    fmt::print(stderr, "spricka: internal error: {}\n", e.what());
    return 70; // EX_SOFTWARE: a defect of the program, never of the deck
  }
}
