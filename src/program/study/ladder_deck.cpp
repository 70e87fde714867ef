// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder_deck.hpp"

#include "archive/safe_file.hpp"
#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/job/interrupt.hpp"
#include "program/job/run_folder.hpp"
#include "program/job/standard_streams.hpp"
#include "program/study/halves.hpp"
#include "program/study/ladder_report.hpp"
#include "program/study/variant_runs.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace spricka::program {

namespace {

class LadderRun {
public:
  LadderRun(const HierarchyOptions& options, const Log& log) : options_(options), log_(log) {
    ladder_.tolerance = options.tolerance;
  }

  base::Outcome run() {
    ready_ = read_and_check_deck(options_.deck.deck, {.defines = options_.deck.defines}, log_);
    if (!ready_.model) {
      return ready_.refusal.kind;
    }
    base::Diagnostics ignored; // the same mistakes as before: none
    const auto text = deck::read_deck_text(options_.deck.deck, ready_.sources, ignored);
    const StudiedDeck deck{options_.deck.deck, options_.deck.defines, text.value(), &ready_};
    RunFolder folder(options_.deck.out);
    scratch_.emplace(options_.deck.out);
    const InterruptHandler interrupt([&](int signal) {
      children_.stop();
      scratch_->remove();
      folder.abandon();
      return 128 + signal;
    });
    for (ModelVariant& variant : make_variants(deck, analyse_joint(*ready_.model))) {
      ModelVariantResult result;
      result.trouble = variant.reason;
      result.variant = std::move(variant);
      ladder_.variants.push_back(std::move(result));
    }
    const base::Outcome outcome = climb(scratch_->path());
    if (children_.stopped()) { // what was not run says nothing; the interrupt ends the program
      return base::Outcome::stopped;
    }
    if (outcome != base::Outcome::done) {
      return outcome;
    }
    compare(ladder_);
    keep(folder);
    folder.commit();
    to_stdout(hierarchy_text(*ready_.model, ladder_));
    to_stdout(fmt::format("decks of all rungs, cheapest.deck, ladder.csv and ladder.html in {}\n",
                          options_.deck.out.string()));
    return base::Outcome::done;
  }

private:
  ChildRun child_of(const ModelVariantResult& result, const std::filesystem::path& scratch) const {
    ChildRun child;
    child.deck = scratch / result.variant.file;
    child.out = scratch / (result.variant.file + ".run");
    report::write_file(child.deck, write_deck(*result.variant.text, scratch));
    return child;
  }

  // The deck itself first: it decides what is compared.
  base::Outcome climb(const std::filesystem::path& scratch) {
    const VariantOutcome given =
        run_variant(children_, child_of(ladder_.variants.front(), scratch));
    if (children_.stopped()) {
      return base::Outcome::stopped;
    }
    if (!given.run) {
      to_stderr(given.end.messages);
      log_.message(
          base::Severity::error, "E555",
          fmt::format("the deck itself has no results to compare with: {}", given.trouble));
      return base::exit_outcome(given.end.exit_code).value_or(base::Outcome::not_solvable);
    }
    ladder_.answers = hierarchy_answers(*ready_.model, *given.run);
    if (ladder_.answers.empty()) {
      log_.message(base::Severity::error, "E555", "the deck has no answer to compare");
      return base::Outcome::not_solvable;
    }
    take(0, given);
    std::vector<std::size_t> chosen;
    std::vector<ChildRun> children;
    for (std::size_t r = 1; r < ladder_.variants.size(); ++r) {
      if (ladder_.variants[r].variant.text) {
        chosen.push_back(r);
        children.push_back(child_of(ladder_.variants[r], scratch));
      }
    }
    run_variants(children_, children, options_.jobs,
                 [&](std::size_t i, const VariantOutcome& end) { take(chosen[i], end); });
    return base::Outcome::done;
  }

  void take(std::size_t r, const VariantOutcome& end) {
    ModelVariantResult& result = ladder_.variants[r];
    result.end = end.end;
    result.unknowns = end.unknowns;
    result.trouble = end.trouble;
    if (end.run) {
      read(result, *end.run);
    }
    if (!options_.deck.quiet) {
      to_stderr(fmt::format("{}: {:.2f} s\n", result.variant.name, end.end.cpu));
    }
  }

  void read(ModelVariantResult& result, const results::RunResult& run) const {
    if (!result.variant.section) {
      result.readings = read_answers(*ready_.model, ladder_.answers, run);
      convert_to_whole_model(result.readings, ladder_.answers, result.variant.mirrored);
      return;
    }
    const ReadyDeck own = read_silently(scratch_->path() / result.variant.file, {});
    result.asked = section_counterparts(*result.variant.section, ladder_.answers);
    result.readings = read_counterparts(own.model.value(), result.asked, run);
  }

  void keep(RunFolder& folder) const {
    const std::filesystem::path place = resolved_folder(options_.deck.out);
    for (const ModelVariantResult& result : ladder_.variants) {
      if (result.variant.text) {
        folder.add_file(result.variant.file,
                        write_deck(*result.variant.text, place, {result.variant.words}));
      }
    }
    if (ladder_.cheapest) {
      const ModelVariantResult& cheapest = ladder_.variants[*ladder_.cheapest];
      folder.add_file("cheapest.deck", write_deck(deck_with_checks(ladder_, cheapest), place,
                                                  {fmt::format("{}: {}", cheapest.variant.name,
                                                               cheapest.variant.words)}));
    }
    folder.add_file("ladder.csv", hierarchy_csv(ladder_));
    folder.add_file("ladder.html", hierarchy_page(ready_.sources, *ready_.model, ladder_));
  }

  const HierarchyOptions& options_;
  const Log& log_;
  ReadyDeck ready_;
  std::optional<ScratchFolder> scratch_;
  ChildRunner children_;
  ModelHierarchy ladder_;
};

} // namespace

base::Outcome run_hierarchy(const HierarchyOptions& given) {
  HierarchyOptions options = given;
  const Log log(options.deck.log_format);
  if (options.deck.out.empty()) {
    options.deck.out = options.deck.deck.filename().replace_extension(".ladder");
  }
  try {
    return LadderRun(options, log).run();
  } catch (const archive::FileFailure& trouble) {
    log.message(base::Severity::error, trouble.code(), trouble.what());
    return base::Outcome::file_trouble;
  } catch (const std::system_error& trouble) {
    log.message(base::Severity::error, "E530", trouble.what());
    return base::Outcome::file_trouble;
  }
}

} // namespace spricka::program
