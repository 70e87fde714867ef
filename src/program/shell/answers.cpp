// SPDX-License-Identifier: GPL-3.0-or-later
// What a session answers from its bench.
#include "base/messages.hpp"
#include "grammar/catalogue.hpp"
#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/session.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

base::Trouble ShellSession::mappable() const {
  if (!has_friction()) {
    return {};
  }
  return invalid_input(
      "with friction K depends on the way, not only on where it leads: there is no "
      "map of it",
      "load, solve and K go that way step by step");
}

base::Trouble ShellSession::map_path(const std::string& name) {
  std::size_t index = 0;
  base::Trouble trouble = find_name(path_names(*model_), "load path", name, index);
  trouble = trouble ? trouble : mappable();
  trouble = trouble ? trouble : solve();
  if (trouble) {
    return trouble;
  }
  const model::LoadPathDefinition card = model_->load_paths[index];
  trouble = bench_->follow_load_path(card, way_to(card.from.index()), way_to(card.to.index()));
  if (!trouble) {
    mapped_ = name;
    range_ = {};
  }
  return trouble;
}

base::Trouble ShellSession::map_case(const std::string& load_case, double from, double to) {
  std::size_t index = 0;
  base::Trouble trouble = find_name(load_case_names(*model_), "load case", load_case, index);
  trouble = trouble ? trouble : mappable();
  trouble = trouble ? trouble : solve();
  if (trouble) {
    return trouble;
  }
  if (from == to) {
    return invalid_input("both ends of the map are the same");
  }
  const auto end = [&](double factor) {
    std::vector<model::Step> steps = way();
    model::Step& last = steps.emplace_back();
    last.name = fmt::format("{} {:.6g}", load_case, factor);
    last.actions.emplace_back(model::ApplyLoad{base::CaseId(index), factor});
    return steps;
  };
  model::LoadPathDefinition card;
  card.name = load_case;
  trouble = bench_->follow_load_path(card, end(from), end(to));
  if (!trouble) {
    mapped_ = load_case;
    range_ = {"factor", from, to};
  }
  return trouble;
}

const results::LoadPathResult* ShellSession::last_mapped_path() const {
  return mapped_.empty() || !bench_->ready()
             ? nullptr
             : results::find_path(bench_->run_results().increments.front(), mapped_);
}

base::Trouble ShellSession::evaluate(const model::ResultCheck& check, double& value) {
  if (base::Trouble trouble = solve()) {
    return trouble;
  }
  const grammar::ResultQuantity* is = grammar::find_quantity(check.quantity);
  const std::string letters = argument_letters(*is, model_->mesh.dim);
  for (std::size_t i = 0; i < check.arguments.size() && i < letters.size(); ++i) {
    const auto* name = std::get_if<std::string>(&check.arguments[i]);
    base::Trouble trouble;
    if (letters[i] == 's' && *name != "NOW") {
      std::size_t index = 0;
      trouble = find_name(step_names(*model_), "step", *name, index);
      trouble = trouble ? trouble : bench_->add_step(index);
    } else if (letters[i] == 'l') {
      trouble = map_path(*name);
    }
    if (trouble) {
      return trouble;
    }
  }
  const std::string& q = check.quantity;
  const auto speaks_of = [&](const char* word) { return q.find(word) != std::string::npos; };
  if (speaks_of(".BAR") || speaks_of(".BEST") || q.starts_with("DK")) {
    if (base::Trouble trouble = bench_->estimate_accuracy()) {
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

// Everything that K depends on but the lengths.
std::string ShellSession::setting() const {
  std::string text;
  const analysis::StepFactors& f = factors();
  for (Eigen::Index c = 0; c < f.case_factor.size(); ++c) {
    text += fmt::format("{} ", f.case_factor[c]);
  }
  for (std::size_t c = 0; c < model_->contacts.size(); ++c) {
    text += fmt::format("{} {} {} ", f.fit[c], f.mounted[c] ? 1 : 0,
                        model_->contacts[c].gap.value_or(0.0));
  }
  for (const auto& [name, value] : model_->parameters) {
    text += fmt::format("{} {} ", name, value);
  }
  return text;
}

void ShellSession::remember() {
  const results::StepResult& at = current_result();
  if (at.fronts.empty()) {
    return;
  }
  TriedLengthResult known{
      setting(), run_results().increments.front().a, {crack_size(0), at.fronts}};
  const auto same_size = [](const auto& one, const auto& other) {
    return one.a == other.a && one.length == other.length;
  };
  std::erase_if(known_, [&](const TriedLengthResult& k) {
    return k.setting == known.setting &&
           std::ranges::equal(k.found.fronts, known.found.fronts, same_size);
  });
  known_.push_back(std::move(known));
}

results::RunResult ShellSession::results_by_length() const {
  results::RunResult out;
  const std::string present = setting();
  for (const TriedLengthResult& known : known_) {
    if (known.setting == present) {
      results::Increment& increment = out.increments.emplace_back();
      increment.a = known.a;
      increment.steps.emplace_back().step = "NOW";
      increment.steps.back().fronts = known.found.fronts;
    }
  }
  std::ranges::stable_sort(out.increments, {}, &results::Increment::a);
  for (std::size_t i = 0; i < out.increments.size(); ++i) {
    out.increments[i].number = static_cast<int>(i) + 1;
  }
  return out;
}

std::vector<ShellSession::FrontsAtSize> ShellSession::fronts_by_size() const {
  std::vector<FrontsAtSize> out;
  const std::string present = setting();
  for (const TriedLengthResult& known : known_) {
    if (known.setting == present) {
      out.push_back(known.found);
    }
  }
  std::ranges::stable_sort(out, {},
                           [](const FrontsAtSize& t) { return std::pair(t.size.a, t.size.c); });
  return out;
}

std::vector<std::string> ShellSession::pair_names() const {
  return program::pair_names(*model_);
}

} // namespace spricka::program
