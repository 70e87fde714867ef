// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/command_tree.hpp"
#include "base/exit_codes.hpp"
#include "program/commands/deck_options.hpp"
#include "program/commands/positive.hpp"
#include "program/commands/run_deck.hpp"
#include "program/job/standard_streams.hpp"

#include "archive/version.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr const char* k_about = "contact and stress intensity factors in one solution";

std::string exit_footer() {
  std::string out = "Exit codes:\n";
  for (const base::ExitCodeEntry& exit : base::exit_code_table) {
    out += fmt::format("  {:<3} {}\n", exit.code, exit.meaning);
  }
  return out + "\nThe deck language: spricka help";
}

OptionText describe(const CLI::Option& option) {
  OptionText text;
  text.positional = option.get_positional();
  text.required = option.get_required();
  text.doc = option.get_description();
  if (text.positional) {
    text.names.push_back(option.get_single_name());
    return text;
  }
  for (const std::string& name : option.get_snames()) {
    text.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    text.names.push_back("--" + name);
  }
  text.value = option.get_items_expected_max() > 0 ? option.get_type_name() : std::string();
  return text;
}

std::vector<OptionText> describe_options(const CLI::App& app) {
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app.get_options()) {
    texts.push_back(describe(*option));
  }
  return texts;
}

void add_verify_options(CLI::App& command, VerifyOptions& options) {
  command
      .add_option("WHAT", options.asked,
                  "a tier, quick or all, names of decks or shell patterns (default: quick)")
      ->type_name("");
  add_path_option(command, "--out", options.out,
                  "folder of verification.html and verification.csv (default: verification)",
                  "FOLDER");
  add_path_option(command, "--before", options.before,
                  "table to compare with (default: the one that is in the folder)", "FILE");
  command.add_option("--jobs", options.at_once, "decks at a time (default: as many as cores)")
      ->check(whole_number_validator())
      ->type_name("NUMBER");
  add_engine_option(command, options.engine);
  add_path_option(command, "--decks", options.decks, "another folder of decks", "FOLDER");
  add_path_option(command, "--markdown", options.markdown,
                  "write the page of the manual, too, and its table beside it, as .csv", "FILE");
  command.add_flag("--list", options.list, "print the decks and run none");
  command.add_flag("--keep", options.keep, "keep the run folders, beside the page");
  command.add_flag("--costs", options.costs,
                   "write what the decks cost into costs.csv, which the tiers follow from");
  command.add_flag("--quiet", options.quiet, "print what failed and the sum only");
}

// Those that run and sweep share.
void add_run_options(CLI::App& command, RunOptions& options) {
  add_deck_options(command, options);
  add_path_option(command, "--out", options.out, "run folder (default: the deck's name with .run)",
                  "FOLDER");
  add_threads_option(command, options.threads,
                     "threads, 0: all cores; no result depends on it (default: what Slurm gives, "
                     "else $CONTROL)");
  add_engine_option(command, options.engine);
  command.add_flag("--quiet", options.quiet, "print messages only");
  command.add_flag("--restart", options.restart,
                   "continue from the file that $RESTART WRITE names, if it exists");
  command.add_flag(
      "--profile", options.profile,
      "measure time, flops and memory by stage, net and crack length, beside one plain "
      "factorisation; writes profile.csv and trace.json");
  add_positive_option(
      command, "--time", options.seconds,
      "limit of wall time: a crack length that would not fit is not begun, exit code 6", "SECONDS");
}

} // namespace

CommandTree::CommandTree(const std::string& source_digest)
    : app_(fmt::format("spricka: {}", k_about), "spricka") {
  app_.set_version_flag(
      "--version",
      [source_digest] {
        return fmt::format("{}\n  {:<14} {}", archive::version_text(), "source", source_digest);
      },
      "version of the program and its libraries, digest of its sources");
  app_.get_help_ptr()->description("this text");
  app_.require_subcommand(1);
  app_.footer(exit_footer());
  add_run();
  add_check();
  add_sweep();
  add_shell();
  add_study();
  add_ladder();
  add_new();
  add_convert();
  add_verify();
  add_help();
  add_format();
  add_for_editors();
  add_for_the_system();
}

CLI::App& CommandTree::add(const std::string& name, const std::string& doc, std::string examples,
                           std::function<base::ProgramOutcome()> act) {
  CLI::App* command = app_.add_subcommand(name, doc);
  command->get_help_ptr()->description("this text");
  command->footer("Examples:\n" + examples);
  commands_.push_back({command, std::move(examples), std::move(act)});
  return *command;
}

void CommandTree::add_run() {
  CLI::App& command = add("run", "run a deck and write its run folder",
                          "  spricka run lug.deck\n"
                          "  spricka run lug.deck -D 'F=80[kN]' -D fine=2 --out lug_80\n"
                          "  spricka run lug.deck --threads 4 --log-format json 2> lug.log\n"
                          "  spricka run lug.deck --profile               what the time goes into\n"
                          "  spricka run lug.deck --restart --time 3500   in a job queue",
                          [this] { return run_deck(run_); });
  add_run_options(command, run_);
}

