// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/deck_changes.hpp"

#include "deck/step_actions.hpp"
#include "deck/typed_line.hpp"
#include "program/shell/deck_edit.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// What an action is about; of two with the same the later one counts.
std::pair<int, std::size_t> subject(const model::StepAction& action) {
  if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
    return {0, load->load_case.index()};
  }
  if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
    return {1, fit->contact.index()};
  }
  const auto* on = std::get_if<model::MountContact>(&action);
  return {2, on != nullptr ? on->contact.index()
                           : std::get<model::DismountContact>(action).contact.index()};
}

void put(std::vector<model::StepAction>& actions, const model::StepAction& action) {
  std::erase_if(actions, [&](const model::StepAction& a) { return subject(a) == subject(action); });
  actions.push_back(action);
}

// A contact that changes its state; what is pending the other way is taken back. What is in force
// would count its fit a second time, from bodies that have it already.
base::OptionalFailure refuse_mounting(const model::Model& model,
                                      const analysis::StepActionFactors& now,
                                      const model::Step& pending, base::ContactId contact,
                                      bool on) {
  const std::string& name = model.contacts[contact.index()].name;
  if (keeps_first_mounting(model)) {
    return invalid_input(
        "with $GROW MOUNTED=FIRST a contact keeps what it took on at the first length: "
        "nothing is mounted or dismounted here");
  }
  const bool reverts = std::ranges::any_of(pending.actions, [&](const model::StepAction& a) {
    return subject(a) == std::pair(2, contact.index());
  });
  if (now.mounted[contact.index()] == on && !reverts) {
    return invalid_input(
        fmt::format("contact {} is {} already", name, on ? "mounted" : "absent"),
        on ? "dismount it first: mounted anew, its fit counts from the bodies as they are then"
           : "mount puts it in");
  }
  return {};
}

} // namespace

bool keeps_first_mounting(const model::Model& model) {
  return model.growth && model.growth->mounted == model::ContactMountingPolicy::first;
}

std::vector<model::Step> steps_up_to(const model::Model& model, std::size_t step) {
  return {model.steps.begin(), model.steps.begin() + static_cast<std::ptrdiff_t>(step) + 1};
}

std::vector<model::Step> steps_up_to(const model::Model& model, const SessionDeckChanges& changes) {
  std::vector<model::Step> steps = steps_up_to(model, changes.base);
  steps.insert(steps.end(), changes.applied.begin(), changes.applied.end());
  return steps;
}

base::OptionalFailure add_step_action(const model::Model& model,
                                      const analysis::StepActionFactors& now,
                                      const std::string& line, model::Step& pending) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Step> step = deck::read_step_line(model, line, sources, diagnostics);
  if (!step) {
    return located_failure(base::ProgramOutcome::usage, sources, diagnostics);
  }
  const model::StepAction& action = step->actions.front();
  const auto* fit = std::get_if<model::ApplyFit>(&action);
  if (fit != nullptr && !model.contacts[fit->contact.index()].gap) {
    const std::string& contact = model.contacts[fit->contact.index()].name;
    return invalid_input(
        fmt::format("contact {} has no declared fit that a factor could scale", contact),
        fmt::format("$CONTACT NAME={} INTERFERENCE=0.05 declares one", contact));
  }
  if (subject(action).first == 2) {
    const base::ContactId contact(subject(action).second);
    const bool on = std::holds_alternative<model::MountContact>(action);
    if (base::OptionalFailure trouble = refuse_mounting(model, now, pending, contact, on)) {
      return trouble;
    }
    if (now.mounted[contact.index()] == on) { // a change that was pending is taken back
      std::erase_if(pending.actions,
                    [&](const model::StepAction& a) { return subject(a) == subject(action); });
    } else {
      put(pending.actions, action);
    }
  } else {
    put(pending.actions, action);
  }
  return {};
}

void append_applied_step(const model::Model& model, const model::Step& next,
                         std::vector<model::Step>& applied) {
  if (!applied.empty() && !model::has_friction(model) && !deck::mounts_or_dismounts_contact(next) &&
      !deck::mounts_or_dismounts_contact(applied.back())) {
    for (const model::StepAction& action : next.actions) {
      put(applied.back().actions, action);
    }
  } else {
    applied.push_back(next);
  }
}

} // namespace spricka::program
