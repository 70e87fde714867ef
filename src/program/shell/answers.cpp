// SPDX-License-Identifier: GPL-3.0-or-later
// What a session answers from its bench.
#include "deck/typed_line.hpp"
#include "grammar/catalogue.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/session.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

base::OptionalFailure ShellSession::estimate_accuracy() {
  base::OptionalFailure trouble = solve();
  return trouble ? trouble : bench_->estimate_accuracy();
}

base::OptionalFailure ShellSession::follow(const model::LoadPathDefinition& card,
                                           const std::vector<model::Step>& from,
                                           const std::vector<model::Step>& to,
                                           const PathParameterRange& range) {
  if (has_friction()) {
    return invalid_input(
        "with friction K depends on the way, not only on where it leads: there is no map of it",
        "LOAD, solve and K1 go that way step by step");
  }
  base::OptionalFailure trouble = bench_->follow_load_path(card, from, to);
  if (!trouble) {
    mapped_ = card.name;
    range_ = range;
  }
  return trouble;
}

base::OptionalFailure ShellSession::follow_deck_load_path(const std::string& name) {
  std::size_t index = 0;
  base::OptionalFailure trouble =
      find_name_index(candidate_argument_names('l', *model_), "load path", name, index);
  trouble = trouble ? trouble : solve();
  if (trouble) {
    return trouble;
  }
  const model::LoadPathDefinition card = model_->load_paths[index];
  return follow(card, way_to(card.from.index()), way_to(card.to.index()), {});
}

base::OptionalFailure ShellSession::follow_load_case_range(const std::string& load_case,
                                                           const std::string& from,
                                                           const std::string& to) {
  if (base::OptionalFailure trouble = solve()) {
    return trouble;
  }
  std::array<std::vector<model::Step>, 2> ends{way(), way()};
  PathParameterRange range{.what = "factor"};
  for (const bool end : {false, true}) {
    base::SourceTexts sources;
    base::Diagnostics diagnostics;
    std::optional<model::Step> step = deck::read_step_line(
        *model_, fmt::format("LOAD {} {}", load_case, end ? to : from), sources, diagnostics);
    if (!step) {
      return located_failure(base::Outcome::usage, sources, diagnostics);
    }
    const double factor = std::get<model::ApplyLoad>(step->actions.front()).factor;
    (end ? range.to : range.from) = factor;
    step->name = fmt::format("{} {:.6g}", load_case, factor);
    ends[end ? 1 : 0].push_back(std::move(*step));
  }
  if (range.from == range.to) {
    return invalid_input("both ends of the map are the same");
  }
  model::LoadPathDefinition card;
  card.name = load_case;
  return follow(card, ends[0], ends[1], range);
}

const results::LoadPathResult* ShellSession::last_followed_path() const {
  return mapped_.empty() || !bench_->ready()
             ? nullptr
             : results::find_path(bench_->run_results().increments.front(), mapped_);
}

base::OptionalFailure ShellSession::read_result_request(const std::string& line,
                                                        model::ResultCheck& check) const {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::ResultCheck> found =
      deck::read_result_request_line(*model_, line, sources, diagnostics);
  if (!found) {
    return located_failure(base::Outcome::usage, sources, diagnostics);
  }
  check = std::move(*found);
  if (check.quantity == "N" || check.quantity == "LIFE" || check.quantity.starts_with("TEST.")) {
    return invalid_input(
        fmt::format("{} needs a growth run; the shell looks at states", check.quantity));
  }
  return {};
}

base::OptionalFailure ShellSession::evaluate(const model::ResultCheck& check, double& value) {
  if (base::OptionalFailure trouble = solve()) {
    return trouble;
  }
  for (const auto& argument : check.arguments) {
    const auto* name = std::get_if<std::string>(&argument);
    if (name == nullptr || *name == "NOW") {
      continue;
    }
    base::OptionalFailure
        trouble; // a contact with the name of a step costs a solution, and no more
    const auto step = std::ranges::find(model_->steps, *name, &model::Step::name);
    if (step != model_->steps.end()) {
      trouble =
          bench_->add_deck_step_result(static_cast<std::size_t>(step - model_->steps.begin()));
    } else if (std::ranges::find(model_->load_paths, *name, &model::LoadPathDefinition::name) !=
               model_->load_paths.end()) {
      trouble = follow_deck_load_path(*name);
    }
    if (trouble) {
      return trouble;
    }
  }
  const std::string& q = check.quantity;
  const auto speaks_of = [&](const char* word) { return q.find(word) != std::string::npos; };
  if (speaks_of(".BAR") || speaks_of(".BEST") || q.starts_with("DK")) {
    if (base::OptionalFailure trouble = bench_->estimate_accuracy()) {
      return trouble;
    }
  } else if (q == "ERROR") {
    bench_->estimate_net_errors();
  }
  std::vector<model::ResultCheck> asked{check};
  std::swap(model_->checks, asked);
  const results::CheckResult found = evaluate_checks(*model_, bench_->run_results()).front();
  std::swap(model_->checks, asked);
  if (!found.trouble.empty()) {
    return base::OperationFailure{.kind = base::Outcome::check_failed, .why = found.trouble};
  }
  value = found.found;
  return {};
}

std::vector<std::string> ShellSession::new_notes() {
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
  for (const results::Note& note : current_result().notes) {
    if (results::is_warning(note)) {
      warnings.push_back(results::text_with_code(note));
    } else if (reported_.insert(note.text).second) {
      notes.push_back("note: " + note.text);
    }
  }
  warnings.insert(warnings.end(), notes.begin(), notes.end());
  return warnings;
}

CrackSize ShellSession::crack_size(std::size_t crack) const {
  const model::CrackDefinition& card = model_->cracks[crack];
  if (card.kind == model::CrackDefinitionKind::ellipse) {
    return {card.plane.a, card.plane.c};
  }
  for (const results::FrontResult& front : current_result().fronts) {
    if (front.name == card.name || front.name == card.name + ".1") {
      return {front.a, 0.0};
    }
  }
  return {card.a0.value_or(0.0), 0.0};
}

// Everything that K depends on but the lengths.
std::string ShellSession::setting() const {
  std::string text = other_cards_;
  const analysis::StepActionFactors& f = factors();
  for (Eigen::Index c = 0; c < f.case_factor.size(); ++c) {
    text += fmt::format("{} ", f.case_factor[c]);
  }
  for (std::size_t c = 0; c < model_->contacts.size(); ++c) {
    text += fmt::format("{} {} ", f.fit[c], f.mounted[c] ? 1 : 0);
  }
  return text;
}

void ShellSession::remember() {
  const results::StepResult& at = current_result();
  if (at.fronts.empty()) {
    return;
  }
  TriedSize known{setting(), {run_results().increments.front().a, crack_size(0), at.fronts}};
  const auto same_size = [](const auto& one, const auto& other) {
    return one.a == other.a && one.length == other.length;
  };
  std::erase_if(known_, [&](const TriedSize& k) {
    return k.setting == known.setting &&
           std::ranges::equal(k.found.fronts, known.found.fronts, same_size);
  });
  known_.push_back(std::move(known));
}

std::vector<ShellSession::FrontsAtSize> ShellSession::fronts_by_size() const {
  std::vector<FrontsAtSize> out;
  const std::string present = setting();
  for (const TriedSize& known : known_) {
    if (known.setting == present) {
      out.push_back(known.found);
    }
  }
  std::ranges::stable_sort(out, {}, [](const FrontsAtSize& t) {
    return std::pair(t.size.c > 0.0 ? t.size.a : t.a, t.size.c);
  });
  return out;
}

} // namespace spricka::program
