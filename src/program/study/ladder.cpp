// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/ladder.hpp"

#include "base/exit_codes.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/study/convergence.hpp"
#include "program/study/halves.hpp"
#include "report/topics/result_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::program {

namespace {

bool is_of_step(const AnswerRequest& answer, const std::string& step) {
  return std::ranges::any_of(answer.check.arguments, [&](const auto& argument) {
    const auto* name = std::get_if<std::string>(&argument);
    return name != nullptr && *name == step;
  });
}

// The step with the largest amount among these answers.
std::string largest_step(const std::vector<AnswerRequest>& answers, const model::Model& model,
                         const results::RunResult& run) {
  const std::vector<AnswerReading> readings = read_answers(model, answers, run);
  double most = -1.0;
  std::string largest = report::leading_step_name(model);
  for (std::size_t a = 0; a < answers.size(); ++a) {
    for (const model::Step& step : model.steps) {
      if (std::abs(readings[a].value) > most && is_of_step(answers[a], step.name)) {
        most = std::abs(readings[a].value);
        largest = step.name;
      }
    }
  }
  return largest;
}

// Fills difference, bar and verdict of a variant with answers: the largest of them all.
void judge_variant(const ModelHierarchy& ladder, ModelVariantResult& variant) {
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
                     variant.end.exit_code == base::exit_code(base::Outcome::stopped);
  return variant.variant.text && variant.readings.empty() && ended;
}

bool is_enough(const ModelVariantResult& variant) {
  return variant.verdict == ModelVariantVerdict::richest ||
         (variant.verdict == ModelVariantVerdict::within && variant.variant.simpler);
}

// Rungs stand in the order of their richness: of those that take as long the last is the simplest.
std::optional<std::size_t> cheapest_of(const std::vector<ModelVariantResult>& variants) {
  std::vector<RunCost> costs;
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

std::vector<AnswerRequest> choose_hierarchy_answers(const model::Model& model,
                                                    const results::RunResult& run) {
  std::vector<AnswerRequest> all = collect_answers(model, run);
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
  const std::string step =
      model.growth ? report::leading_step_name(model) : largest_step(all, model, run);
  const bool has_step = std::ranges::any_of(
      all, [&](const AnswerRequest& answer) { return is_of_step(answer, step); });
  if (!own && has_step) {
    std::erase_if(all, [&](const AnswerRequest& answer) { return !is_of_step(answer, step); });
  }
  return all;
}

bool lacks_answer(const ModelVariantResult& variant, std::size_t answer) {
  if (!variant.asked.empty()) {
    return !variant.asked[answer].check;
  }
  return !variant.variant.mirrored.empty() && !std::isfinite(variant.readings[answer].value);
}

void compare(ModelHierarchy& ladder) {
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

deck::DeckCardList deck_with_checks(const ModelHierarchy& ladder,
                                    const ModelVariantResult& variant) {
  deck::DeckCard checks = deck::make_card("CHECK");
  const ModelVariantResult& richest = ladder.variants[*ladder.richest];
  for (std::size_t a = 0; a < ladder.answers.size(); ++a) {
    const bool part = ladder.answers[a].group == AnswerGroup::energy;
    const double factor = variant.asked.empty()
                              ? 1.0 / (part ? mirror_image_count(variant.variant.mirrored) : 1)
                              : variant.asked[a].factor;
    const double value = richest.readings[a].value * factor;
    if (std::isfinite(value) && ladder.scales[a] > 0.0 && !lacks_answer(variant, a)) {
      checks.data += fmt::format(
          "  {} = {:.7g}  ABS {:.3g}  SOURCE 'the richest rung, {}'\n",
          variant.asked.empty() ? ladder.answers[a].text : check_text(*variant.asked[a].check),
          value, ladder.tolerance * ladder.scales[a] * std::abs(factor), richest.variant.name);
    }
  }
  deck::DeckCardList whole = *variant.variant.text;
  append_card(whole, std::move(checks));
  return whole;
}

} // namespace spricka::program
