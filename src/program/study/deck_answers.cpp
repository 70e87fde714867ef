// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/deck_answers.hpp"

#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace spricka::program {

namespace {

// By what stands in front of the first point.
const std::map<std::string_view, AnswerGroup> group_words{
    {"K", AnswerGroup::K},           {"K1", AnswerGroup::K},
    {"K2", AnswerGroup::K},          {"K3", AnswerGroup::K},
    {"PATH", AnswerGroup::K},        {"G", AnswerGroup::K},
    {"T", AnswerGroup::T},           {"CPRESS", AnswerGroup::pressure},
    {"S", AnswerGroup::stress},      {"U", AnswerGroup::displacement},
    {"ENERGY", AnswerGroup::energy}, {"ARC", AnswerGroup::arc},
    {"STICK", AnswerGroup::arc},     {"N", AnswerGroup::life},
    {"LIFE", AnswerGroup::life},     {"SHEAR", AnswerGroup::pressure}};

std::optional<AnswerGroup> group_of(std::string_view quantity) {
  const auto found = group_words.find(quantity.substr(0, quantity.find('.')));
  const bool of_path = quantity == "PATH" || quantity.starts_with("PATH.");
  if (found == group_words.end() ||
      (of_path && !quantity.starts_with("PATH.K1") && !quantity.starts_with("PATH.K2")) ||
      quantity.find(".BAR") != std::string_view::npos || quantity == "ARC.PARTS") {
    return std::nullopt;
  }
  return found->second;
}

// "K1.BAR" for K and K1, "K2.RAW.PHI" for K2.PHI; empty where there is no such word.
std::string with_part(std::string_view quantity, std::string_view part) {
  std::string word = error_bar_part_quantity_word(quantity, part);
  if (word.ends_with(".BAR.MIN")) {
    word.replace(word.size() - 3, 3, "MAX"); // the smallest K may lie where the bar is widest
  }
  return word;
}

using CheckArguments = std::vector<std::variant<std::string, double>>;

// A question that the deck has not asked.
model::ResultCheck question(std::string word, CheckArguments arguments, bool relative) {
  model::ResultCheck check;
  check.quantity = std::move(word);
  check.arguments = std::move(arguments);
  check.relative = relative;
  check.tolerance = 1.0;
  return check;
}

// K1 and K2 of a tip, but for a mode that is next to nothing; of a front K1 at eight places.
std::vector<model::ResultCheck> questions_of_front(const std::string& step,
                                                   const results::FrontResult& front) {
  std::vector<model::ResultCheck> made;
  if (front.is_tip() && front.invalid_reason.empty()) {
    const results::FrontPointResult& tip = front.single_point();
    constexpr double least = 1e-3; // of K
    for (const auto& [word, value] : {std::pair{"K1", tip.K1}, std::pair{"K2", tip.K2}}) {
      if (std::abs(value) > least * std::hypot(tip.K1, tip.K2)) {
        made.push_back(question(word, {front.name, step}, false));
      }
    }
  }
  std::vector<base::Vec3> places;
  for (const results::FrontPointResult& place : front.points) {
    if (!front.is_tip() && !place.at_surface) {
      places.push_back(place.x);
    }
  }
  const std::size_t count = std::min<std::size_t>(8, places.size());
  for (std::size_t i = 0; i < count; ++i) {
    const base::Vec3& x = places[(2 * i + 1) * places.size() / (2 * count)];
    made.push_back(question("K1.AT", {front.name, x.x(), x.y(), x.z(), step}, false));
  }
  return made;
}

// Of a long growth the first, the middle and the last length; of several lengths that one.
std::vector<model::ResultCheck> questions_of_cracks(const results::RunResult& run) {
  constexpr std::size_t many = 12;
  const std::size_t n = run.increments.size();
  std::vector<model::ResultCheck> made;
  for (std::size_t i = 0; i < n; ++i) {
    if (n > many && i != 0 && i != n / 2 && i + 1 != n) {
      continue;
    }
    for (const results::LoadStepResult& step : run.increments[i].steps) {
      for (const results::FrontResult& front : step.fronts) {
        for (model::ResultCheck& check : questions_of_front(step.step, front)) {
          if (n > 1) {
            check.arguments.emplace_back(front.a);
          }
          made.push_back(std::move(check));
        }
      }
    }
  }
  return made;
}

std::vector<model::ResultCheck> questions_of_bodies(const results::RunResult& run) {
  std::vector<model::ResultCheck> made;
  if (!run.increments.empty()) {
    for (const results::LoadStepResult& step : run.increments.back().steps) {
      for (const results::ContactResult& contact : step.contacts) {
        made.push_back(question("CPRESS.MEAN", {contact.name, step.step}, false));
      }
      made.push_back(question("ENERGY", {"*", step.step}, true));
    }
  }
  return made;
}

// Whose answer it is, where a name stands first; places are of their group.
std::string subject_of(const AnswerRequest& answer) {
  const auto* const name = answer.check.arguments.empty()
                               ? nullptr
                               : std::get_if<std::string>(&answer.check.arguments.front());
  return name == nullptr ? std::string() : *name;
}

} // namespace

