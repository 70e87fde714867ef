// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/model.hpp"

#include <algorithm>
#include <variant>
#include <vector>

namespace spricka::deck {

/// Calls f with each action of a kind in a step, in deck order.
template <class StepAction, class F> void for_each_action(const model::Step& step, F&& f) {
  for (const model::StepAction& action : step.actions) {
    if (const auto* one = std::get_if<StepAction>(&action)) {
      f(*one);
    }
  }
}
/// The same in all steps, one after another.
template <class StepAction, class F>
void for_each_action(const std::vector<model::Step>& steps, F&& f) {
  for (const model::Step& step : steps) {
    for_each_action<StepAction>(step, f);
  }
}

/// Whether an action of one of some kinds is in a step.
template <class... Actions> bool has_action(const model::Step& step) {
  return std::ranges::any_of(step.actions, [](const model::StepAction& action) {
    return (std::holds_alternative<Actions>(action) || ...);
  });
}

/// Whether a step mounts or dismounts a contact.
inline bool mounts_or_dismounts_contact(const model::Step& step) {
  return has_action<model::MountContact, model::DismountContact>(step);
}

/// Which contacts are there before the first step [contact]: those that no step mounts.
inline std::vector<bool> contacts_mounted_at_start(const model::Model& model) {
  std::vector<bool> mounted(model.contacts.size(), true);
  for_each_action<model::MountContact>(
      model.steps, [&](const model::MountContact& on) { mounted[on.contact.index()] = false; });
  return mounted;
}

/// Calls f(contact, whether it is there from now on) for each MOUNT and DISMOUNT of a step.
template <class F> void for_each_mounting(const model::Step& step, F&& f) {
  for (const model::StepAction& action : step.actions) {
    if (const auto* on = std::get_if<model::MountContact>(&action)) {
      f(on->contact, true);
    } else if (const auto* off = std::get_if<model::DismountContact>(&action)) {
      f(off->contact, false);
    }
  }
}

/// Loads, fits and contacts as a step leaves them.
struct StepEndState {
  std::vector<double> load;  ///< [case] factor
  std::vector<double> fit;   ///< [contact] factor
  std::vector<bool> mounted; ///< [contact]
};
/// The ends of all steps of a model, in their order.
inline std::vector<StepEndState> step_end_states(const model::Model& model) {
  std::vector<StepEndState> ends;
  StepEndState now{std::vector<double>(model.cases.size(), 0.0),
                   std::vector<double>(model.contacts.size(), 0.0),
                   contacts_mounted_at_start(model)};
  for (const model::Step& step : model.steps) {
    for_each_action<model::ApplyLoad>(step, [&](const model::ApplyLoad& load) {
      now.load[load.load_case.index()] = load.factor;
    });
    for_each_action<model::ApplyFit>(
        step, [&](const model::ApplyFit& fit) { now.fit[fit.contact.index()] = fit.factor; });
    for_each_mounting(step,
                      [&](base::ContactId contact, bool on) { now.mounted[contact.index()] = on; });
    ends.push_back(now);
  }
  return ends;
}

} // namespace spricka::deck
