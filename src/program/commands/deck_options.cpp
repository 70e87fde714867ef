// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/deck_options.hpp"

#include "mesh/link/mesher_limits.hpp"
#include "program/commands/positive.hpp"

namespace spricka::program {

namespace {

// -D NAME=expression
void add_define(const std::string& text,
                std::vector<std::pair<std::string, std::string>>& defines) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal == 0) {
    throw CLI::ValidationError("-D", "write -D NAME=expression, not '" + text + "'");
  }
  defines.emplace_back(text.substr(0, equal), text.substr(equal + 1));
}

void add_mesh_limits(CLI::App& command) {
  add_positive_option(command, "--mesh-time", mesh::mesher_limits().seconds,
                      "processor time that meshing one imported file may take (default: 12)",
                      "SECONDS");
  command
      .add_option_function<double>(
          "--mesh-memory",
          [](const double& gigabytes) {
            mesh::mesher_limits().memory = static_cast<std::size_t>(1e9 * gigabytes);
          },
          "memory that meshing may take (default: a quarter of the machine's)")
      ->check(positive_validator())
      ->type_name("GB");
}

} // namespace

void add_define_option(CLI::App& command, std::vector<std::pair<std::string, std::string>>& defines,
                       const std::string& doc) {
  command
      .add_option_function<std::vector<std::string>>(
          "-D",
          [&defines](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              add_define(text, defines);
            }
          },
          doc)
      ->type_name("NAME=EXPR")
      ->allow_extra_args(false);
}

void add_deck_options(CLI::App& command, RunOptions& options) {
  add_path_option(command, "DECK", options.deck, "the deck file", "").required();
  add_define_option(command, options.defines,
                    "overrides a parameter of the deck; may be given again");
  command
      .add_option_function<std::string>(
          "--log-format",
          [&options](const std::string& word) {
            options.log_format = word == "json" ? LogFormat::json : LogFormat::text;
          },
          "messages as text, or as JSON, one object a line")
      ->check(one_of_words_validator({"text", "json"}))
      ->type_name("text|json");
  add_mesh_limits(command);
}

void add_engine_option(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "what solves the equations (default: as $CONTROL says, else auto, by the memory "
                  "that they need)")
      ->check(one_of_words_validator({"auto", "cholesky", "mumps", "multigrid"}))
      ->type_name("auto|cholesky|mumps|multigrid");
}

void add_threads_option(CLI::App& command, int& threads, const std::string& doc) {
  command.add_option("--threads", threads, doc)
      ->check(whole_number_validator())
      ->type_name("NUMBER");
}

void add_array_options(CLI::App& command, std::optional<ArrayTask>& array, bool& collect) {
  CLI::Option* const task =
      command
          .add_option_function<std::string>(
              "--array",
              [&array](const std::string& text) {
                std::string why;
                array = parse_array_task(text, why);
                if (!array) {
                  throw CLI::ValidationError("--array", why);
                }
              },
              "the runs K, K+N, .. alone, as task K of N of a job array; slurm: as Slurm says")
          ->type_name("K/N|slurm");
  command
      .add_flag("--collect", collect,
                "run nothing: make the tables of what the tasks of --array have run, and name what "
                "is missing (exit code 6)")
      ->excludes(task);
}

} // namespace spricka::program