void CommandTree::add_sweep() {
  CLI::App& command =
      add("sweep", "run all points of a deck with $SWEEP, or those of one task of a job array",
          "  spricka sweep lug.deck                   as spricka run does\n"
          "  spricka sweep lug.deck --array 3/8       points 3, 11, 19, .. alone\n"
          "  sbatch --array=1-8 job.sh                with, in job.sh:\n"
          "  spricka sweep lug.deck --array slurm\n"
          "  parallel spricka sweep lug.deck --array {}/8 ::: 1 2 3 4 5 6 7 8\n"
          "  spricka sweep lug.deck --collect         tables of what the tasks have run",
          [this] {
            run_.sweep_only = true;
            return run_deck(run_);
          });
  add_run_options(command, run_);
  add_array_options(command, run_.array, run_.collect);
}

void CommandTree::add_check() {
  CLI::App& command = add("check", "report all that can be known of a deck without solving it",
                          "  spricka check lug.deck\n"
                          "  spricka check lug.deck --forecast --json | jq .forecast\n"
                          "  spricka check lug.deck --log-format json 2>&1 >/dev/null | jq .text",
                          [this] {
                            run_.check_only = true;
                            return run_deck(run_);
                          });
  add_deck_options(command, run_);
  add_threads_option(command, run_.threads,
                     "threads that the forecast of the run assumes, 0: all cores");
  add_engine_option(command, run_.engine);
  command.add_flag("--forecast", run_.exact_forecast,
                   "analyse the matrices: fill, flops and memory exactly, not by a rough law");
  command.add_flag("--json", run_.json, "print what was found as JSON");
}

void CommandTree::add_shell() {
  CLI::App& command =
      add("shell", "try loads, fits and crack lengths of a deck at a prompt",
          "  spricka shell lug.deck\n"
          "  printf '$CRACK NAME=TOP A0=(0.3*R)\\nlist K\\n' | spricka shell lug.deck\n"
          "  spricka shell lug.deck --strict < questions.txt > answers.txt",
          [this] {
            session_.deck = run_;
            return program::run_shell(session_);
          });
  add_deck_options(command, run_);
  add_threads_option(command, run_.threads, "threads, 0: all cores; no result depends on it");
  add_engine_option(command, run_.engine);
  command.add_flag("--strict", session_.strict,
                   "end with the exit code of the first command that fails");
  command.add_flag("--quiet", run_.quiet, "do not print what each answer cost");
}

void CommandTree::add_new() {
  CLI::App& command = add("new", "write a deck for a joint from the dimensions of its drawing",
                          "  spricka new                         what there is\n"
                          "  spricka new bushed-lug              asks, and writes bushed-lug.deck\n"
                          "  spricka new lug joint7 -D d=36 -D 'F=50[kN]' --defaults\n"
                          "  spricka new surface-crack --units in",
                          [this] { return new_deck(new_); });
  command.add_option("TEMPLATE", new_.name, "what is drawn; without it they are listed")
      ->type_name("");
  add_path_option(command, "FILE", new_.out, "the deck to write (default: the template's name)",
                  "");
  add_define_option(command, new_.defines, "a dimension, which is not asked; may be given again");
  command
      .add_option_function<std::string>(
          "--units",
          [this](const std::string& word) {
            new_.units = word == "in" ? TemplateUnits::inches : TemplateUnits::millimetres;
          },
          "mm, N and MPa, or inches, pounds and psi (default: mm)")
      ->check(one_of_words_validator({"mm", "in"}))
      ->type_name("mm|in");
  CLI::Option* defaults =
      command.add_flag("--defaults", new_.defaults, "ask nothing: take the defaults and say them");
  command.add_flag("--ask", new_.ask, "ask although standard input is no terminal")
      ->excludes(defaults);
  command.add_flag("--replace", new_.replace, "overwrite the deck if it exists");
}

void CommandTree::add_convert() {
  CLI::App& command = add("convert", "write a mesh or deck in another format",
                          "  spricka convert lug.deck lug.vtu      the mesh, for ParaView\n"
                          "  spricka convert plate.inp plate.msh   for gmsh\n"
                          "  spricka convert plate.deck plate.inp  the first step, for ccx\n"
                          "  spricka convert joint.inp joint.deck  its contact, ties, supports as "
                          "cards",
                          [this] {
                            convert_.in = run_.deck;
                            convert_.defines = run_.defines;
                            convert_.log_format = run_.log_format;
                            return convert_mesh_or_deck(convert_);
                          });
  add_deck_options(command, run_);
  command.get_option("DECK")->description("a deck, a mesh .msh, .geo, .inp or of Nastran, or STEP");
  command.add_flag("--replace", convert_.replace, "overwrite OUT if it exists");
  add_path_option(command, "OUT", convert_.out,
                  "the file to write; its ending is the format: .msh, .vtu, .inp, of an .inp .deck",
                  "")
      .required();
}

