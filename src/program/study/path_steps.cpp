// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/path_steps.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// Factors of load cases and fits at the end of a step.
struct StepEndFactors {
  std::map<std::string, double> loads;
  std::map<std::string, double> fits;
};

StepEndFactors factors_after(const model::Model& model, std::size_t step) {
  StepEndFactors factors;
  for (std::size_t s = 0; s <= step; ++s) {
    for (const model::Action& action : model.steps[s].actions) {
      if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
        factors.loads[model.cases[load->load_case.index()].name] = load->factor;
      } else if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        factors.fits[model.contacts[fit->contact.index()].name] = fit->factor;
      }
    }
  }
  return factors;
}

double factor_of(const std::map<std::string, double>& factors, const std::string& name) {
  const auto found = factors.find(name);
  return found == factors.end() ? 0.0 : found->second;
}

// LOAD SHAFTLOAD 0.3, for each of what either end has.
std::string lines_at(const std::map<std::string, double>& from,
                     const std::map<std::string, double>& to, double t, const char* word) {
  std::set<std::string> names;
  for (const auto* factors : {&from, &to}) {
    for (const auto& entry : *factors) {
      names.insert(entry.first);
    }
  }
  std::string lines;
  for (const std::string& name : names) {
    const double value = (1.0 - t) * factor_of(from, name) + t * factor_of(to, name);
    lines += fmt::format("  {} {} {:.12g}\n", word, name, value);
  }
  return lines;
}

std::string upper_data(const deck::DeckCard& card) {
  std::string text = card.data;
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  });
  return text;
}

// Without lines of $CHECK that name a path.
void drop_path_checks(deck::DeckText& text) {
  for (deck::DeckCard& card : text) {
    if (card.name != "CHECK") {
      continue;
    }
    std::string kept;
    std::size_t at = 0;
    const std::string upper = upper_data(card);
    while (at < card.data.size()) {
      const std::size_t end = std::min(card.data.find('\n', at), card.data.size() - 1) + 1;
      if (upper.substr(at, end - at).find("PATH.") == std::string::npos) {
        kept += card.data.substr(at, end - at);
      }
      at = end;
    }
    card.data = kept;
  }
  std::erase_if(text, [](const deck::DeckCard& card) {
    return card.name == "CHECK" && card.data.find_first_not_of(" \t\r\n") == std::string::npos;
  });
}

} // namespace

bool put_steps_for_paths(deck::DeckText& text, const model::Model& model) {
  if (model.load_paths.empty() || !model.spectra.empty()) {
    return false;
  }
  std::erase_if(text, [](const deck::DeckCard& card) { return card.name == "LOADPATH"; });
  drop_path_checks(text);
  constexpr int steps = 10;
  for (const model::LoadPathDefinition& path : model.load_paths) {
    const StepEndFactors from = factors_after(model, path.from.index());
    const StepEndFactors to = factors_after(model, path.to.index());
    for (int i = 1; i <= steps; ++i) {
      const double t = path.beyond * i / steps;
      deck::DeckCard step;
      step.name = "STEP";
      step.set("NAME", fmt::format("{}_{}", path.name, i));
      step.data =
          lines_at(from.fits, to.fits, t, "FIT") + lines_at(from.loads, to.loads, t, "LOAD");
      append_card(text, std::move(step));
    }
  }
  return true;
}

} // namespace spricka::program
