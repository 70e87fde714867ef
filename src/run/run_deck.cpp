// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_deck.hpp"

#include "run/check_deck.hpp"
#include "run/interrupt.hpp"
#include "run/one_run.hpp"
#include "run/restart_run.hpp"
#include "run/safe_file.hpp"
#include "run/sweep.hpp"

#include <system_error>

#include <fmt/format.h>

namespace spricka::run {

namespace {

int run_once(const RunOptions& options, const ReadyDeck& deck, const Log& log) {
  const OpenCheckpoint opened = open_checkpoint(options, deck, {}, log);
  if (opened.refusal) {
    return opened.refusal->exit_code;
  }
  RunFolder folder(options.out);
  std::optional<Interrupt> interrupt;
  if (opened.checkpoint && opened.checkpoint->writes()) {
    interrupt.emplace([&](int signal) {
      std::error_code ignored;
      std::filesystem::remove_all(options.out.string() + ".part", ignored);
      return stop_with_checkpoint(*opened.checkpoint, signal_name(signal), 128 + signal, log);
    });
  }
  const RunOutcome outcome = solve_and_write(options, deck, folder, opened.checkpoint.get(), log);
  if (!outcome.run) {
    return outcome.exit_code;
  }
  folder.commit();
  if (!options.quiet) {
    print_summary(*deck.model, *outcome.run, options.out);
  }
  return outcome.exit_code;
}

} // namespace

int run_deck(const RunOptions& given) {
  RunOptions options = given;
  const Log log(options.log_format);
  if (options.out.empty()) {
    options.out = options.deck.filename().replace_extension(".run");
  }
  try {
    const ReadyDeck deck = read_ready(options.deck, {.defines = options.defines}, log);
    if (!deck.model) {
      return deck.refusal.exit_code;
    }
    if (options.check_only) {
      return check_deck(options, deck, log);
    }
    if (has_no_place(options, *deck.model, log)) {
      return exit_code::usage;
    }
    return deck.model->sweeps.empty() ? run_once(options, deck, log)
                                      : run_sweep(options, deck, log);
  } catch (const FileTrouble& trouble) {
    log.message(base::Severity::error, trouble.code(), trouble.what());
    return exit_code::file_trouble;
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return exit_code::file_trouble;
  }
}

} // namespace spricka::run
