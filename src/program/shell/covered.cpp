// SPDX-License-Identifier: GPL-3.0-or-later
// What a parameter would have changed in a session, had it not been set by name before.
#include "analysis/steps/step_factors.hpp"
#include "model/model.hpp"
#include "program/shell/session.hpp"

#include <fmt/format.h>

namespace spricka::program {

analysis::StepFactors ShellSession::factors_at_base(const OriginalCards& cards) const {
  analysis::StepFactors now = analysis::initial_factors(
      *model_, static_cast<Eigen::Index>(model_->cases.size()), model_->contacts.size());
  for (std::size_t s = 0; s <= base_ && s < cards.steps.size(); ++s) {
    analysis::apply_actions(cards.steps[s], now);
  }
  return now;
}

// What the deck says otherwise than before and names set here, or $GROW, do not let through.
std::vector<std::string> ShellSession::covered_by(const OriginalCards& before) const {
  std::vector<std::string> out;
  if (before.cracks.size() != own_.cracks.size() ||
      before.contacts.size() != own_.contacts.size()) {
    return out;
  }
  for (std::size_t c = 0; c < own_.cracks.size(); ++c) {
    const std::string& name = own_.cracks[c].name;
    const bool ellipse = own_.cracks[c].kind == model::CrackDefinitionKind::ellipse;
    const auto is_sized = [](const model::CrackDefinition& a, const model::CrackDefinition& b) {
      return a.a0 == b.a0 && a.plane.a == b.plane.a && a.plane.c == b.plane.c;
    };
    if (is_sized(own_.cracks[c], before.cracks[c])) {
      continue;
    }
    if (const auto set = lengths_.find(name); set != lengths_.end()) {
      out.push_back(
          ellipse ? fmt::format("crack {} keeps the axes set here, A = {:.6g} and C = {:.6g}", name,
                                set->second.a, set->second.c)
                  : fmt::format("crack {} keeps the length set here, {:.6g}", name, set->second.a));
    } else if (!is_sized(model_->cracks[c], own_.cracks[c])) {
      out.push_back(fmt::format("crack {} has the first length of $GROW, {:.6g}, not {}", name,
                                crack_size(c).a, ellipse ? "A and C" : "A0"));
    }
  }
  for (std::size_t c = 0; c < own_.contacts.size(); ++c) {
    const auto set = gaps_.find(own_.contacts[c].name);
    if (own_.contacts[c].gap != before.contacts[c].gap && set != gaps_.end()) {
      out.push_back(fmt::format("contact {0} keeps the interference set here, {1:.6g}: 'fit {0} =' "
                                "sets another, reset takes the deck's",
                                set->first, set->second));
    }
  }
  const analysis::StepFactors old = factors_at_base(before);
  const analysis::StepFactors own = factors_at_base(own_);
  std::vector<model::Step> later = after_;
  later.push_back(changes_);
  for (const model::Step& step : later) {
    for (const model::Action& action : step.actions) {
      const auto* load = std::get_if<model::ApplyLoad>(&action);
      const auto* fit = std::get_if<model::ApplyFit>(&action);
      const auto at = load != nullptr ? static_cast<Eigen::Index>(load->load_case.index()) : 0;
      if (load != nullptr && old.case_factor[at] != own.case_factor[at]) {
        out.push_back(fmt::format("load case {} keeps the factor set here, {:.6g}",
                                  model_->cases[load->load_case.index()].name, load->factor));
      } else if (fit != nullptr && old.fit[fit->contact.index()] != own.fit[fit->contact.index()]) {
        out.push_back(fmt::format("contact {} keeps the factor set here, {:.6g}",
                                  model_->contacts[fit->contact.index()].name, fit->factor));
      }
    }
  }
  return out;
}

} // namespace spricka::program
