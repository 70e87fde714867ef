// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/command_tree.hpp"
#include "program/commands/deck_options.hpp"
#include "program/commands/positive.hpp"

#include <fmt/format.h>

namespace spricka::program {

namespace {

// --vary NAME=value,value
ParameterVariation request_of(const std::string& text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal == 0 || equal + 1 == text.size()) {
    throw CLI::ValidationError("--vary", "write --vary NAME=value,value, not '" + text + "'");
  }
  ParameterVariation request{text.substr(0, equal), {}};
  int depth = 0;
  request.values.emplace_back();
  for (const char c : text.substr(equal + 1)) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0) {
      request.values.emplace_back();
    } else {
      request.values.back() += c;
    }
  }
  return request;
}

// Those that study and ladder share; `extension`: of the folder without --out.
void add_variant_options(CLI::App& command, RunOptions& options, const std::string& extension,
                         int& jobs) {
  add_deck_options(command, options);
  add_path_option(command, "--out", options.out,
                  fmt::format("folder (default: the deck's name with {})", extension), "FOLDER");
  command
      .add_option("--jobs", jobs,
                  "runs at the same time; CPU times are reliable with 1 only (default)")
      ->check(CLI::Range(1, 64))
      ->type_name("NUMBER");
  add_engine_option(command, options.engine);
  command.add_flag("--quiet", options.quiet, "do not report each run as it ends");
  add_array_options(command, options.array, options.collect);
}

} // namespace

void CommandTree::add_study() {
  CLI::App& command =
      add("study", "run a deck in many settings: what an answer costs, and how right it is",
          "  spricka study lug.deck\n"
          "  spricka study lug.deck --time 60 --out lug_study\n"
          "  spricka study lug.deck --vary fine=0.5,1,2    this parameter and nothing else",
          [this] {
            study_.deck = run_;
            return study_deck(study_);
          });
  add_variant_options(command, run_, ".study", study_.jobs);
  command
      .add_option_function<std::vector<std::string>>(
          "--vary",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              study_.requests.push_back(request_of(text));
            }
          },
          "a parameter and its values, in place of what is found; may be given again")
      ->type_name("NAME=V,V,..")
      ->allow_extra_args(false);
  add_positive_option(command, "--time", study_.budget,
                      "CPU time of all runs together (default: 600)", "SECONDS");
}

void CommandTree::add_ladder() {
  CLI::App& command =
      add("ladder", "run ever simpler models of a joint and name the cheapest that is enough",
          "  spricka ladder lug.deck\n"
          "  spricka ladder lug.deck --tol 0.1\n"
          "  spricka run lug.ladder/cheapest.deck",
          [this] {
            ladder_.deck = run_;
            return run_simpler_models(ladder_);
          });
  add_variant_options(command, run_, ".ladder", ladder_.jobs);
  add_positive_option(command, "--tol", ladder_.tolerance,
                      "relative difference that the answers may have (default: 0.02)", "NUMBER");
}

} // namespace spricka::program
