// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder.hpp"

#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/study/convergence.hpp"
#include "results/shown_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

bool is_of_step(const AnswerRequest& answer, const std::string& step) {
  return std::ranges::any_of(answer.check.arguments, [&](const auto& argument) {
    const auto* name = std::get_if<std::string>(&argument);
    return name != nullptr && *name == step;
  });
}

// Answers of the most telling group that there are: K before pressures and the rest. Those that are
// not the deck's own checks: of the step that the run shows first.
std::vector<AnswerRequest> choose_hierarchy_answers(const model::Model& model,
                                                    const results::RunResult& run) {
  std::vector<AnswerRequest> all = collect_answer_requests(model, run);
  if (all.empty()) {
    return all;
  }
  const AnswerGroup leading = std::ranges::min(all, {}, &AnswerRequest::group).group;
  std::erase_if(all, [&](const AnswerRequest& answer) { return answer.group != leading; });
  const bool own =
      !model.checks.empty() && std::ranges::any_of(all, [](const AnswerRequest& answer) {
        return answer.check.span.valid();
      });
  // What matters is where the crack is driven most; in the end the joint may be unloaded.
  const std::string step = results::shown_step_name(model, run.increments);
  const bool has_step = std::ranges::any_of(
      all, [&](const AnswerRequest& answer) { return is_of_step(answer, step); });
  if (!own && has_step) {
    std::erase_if(all, [&](const AnswerRequest& answer) { return !is_of_step(answer, step); });
  }
  return all;
}

// Its image or nothing stands for such an answer.
bool lacks_answer(const ModelVariantResult& variant, std::size_t answer) {
  return (!variant.asked.empty() && !variant.asked[answer].check) ||
         (!variant.variant.mirrored.empty() && !std::isfinite(variant.readings[answer].value));
}

// Fills difference, bar and verdict of a variant with answers: the largest of them all.
void judge_variant(const SimplerModelComparison& ladder, ModelVariantResult& variant) {
  const ModelVariantResult& richest = ladder.variants[*ladder.richest];
  const auto finite_or_zero = [](double value) { return std::isfinite(value) ? value : 0.0; };
  variant.difference = std::numeric_limits<double>::quiet_NaN();
  bool within = true;
  bool outside = false;
  for (std::size_t a = 0; a < ladder.answers.size(); ++a) {
    const AnswerReading& own = variant.readings[a];
    const AnswerReading& rich = richest.readings[a];
    const double scale = ladder.scales[a];
    variant.bar = std::max(variant.bar, finite_or_zero(own.bar / scale));
    if (!(scale > 0.0) || !std::isfinite(rich.value) || lacks_answer(variant, a)) {
      continue;
    }
    const double part = (own.value - rich.value) / scale;
    const double bars = (finite_or_zero(own.bar) + finite_or_zero(rich.bar)) / scale;
    within = within && std::abs(part) + bars <= ladder.tolerance; // not where it is no number
    outside = outside || std::abs(part) - bars > ladder.tolerance;
    if (std::isfinite(part) && !(std::abs(part) <= std::abs(variant.difference))) {
      variant.difference = part;
    }
  }
  const bool any = std::isfinite(variant.difference);
  variant.verdict = &variant == &richest ? ModelVariantVerdict::richest
                    : outside            ? ModelVariantVerdict::outside
                    : within && any      ? ModelVariantVerdict::within
                    : any                ? ModelVariantVerdict::undecided
                                         : ModelVariantVerdict::missing;
}

// It was ended before it had an answer, or fell: what it would have said is not known.
bool was_stopped(const ModelVariantResult& variant) {
  const bool ended = variant.end.signal != 0 || variant.end.late || variant.end.exit_code > 128 ||
                     variant.end.exit_code == base::exit_code(base::ProgramOutcome::stopped);
  return variant.variant.text && variant.readings.empty() && ended;
}

bool is_enough(const ModelVariantResult& variant) {
  return variant.verdict == ModelVariantVerdict::richest ||
         (variant.verdict == ModelVariantVerdict::within && variant.variant.simpler);
}

// Rungs stand in the order of their richness: of those that take as long the last is the simplest.
std::optional<std::size_t> cheapest_of(const std::vector<ModelVariantResult>& variants) {
  std::vector<RankedRunCost> costs;
  costs.reserve(variants.size());
  for (const ModelVariantResult& variant : variants) {
    costs.push_back({is_enough(variant) ? variant.end.cpu : std::numeric_limits<double>::infinity(),
                     -static_cast<double>(costs.size())});
  }
  return cheapest_run(costs);
}

} // namespace

const char* display_name(ModelVariantVerdict verdict) {
  constexpr std::array names{"the richest", "within", "not to be told", "not within", "-"};
  return names.at(static_cast<std::size_t>(verdict));
}

