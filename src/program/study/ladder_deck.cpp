// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder_deck.hpp"

#include "model/model.hpp"
#include "program/job/standard_streams.hpp"
#include "program/study/halves.hpp"
#include "program/study/ladder_report.hpp"
#include "program/study/variant_runs.hpp"
#include "report/drawing/file.hpp"

#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

class LadderRun {
public:
  LadderRun(const HierarchyOptions& options, VariantRuns& runs) : options_(options), runs_(runs) {
    ladder_.tolerance = options.tolerance;
    for (ModelVariant& variant : make_variants(runs.deck(), analyse_joint(runs.model()))) {
      ModelVariantResult& result = ladder_.variants.emplace_back();
      result.trouble = variant.reason;
      result.variant = std::move(variant);
    }
  }

  base::Outcome run(std::string& summary) {
    const base::Outcome outcome = run_given();
    if (outcome != base::Outcome::done) {
      return outcome;
    }
    run_others();
    if (runs_.children().stopped()) {
      return base::Outcome::stopped;
    }
    compare(ladder_);
    fill_folder();
    summary = hierarchy_text(runs_.model(), ladder_) +
              "decks of all rungs, cheapest.deck, ladder.csv and ladder.html";
    return outcome;
  }

private:
  [[nodiscard]] ChildRun child_of(const ModelVariant& variant) const {
    const std::filesystem::path deck = runs_.scratch() / variant.file;
    report::write_file(deck, write_deck(*variant.text, runs_.scratch()));
    return VariantRuns::child_of(deck);
  }

  // The deck itself decides what is compared.
  base::Outcome run_given() {
    return runs_.run_given(child_of(ladder_.variants.front().variant),
                           [&](VariantRun found, const results::RunResult& run) -> std::string {
                             ladder_.answers = hierarchy_answers(runs_.model(), run);
                             record_run(ladder_.variants.front(), std::move(found), &run);
                             return ladder_.answers.empty() ? "the deck has no answer to compare"
                                                            : "";
                           });
  }

  void run_others() {
    std::vector<ModelVariantResult*> chosen;
    std::vector<ChildRun> children;
    for (std::size_t r = 1; r < ladder_.variants.size(); ++r) {
      if (ladder_.variants[r].variant.text) {
        chosen.push_back(&ladder_.variants[r]);
        children.push_back(child_of(ladder_.variants[r].variant));
      }
    }
    runs_.run_others(children, options_.jobs,
                     [&](std::size_t i, VariantRun found, const results::RunResult* run) {
                       record_run(*chosen[i], std::move(found), run);
                     });
  }

  void record_run(ModelVariantResult& result, VariantRun found, const results::RunResult* run) {
    static_cast<VariantRun&>(result) = std::move(found);
    if (run != nullptr) {
      read_results(result, *run);
    }
    if (!options_.deck.quiet) {
      to_stderr(fmt::format("{}: {:.2f} s\n", result.variant.name, result.end.cpu));
    }
  }

  void read_results(ModelVariantResult& result, const results::RunResult& run) const {
    if (!result.variant.section) {
      result.readings = read_answers(runs_.model(), ladder_.answers, run);
      convert_to_whole_model(result.readings, ladder_.answers, result.variant.mirrored);
      return;
    }
    const ReadyDeck own = read_silently(runs_.scratch() / result.variant.file, {});
    result.asked = section_counterparts(*result.variant.section, ladder_.answers);
    result.readings = read_counterparts(own.model.value(), result.asked, run);
  }

  void fill_folder() const {
    RunFolder& folder = runs_.folder();
    const std::filesystem::path& place = runs_.place();
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
    folder.add_file("ladder.html",
                    hierarchy_page(runs_.deck().ready->sources, runs_.model(), ladder_));
  }

  const HierarchyOptions& options_;
  VariantRuns& runs_;
  ModelHierarchy ladder_;
};

} // namespace

base::Outcome run_hierarchy(const HierarchyOptions& options) {
  return run_variants_of(options.deck, ".ladder", [&](VariantRuns& runs, std::string& summary) {
    return LadderRun(options, runs).run(summary);
  });
}

} // namespace spricka::program
