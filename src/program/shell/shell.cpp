// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/shell.hpp"

#include "base/clock.hpp"
#include "base/outcome.hpp"
#include "base/printable.hpp"
#include "model/model.hpp"
#include "program/job/job.hpp"
#include "program/job/solve_to_tolerance.hpp"
#include "program/job/standard_streams.hpp"
#include "program/shell/command_table.hpp"
#include "program/shell/completion.hpp"
#include "program/shell/line_input.hpp"
#include "solve/one_thread.hpp"

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace spricka::program {

namespace {

class Shell {
public:
  explicit Shell(const ShellOptions& options) : options_(options), log_(options.deck.log_format) {}

  base::ProgramOutcome run() {
    // Prompts and the line being typed go to stderr, so that stdout can be a file.
    const bool terminal = isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
    std::optional<LineEditor> editor;
    if (terminal) {
      editor.emplace();
    }
    if (const base::OptionalFailure trouble = open(terminal)) {
      tell(*trouble);
      return trouble->kind;
    }
    if (editor) {
      editor->set_completion_function([this](std::string_view line, std::size_t begin) {
        return complete_shell_line(*session_, line, begin);
      });
    }
    std::string line;
    while (next_line(editor, line)) {
      const ShellReply reply = run_shell_line(*session_, history_, line);
      if (!without_blanks(line).empty()) {
        history_.push_back(line);
      }
      tell(reply, terminal);
      if (reply.quit) {
        break;
      }
      if (reply.outcome != base::ProgramOutcome::done && options_.strict) {
        return reply.outcome;
      }
    }
    return base::ProgramOutcome::done;
  }

private:
  static std::string_view without_blanks(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view() : line.substr(first);
  }

  base::OptionalFailure open(bool terminal) {
    SessionOptions options;
    options.defines = options_.deck.defines;
    options.stopped = terminal ? LineEditor::was_ctrl_c_pressed : std::function<bool()>();
    options.read = [this](const deck::DeckReadOptions& read) {
      CheckedDeck deck = read_and_check_deck(options_.deck.deck, read, log_, &reported_);
      if (deck.model) {
        reported_ = deck.diagnostics;
      }
      return deck;
    };
    options.report = [this](const base::SourceTexts& sources, const base::Diagnostics& list) {
      const base::Diagnostics news = find_news(list, &reported_);
      log_.report_diagnostics(sources, news);
      for (const base::Diagnostic& d : news.messages()) {
        reported_.warning(d.span, d.code, d.text, d.hint);
      }
    };
    options.threads = [this](const model::Model& model) {
      return solve::reserve_blas_workspace(thread_count(options_.deck, model));
    };
    options.engine = [this](const model::Model& model) {
      return requested_engine(options_.deck, model);
    };
    const base::Stopwatch watch;
    session_ = std::make_unique<ShellSession>(std::move(options));
    if (base::OptionalFailure trouble = session_->open()) {
      return trouble;
    }
    if (has_k_tolerance(session_->model())) {
      write_to_stderr(
          fmt::format("note: TOL of $TIPNET is for runs: here the mesh stays as it is\n"));
    }
    if (!session_->model().sweeps.empty()) {
      fmt::print(
          stderr,
          "note: parameters of $SWEEP have the deck's own values; NAME = VALUE changes them\n");
    }
    if (terminal) {
      write_to_stderr(
          fmt::format("{}: at the end of step {}, {:.2f} s CPU; help lists the commands\n",
                      base::make_printable(options_.deck.deck.string()), session_->base_step_name(),
                      watch.cpu_time()));
    }
    return {};
  }

  // What has no end of line (a device) is no command either.
  static bool read_line(std::string& line) {
    constexpr std::size_t longest = std::size_t{1} << 20U;
    line.clear();
    for (int c = std::getc(stdin); c != EOF; c = std::getc(stdin)) {
      if (c == '\n') {
        return true;
      }
      if (line.size() == longest) {
        throw std::system_error(std::make_error_code(std::errc::file_too_large),
                                "standard input: a line without an end");
      }
      line += static_cast<char>(c);
    }
    return !line.empty();
  }

  bool next_line(std::optional<LineEditor>& editor, std::string& line) const {
    return editor ? editor->read(shell_prompt(*session_), line) : read_line(line);
  }

  static void tell(const base::OperationFailure& trouble) {
    if (trouble.complete) {
      write_to_stderr(fmt::format("{}", trouble.why));
    } else {
      write_to_stderr(fmt::format("error: {}\n", trouble.why));
    }
  }

  void tell(const ShellReply& reply, bool terminal) const {
    write_to_stdout(reply.out);
    std::fflush(stdout);
    write_to_stderr(fmt::format("{}", reply.messages));
    if (terminal && !options_.deck.quiet && reply.cpu >= 5e-4) {
      write_to_stderr(fmt::format("({:.0f} ms CPU)\n", 1e3 * reply.cpu));
    }
  }

  const ShellOptions& options_;
  Log log_;
  base::Diagnostics reported_; ///< of the deck, which is read again with every change of it
  std::unique_ptr<ShellSession> session_;
  ShellHistory history_;
};

} // namespace

base::ProgramOutcome run_shell(const ShellOptions& options) {
  try {
    return Shell(options).run();
  } catch (const std::system_error& trouble) {
    Log(options.deck.log_format).report_message(base::Severity::error, "E530", trouble.what());
    return base::ProgramOutcome::file_trouble;
  } catch (const std::range_error& trouble) { // of an engine that iterates
    Log(options.deck.log_format).report_message(base::Severity::error, "E520", trouble.what());
    return base::ProgramOutcome::not_converged;
  }
}

} // namespace spricka::program
