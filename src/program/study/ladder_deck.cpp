// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder_deck.hpp"

#include "model/model.hpp"
#include "program/study/ladder_report.hpp"
#include "program/study/variant_runs.hpp"

#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Decks of all rungs, that of the cheapest with checks, table and page.
void fill_folder(VariantRuns& runs, const ModelHierarchy& ladder) {
  for (const ModelVariantResult& result : ladder.variants) {
    if (result.variant.text) {
      runs.folder().add_file(
          result.variant.deck.filename(),
          write_deck(*result.variant.text, runs.place(), {result.variant.words}));
    }
  }
  if (ladder.cheapest) {
    const ModelVariantResult& cheapest = ladder.variants[*ladder.cheapest];
    runs.folder().add_file(
        "cheapest.deck",
        write_deck(deck_with_checks(ladder, cheapest), runs.place(),
                   {fmt::format("{}: {}", cheapest.variant.name, cheapest.variant.words)}));
  }
  runs.folder().add_file("ladder.csv", hierarchy_csv(ladder));
  runs.folder().add_file("ladder.html",
                         hierarchy_page(runs.deck().ready->sources, runs.model(), ladder));
}

base::Outcome run_ladder(const HierarchyOptions& options, VariantRuns& runs, std::string& summary) {
  ModelHierarchy ladder;
  ladder.tolerance = options.tolerance;
  for (ModelVariant& variant :
       make_model_variants(runs.deck(), analyse_joint(runs.model()), runs.scratch())) {
    ModelVariantResult& result = ladder.variants.emplace_back();
    result.trouble = variant.reason;
    result.variant = std::move(variant);
  }
  VariantRun& given = ladder.variants.front();
  const base::Outcome outcome =
      runs.run_original_deck(ladder.variants.front().variant, given, choose_hierarchy_answers);
  if (outcome != base::Outcome::done) {
    return outcome;
  }
  ladder.answers = runs.answers();
  std::vector<ModelVariantResult*> chosen;
  std::vector<const DeckVariant*> decks;
  for (ModelVariantResult& result : ladder.variants) {
    if (result.variant.text && &result != &ladder.variants.front()) {
      chosen.push_back(&result);
      decks.push_back(&result.variant);
    }
  }
  std::vector<VariantRun> found = runs.run_other_variants(decks, options.jobs);
  if (runs.children().stopped()) {
    return base::Outcome::stopped;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    static_cast<VariantRun&>(*chosen[i]) = std::move(found[i]);
  }
  compare(ladder);
  fill_folder(runs, ladder);
  summary = hierarchy_text(runs.model(), ladder) +
            "decks of all rungs, cheapest.deck, ladder.csv and ladder.html";
  return outcome;
}

} // namespace

base::Outcome run_hierarchy(const HierarchyOptions& options) {
  return run_variants_of(options.deck, ".ladder", [&](VariantRuns& runs, std::string& summary) {
    return run_ladder(options, runs, summary);
  });
}

} // namespace spricka::program