void judge_simpler_models(SimplerModelComparison& ladder) {
  const auto first = std::ranges::find_if(
      ladder.variants, [](const ModelVariantResult& variant) { return !variant.readings.empty(); });
  if (first == ladder.variants.end()) {
    return;
  }
  ladder.richest = static_cast<std::size_t>(first - ladder.variants.begin());
  std::vector<double> values;
  for (const AnswerReading& reading : first->readings) {
    values.push_back(reading.value);
  }
  ladder.scales = answer_scales(ladder.answers, values);
  ladder.stopped.clear();
  for (ModelVariantResult& variant : ladder.variants) {
    if (!variant.readings.empty()) {
      judge_variant(ladder, variant);
    } else if (was_stopped(variant)) {
      ladder.stopped.push_back(variant.variant.name);
    }
  }
  if (ladder.stopped.empty()) {
    ladder.cheapest = cheapest_of(ladder.variants);
  }
}

namespace {

// The deck of a variant with the richest variant's answers as its checks, to the tolerance; of a
// part by symmetry its part of energies; no answers that the variant's model does not have.
deck::DeckCardList deck_with_checks(const SimplerModelComparison& ladder,
                                    const ModelVariantResult& variant) {
  deck::DeckCard checks = deck::make_card("CHECK");
  const ModelVariantResult& richest = ladder.variants[*ladder.richest];
  for (std::size_t a = 0; a < ladder.answers.size(); ++a) {
    const VariantCheckAndFactor& own = variant.asked[a];
    const double value = richest.readings[a].value * own.factor;
    if (std::isfinite(value) && ladder.scales[a] > 0.0 && !lacks_answer(variant, a)) {
      checks.data += fmt::format(
          "  {} = {:.7g}  ABS {:.3g}  SOURCE 'the richest rung, {}'\n", check_text(*own.check),
          value, ladder.tolerance * ladder.scales[a] * std::abs(own.factor), richest.variant.name);
    }
  }
  deck::DeckCardList whole = *variant.variant.text;
  append_card(whole, std::move(checks));
  return whole;
}

// Decks of all rungs, that of the cheapest with checks, table and page.
void fill_folder(VariantRuns& runs, const SimplerModelComparison& ladder) {
  for (const ModelVariantResult& result : ladder.variants) {
    if (result.variant.text) {
      runs.run_folder().add_file(
          result.variant.deck.filename(),
          format_deck_card_list(*result.variant.text, runs.final_folder(), {result.variant.words}));
    }
  }
  if (ladder.cheapest) {
    const ModelVariantResult& cheapest = ladder.variants[*ladder.cheapest];
    runs.run_folder().add_file(
        "cheapest.deck",
        format_deck_card_list(
            deck_with_checks(ladder, cheapest), runs.final_folder(),
            {fmt::format("{}: {}", cheapest.variant.name, cheapest.variant.words)}));
  }
  runs.run_folder().add_file("ladder.csv", simpler_models_csv(ladder));
  runs.run_folder().add_file("ladder.html",
                             simpler_models_page(runs.deck().ready->sources, runs.model(), ladder));
}

base::ProgramOutcome run_ladder(const SimplerModelRunOptions& options, VariantRuns& runs,
                                std::string& summary) {
  SimplerModelComparison ladder;
  ladder.tolerance = options.tolerance;
  for (DeckVariant& variant : make_simpler_models(runs.deck(), runs.scratch_folder())) {
    ModelVariantResult& result = ladder.variants.emplace_back();
    result.trouble = variant.reason;
    result.variant = std::move(variant);
  }
  std::vector<StudyTrial*> chosen; // the deck itself first
  for (ModelVariantResult& result : ladder.variants) {
    if (result.variant.text) {
      chosen.push_back(&result);
    }
  }
  if (runs.is_task()) {
    return runs.run_share(chosen, options.jobs);
  }
  const base::ProgramOutcome outcome =
      runs.run_original_deck(ladder.variants.front(), choose_hierarchy_answers);
  if (outcome != base::ProgramOutcome::done) {
    return outcome;
  }
  ladder.answers = runs.requested_answers();
  chosen.erase(chosen.begin());
  runs.run_other_variants(chosen, options.jobs);
  if (runs.process_runs().stopped()) {
    return base::ProgramOutcome::stopped;
  }
  judge_simpler_models(ladder);
  fill_folder(runs, ladder);
  summary = simpler_models_text(runs.model(), ladder) +
            "decks of all rungs, cheapest.deck, ladder.csv and ladder.html";
  return outcome;
}

} // namespace

base::ProgramOutcome run_simpler_models(const SimplerModelRunOptions& options) {
  return run_deck_variants(options.deck, ".ladder", [&](VariantRuns& runs, std::string& summary) {
    return run_ladder(options, runs, summary);
  });
}

} // namespace spricka::program
