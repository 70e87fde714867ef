// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/verify.hpp"

#include "archive/safe_file.hpp"
#include "base/clock.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/shipped_files.hpp"
#include "program/job/failures.hpp"
#include "program/job/log.hpp"
#include "program/job/point_record.hpp"
#include "program/job/restart_run.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/standard_streams.hpp"
#include "program/trials/deck_outcome.hpp"
#include "program/trials/deck_runs.hpp"
#include "program/verify/comparison.hpp"
#include "program/verify/deck_list.hpp"
#include "program/verify/verification.hpp"
#include "program/verify/verification_report.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_name = "verification.csv";
constexpr const char* page_name = "verification.html";
/// A deck that takes so many times what the costliest is known to take has lost its way.
constexpr double far_longer = 20.0; // of its CPU time

VerifiedDeck verified(const ListedDeck& deck, const ChildProcessResult& end,
                      const fs::path& folder) {
  VerifiedDeck out;
  static_cast<ChildProcessResult&>(out) = end;
  out.name = deck.name;
  out.points = read_run_folder_checks(folder);
  out.title = out.points.empty() ? "" : out.points.back().title;
  if (out.failed()) {
    out.said_last = first_error_line(end.messages);
  }
  return out;
}

// Of all that decks read: they include, import and name files of their folder.
std::string digest_of_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().filename() != costs_name) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::string hashes;
  for (const fs::path& file : files) {
    hashes += file.lexically_relative(folder).string() + ' ' +
              archive::hash_bytes(base::read_file(file, base::largest_mesh_file)) + '\n';
  }
  return archive::hash_bytes(hashes);
}

class VerifyRun {
public:
  VerifyRun(const VerifyOptions& options, fs::path decks)
      : options_(options), decks_(std::move(decks)), all_(list_decks(decks_)) {
    verification_.asked = options.asked.empty() ? std::vector<std::string>{"quick"} : options.asked;
    verification_.at_once = options.at_once > 0 ? options.at_once : core_count();
  }

  base::ProgramOutcome run() {
    base::OptionalFailure trouble;
    chosen_ = select_decks(all_, verification_.asked, trouble);
    if (trouble) {
      write_to_stderr(
          fmt::format("spricka verify: {}\n       = {}\n       = spricka verify all --list "
                      "shows the decks of {}\n",
                      trouble->why, trouble->hint, decks_.string()));
      return trouble->kind;
    }
    if (options_.list) {
      print_list();
      return base::ProgramOutcome::done;
    }
    warn_of_costs();
    verification_.program =
        program_version_and_build(); // now: its file may be another one at the end
    verification_.machine = machine_description();
    fs::create_directories(options_.out);
    before_ = read_verification_csv(options_.before.empty() ? options_.out / table_name
                                                            : options_.before);
    if (!run_decks()) {
      return base::ProgramOutcome::stopped;
    }
    if (!options_.array) {
      write();
    }
    return missing_.empty() ? worst_outcome(verification_) : report_missing();
  }

private:
  void print_list() const {
    for (const ListedDeck& deck : chosen_) {
      write_to_stdout(fmt::format("{:<36} {:<6} {}\n", deck.name, deck.quick ? "quick" : "",
                                  deck.cost ? fmt::format("{:8.2f} s {:6.0f} MB", deck.cost->cpu,
                                                          megabytes(deck.cost->memory))
                                            : "  in no tier: its cost is not known"));
    }
  }

  void warn_of_costs() const {
    for (const ListedDeck& deck : chosen_) {
      if (!deck.cost && !options_.costs && options_.decks.empty()) {
        write_to_stderr(
            fmt::format("note: {} is in no tier: {} does not have it; --costs adds it\n", deck.name,
                        costs_name));
      }
    }
  }

  // The costliest first, so that none is left for one core at the end.
  void order_by_cost() {
    std::ranges::stable_sort(chosen_, std::greater<>(), [](const ListedDeck& deck) {
      return deck.cost ? deck.cost->cpu : whole_budget;
    });
  }

  // False: stopped by a signal.
  bool run_decks() {
    order_by_cost();
    const base::Stopwatch watch;
    DeckRuns deck_runs(
        options_.out / "runs", options_.keep,
        [this](int signal) {
          write_to_stderr(
              fmt::format("\nstopped by {}: {}\n", signal_name(signal),
                          options_.array ? "what has ended is kept" : "nothing is written"));
        },
        sharing());
    std::vector<ChildRun> runs;
    double most = 0.0;
    for (const ListedDeck& deck : all_) {
      most = std::max(most, deck.cost ? deck.cost->cpu : 0.0);
    }
    for (const ListedDeck& deck : chosen_) {
      runs.push_back({.deck = deck.file,
                      .out = deck_runs.run_folder(deck.name),
                      .defines = {},
                      .threads = 1,
                      .engine = options_.engine,
                      .seconds = 0.0,
                      .cpu_seconds = far_longer * most});
    }
    deck_runs.run_all_children(
        runs, verification_.at_once, [&](std::size_t i, const ChildProcessResult& end) {
          verification_.decks.push_back(verified(chosen_[i], end, runs[i].out));
          tell(verification_.decks.back(), chosen_[i], watch.wall_time());
        });
    verification_.wall = watch.wall_time();
    missing_ = deck_runs.missing_runs();
    if (options_.collect) {
      take_over_costs();
    }
    std::ranges::sort(verification_.decks, {}, &VerifiedDeck::name);
    if (options_.keep) {
      write_to_stdout(fmt::format("run folders in {}\n", deck_runs.folder().string()));
    }
    return !deck_runs.stopped();
  }

