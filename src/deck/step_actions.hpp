// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/model.hpp"

#include <algorithm>
#include <variant>

namespace spricka::deck {

/// Calls f with each action of a kind in a step, in deck order.
template <class Action, class F> void for_actions(const model::Step& step, F&& f) {
  for (const model::Action& action : step.actions) {
    if (const auto* one = std::get_if<Action>(&action)) {
      f(*one);
    }
  }
}
/// The same in all steps, one after another.
template <class Action, class F> void for_actions(const std::vector<model::Step>& steps, F&& f) {
  for (const model::Step& step : steps) {
    for_actions<Action>(step, f);
  }
}

/// Whether an action of one of some kinds is in a step.
template <class... Actions> bool has_action(const model::Step& step) {
  return std::ranges::any_of(step.actions, [](const model::Action& action) {
    return (std::holds_alternative<Actions>(action) || ...);
  });
}

/// Whether a step mounts or dismounts a contact.
inline bool changes_contacts(const model::Step& step) {
  return has_action<model::MountContact, model::DismountContact>(step);
}

/// Which contacts are there before the first step [contact]: those that no step mounts.
inline std::vector<bool> mounted_at_start(const model::Model& model) {
  std::vector<bool> mounted(model.contacts.size(), true);
  for_actions<model::MountContact>(
      model.steps, [&](const model::MountContact& on) { mounted[on.contact.index()] = false; });
  return mounted;
}

/// Calls f(contact, whether it is there from now on) for each MOUNT and DISMOUNT of a step.
template <class F> void for_mountings(const model::Step& step, F&& f) {
  for (const model::Action& action : step.actions) {
    if (const auto* on = std::get_if<model::MountContact>(&action)) {
      f(on->contact, true);
    } else if (const auto* off = std::get_if<model::DismountContact>(&action)) {
      f(off->contact, false);
    }
  }
}

} // namespace spricka::deck