const char* display_name(AnswerGroup group) {
  constexpr std::array names{"K",      "T",           "pressure", "stress", "displacement",
                             "energy", "contact arc", "life",     "other"};
  return names.at(static_cast<std::size_t>(group));
}

std::vector<AnswerRequest> collect_answer_requests(const model::Model& model,
                                                   const results::RunResult& run) {
  std::vector<AnswerRequest> answers;
  const auto add = [&](const std::vector<model::ResultCheck>& checks, bool own) {
    for (const model::ResultCheck& check : checks) {
      if (const std::optional<AnswerGroup> group = group_of(check.quantity)) {
        const bool given = own && check.relative && check.value != 0.0;
        answers.push_back(
            {check, check_text(check), *group, given ? std::optional(check.value) : std::nullopt});
      }
    }
  };
  add(model.checks, true);
  if (!model.cracks.empty() &&
      std::ranges::count(answers, AnswerGroup::K, &AnswerRequest::group) == 0) {
    add(questions_of_cracks(run), false);
  }
  if (answers.empty()) {
    add(questions_of_bodies(run), false);
  }
  std::erase_if(answers, [&](const AnswerRequest& answer) { // what the deck itself does not find
    return !std::isfinite(find_check_value(model, answer.check, run));
  });
  return answers;
}

double find_check_value(const model::Model& model, const model::ResultCheck& check,
                        const results::RunResult& run) {
  const results::CheckResult result = evaluate_check(model, check, run);
  return result.trouble.empty() ? result.found : std::numeric_limits<double>::quiet_NaN();
}

std::vector<AnswerReading> read_answers(const model::Model& model,
                                        const std::vector<VariantCheckAndFactor>& asked,
                                        const results::RunResult& run) {
  std::vector<AnswerReading> readings(asked.size());
  for (std::size_t a = 0; a < asked.size(); ++a) {
    if (!asked[a].check) {
      continue;
    }
    const auto part_of_bar = [&](const char* part) {
      model::ResultCheck check = *asked[a].check;
      check.quantity = with_part(check.quantity, part);
      return check.quantity.empty() ? AnswerReading().bar : find_check_value(model, check, run);
    };
    readings[a].value = find_check_value(model, *asked[a].check, run) / asked[a].factor;
    readings[a].bar = part_of_bar("BAR") / std::abs(asked[a].factor);
    readings[a].raw = part_of_bar("RAW") / asked[a].factor;
  }
  return readings;
}

std::vector<double> answer_scales(const std::vector<AnswerRequest>& answers,
                                  const std::vector<double>& found) {
  std::vector<double> scales;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    double scale = 0.0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const bool alike =
          answers[k].group == answers[i].group && subject_of(answers[k]) == subject_of(answers[i]);
      scale = alike && std::isfinite(found[k]) ? std::max(scale, std::abs(found[k])) : scale;
    }
    const bool own = answers[i].check.relative && (answers[i].reference || found[i] != 0.0);
    scales.push_back(own && std::isfinite(found[i]) ? std::abs(found[i]) : scale);
  }
  return scales;
}

} // namespace spricka::program