  [[nodiscard]] SharedRunOptions sharing() const {
    SharedRunOptions shared{.task = options_.array, .collect = options_.collect};
    if (shared.is_shared()) {
      shared.folder = canonical_folder(options_.out / "runs");
      shared.digest = digest_of_folder(decks_);
    }
    return shared;
  }

  // Decks took their time wherever tasks have run them.
  void take_over_costs() {
    std::set<std::string> machines;
    verification_.wall = 0.0;
    for (const VerifiedDeck& deck : verification_.decks) {
      verification_.wall += deck.wall;
      machines.insert(deck.machine);
    }
    if (!machines.empty()) {
      verification_.machine = fmt::format("{}", fmt::join(machines, "; "));
    }
  }

  [[nodiscard]] base::ProgramOutcome report_missing() const {
    const Log log(LogFormat::text);
    if (options_.array) {
      log.report_message(base::Severity::note, "E554",
                         fmt::format("not finished: {}", fmt::join(missing_, ", ")));
    } else {
      log.report_message(base::Severity::error, "E553",
                         missing_runs_text(missing_, chosen_.size(), "deck", options_.out));
    }
    return base::ProgramOutcome::stopped;
  }

  // A line for each deck; on a terminal one more below it, that says how far it is.
  void tell(const VerifiedDeck& deck, const ListedDeck& listed, double wall) {
    const bool terminal = isatty(STDERR_FILENO) != 0;
    known_done_ += listed.cost ? listed.cost->cpu : 0.0;
    const auto checks = checks_at_all_points(deck).size();
    if (!options_.quiet || deck.failed()) {
      write_to_stdout(fmt::format(
          "{}{:>4} of {}  {:<6} {:<36} {:>4} checks {:8.2f} s {:6.0f} MB{}\n",
          terminal && !options_.quiet ? "\r\x1b[K" : "", verification_.decks.size(), chosen_.size(),
          deck.failed() ? "FAILED" : "passed", deck.name, checks, deck.cpu,
          megabytes(deck.peak_memory),
          deck.failed() ? fmt::format("  {} missed; {}", deck.missed_check_count(), deck.said_last)
                        : ""));
      std::fflush(stdout);
    }
    if (terminal && !options_.quiet) {
      write_to_stderr(verification_.decks.size() < chosen_.size() ? seconds_left(wall) : "");
    }
  }

  [[nodiscard]] std::string seconds_left(double wall) const {
    double known = 0.0;
    for (const ListedDeck& deck : chosen_) {
      known += deck.cost ? deck.cost->cpu : 0.0;
    }
    return known_done_ > 0.0
               ? fmt::format("      {:.0f} s left", wall * (known - known_done_) / known_done_)
               : std::string();
  }

  void write() {
    const std::vector<BenchmarkProblem> problems = read_benchmark_coverage(decks_);
    std::optional<VerificationComparison> comparison;
    if (before_) {
      comparison = compare_verifications(verification_, *before_);
    }
    base::write_atomically(options_.out / table_name, verification_csv(verification_));
    base::write_atomically(options_.out / page_name,
                           verification_page(verification_, problems, comparison));
    if (!options_.markdown.empty()) {
      write_chapter(problems);
    }
    if (options_.costs) {
      std::vector<std::pair<std::string, DeckCost>> found;
      for (const VerifiedDeck& deck : verification_.decks) {
        found.emplace_back(deck.name, DeckCost{.cpu = deck.cpu, .memory = deck.peak_memory});
      }
      write_deck_costs(decks_, all_, found);
    }
    print_summary(comparison);
  }

  // The chapter, and beside it the table of checks that it names.
  void write_chapter(const std::vector<BenchmarkProblem>& problems) const {
    fs::path table = options_.markdown;
    table.replace_extension(".csv");
    base::write_atomically(table, verification_csv(verification_));
    base::write_atomically(options_.markdown, verification_chapter(verification_, problems,
                                                                   table.filename().string()));
  }

  void print_summary(const std::optional<VerificationComparison>& comparison) const {
    for (const std::string& line : verification_summary(verification_)) {
      write_to_stdout(line + "\n");
    }
    if (comparison) {
      write_to_stdout(fmt::format("Since the last time ({}): {}\n", comparison->program,
                                  comparison_summary(*comparison)));
      const report::ReportTable changes = verification_change_table(*comparison);
      if (!changes.rows.empty() && !options_.quiet) {
        write_to_stdout(report::table_to_text(changes));
      }
    }
    write_to_stdout(fmt::format("{:.1f} s CPU, {:.1f} s; {} and {}\n",
                                count_checks_and_costs(verification_).cpu, verification_.wall,
                                (options_.out / page_name).string(), table_name));
  }

  const VerifyOptions& options_;
  fs::path decks_;
  std::vector<ListedDeck> all_, chosen_;
  Verification verification_;
  std::optional<Verification> before_;
  std::vector<std::string> missing_; ///< decks whose runs no task has finished
  double known_done_ = 0.0;          ///< of the costs of the decks that have ended [s]
};

} // namespace

base::ProgramOutcome verify_decks(const VerifyOptions& options) {
  const Log log(LogFormat::text);
  return run_reporting_file_failures(log, [&] {
    const fs::path decks =
        options.decks.empty() ? base::find_shipped_file("share/spricka/decks") : options.decks;
    if (decks.empty()) {
      log.report_message(
          base::Severity::error, "E530",
          "the decks are not installed beside spricka; --decks FOLDER names another place");
      return base::ProgramOutcome::file_trouble;
    }
    return VerifyRun(options, decks).run();
  });
}

} // namespace spricka::program