void CommandTree::add_verify() {
  CLI::App& command =
      add("verify", "run the decks that ship and compare them with their references",
          "  spricka verify                    the cheap ones, in less than a minute\n"
          "  spricka verify all                every deck, in less than ten\n"
          "  spricka verify 'hertz*' kirsch    by name\n"
          "  spricka verify all --list         which there are, and what they cost\n"
          "  spricka verify all --array 3/8    the third of eight tasks; then --collect\n"
          "  spricka verify all --out new --before old/verification.csv",
          [this] { return verify_decks(verify_); });
  add_verify_options(command, verify_);
  add_array_options(command, verify_.array, verify_.collect);
}

void CommandTree::add_help() {
  CLI::App& command =
      add("help", "explain a card, a key, a result, an error code or a word of the field",
          "  spricka help                all cards by group\n"
          "  spricka help contact        the card $CONTACT\n"
          "  spricka help diametral      a key or word, wherever it stands\n"
          "  spricka help quantities     what $CHECK can name\n"
          "  spricka help functions      of expressions\n"
          "  spricka help units          of numbers\n"
          "  spricka help E108           an error code; codes: all of them\n"
          "  spricka help bushing        a word of damage tolerance; words: all of them\n"
          "  spricka help --markdown     the card reference of the manual",
          [this] { return help_command(help_, describe_program()); });
  command
      .add_option_function<std::vector<std::string>>(
          "TOPIC",
          [this](const std::vector<std::string>& words) {
            help_.topic = fmt::format("{}", fmt::join(words, " "));
          },
          "a card, key, result, error code or word of damage tolerance, or one of quantities, "
          "functions, units, codes, materials, words")
      ->type_name("");
  command.add_flag("--markdown", help_.markdown, "the card reference, or that of codes");
}

void CommandTree::add_format() {
  CLI::App& command =
      add("format", "write a deck in the canonical layout",
          "  spricka format lug.deck               to the terminal\n"
          "  spricka format --in-place lug.deck    rewrites the file\n"
          "  spricka format --check lug.deck       for scripts: 1 if it would change\n"
          "  spricka format - < lug.deck           as a filter, for editors",
          [this] { return format_command(format_); });
  add_path_option(command, "DECK", format_.deck, "the deck file, - for standard input", "")
      .required();
  CLI::Option* in_place = command.add_flag("--in-place", format_.in_place, "rewrite the file");
  command.add_flag("--check", format_.check, "write nothing; end with 1 if the file would change")
      ->excludes(in_place);
}

void CommandTree::add_for_editors() {
  add("schema", "print the whole language as JSON",
      "  spricka schema | jq -r '.cards[] | .name + \": \" + .doc'", schema_command);
  CLI::App& editor = add("editor", "print a syntax file for an editor",
                         "  spricka editor vim > ~/.vim/syntax/spricka.vim\n"
                         "  spricka editor vscode > spricka.tmLanguage.json",
                         [this] { return editor_command(editor_); });
  editor.add_option("EDITOR", editor_, "vim or vscode")
      ->required()
      ->check(one_of_words_validator({"vim", "vscode"}))
      ->type_name("");
}

void CommandTree::add_for_the_system() {
  CLI::App& completion =
      add("completion", "print a completion script for a shell",
          "  source <(spricka completion bash)\n"
          "  spricka completion bash > ~/.local/share/bash-completion/completions/spricka",
          [this] {
            write_to_stdout(bash_completion(describe_program()));
            return base::ProgramOutcome::done;
          });
  completion.add_option("SHELL", shell_, "bash")
      ->required()
      ->check(one_of_words_validator({"bash"}))
      ->type_name("");
  add("man", "print the man page", "  spricka man | man -l -", [this] {
    write_to_stdout(man_page(describe_program()));
    return base::ProgramOutcome::done;
  });
}

const CommandTree::Command* CommandTree::find_parsed() const {
  const auto found =
      std::ranges::find_if(commands_, [](const Command& command) { return command.app->parsed(); });
  return found == commands_.end() ? nullptr : &*found;
}

const CLI::App* CommandTree::parsed_command() const {
  const Command* command = find_parsed();
  return command != nullptr ? command->app : nullptr;
}

base::ProgramOutcome CommandTree::execute_command() const {
  const Command* command = find_parsed();
  return command != nullptr ? command->act() : base::ProgramOutcome::usage;
}

ProgramText CommandTree::describe_program() const {
  ProgramText program{SPRICKA_VERSION, k_about, describe_options(app_), {}};
  for (const Command& command : commands_) {
    program.commands.push_back({command.app->get_name(), command.app->get_description(),
                                describe_options(*command.app), command.examples});
  }
  return program;
}

} // namespace spricka::program
