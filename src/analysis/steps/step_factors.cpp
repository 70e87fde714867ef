// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/step_factors.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <variant>

namespace spricka::analysis {

namespace {

template <class ActionType> bool names(const model::Model& model, base::ContactId contact) {
  for (const model::Step& step : model.steps) {
    for (const model::StepAction& action : step.actions) {
      const auto* a = std::get_if<ActionType>(&action);
      if (a != nullptr && a->contact == contact) {
        return true;
      }
    }
  }
  return false;
}

} // namespace

bool is_fit_set_by_steps(const model::Model& model, base::ContactId contact) {
  return names<model::ApplyFit>(model, contact);
}

bool is_mounted_by_steps(const model::Model& model, base::ContactId contact) {
  return names<model::MountContact>(model, contact);
}

StepActionFactors initial_step_factors(const model::Model& model, Eigen::Index columns,
                                       std::size_t contacts) {
  StepActionFactors factors;
  factors.case_factor = base::Vector::Ones(columns);
  // A column behind the cases is that of the ties' constants, which always count once.
  factors.case_factor.head(static_cast<Eigen::Index>(model.cases.size())).setZero();
  for (std::size_t c = 0; c < contacts; ++c) {
    factors.fit.push_back(names<model::ApplyFit>(model, base::ContactId(c)) ? 0.0 : 1.0);
    factors.mounted.push_back(!names<model::MountContact>(model, base::ContactId(c)));
  }
  return factors;
}

StepActionFactors interpolate_step_factors(const StepActionFactors& from,
                                           const StepActionFactors& to, double part) {
  StepActionFactors factors = to;
  if (part < 1.0) {
    factors.case_factor = from.case_factor + part * (to.case_factor - from.case_factor);
    for (std::size_t c = 0; c < to.fit.size(); ++c) {
      factors.fit[c] = from.fit[c] + part * (to.fit[c] - from.fit[c]);
    }
  }
  return factors;
}

MountChanges apply_step_actions(const model::Step& step, StepActionFactors& factors) {
  MountChanges changes;
  for (const model::StepAction& action : step.actions) {
    if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
      factors.case_factor[static_cast<Eigen::Index>(load->load_case.index())] = load->factor;
    } else if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
      factors.fit[fit->contact.index()] = fit->factor;
    } else if (const auto* on = std::get_if<model::MountContact>(&action)) {
      factors.mounted[on->contact.index()] = true;
      changes.mounted.push_back(on->contact.index());
    } else if (const auto* off = std::get_if<model::DismountContact>(&action)) {
      factors.mounted[off->contact.index()] = false;
      changes.dismounted.push_back(off->contact.index());
    }
  }
  return changes;
}

std::vector<std::optional<std::size_t>> repeated_steps(const model::Model& model) {
  std::vector<std::optional<std::size_t>> same(model.steps.size());
  const auto rubs = [](const auto& part) { return part.mu > 0.0; };
  if (std::ranges::any_of(model.contacts, rubs) || std::ranges::any_of(model.cracks, rubs)) {
    return same;
  }
  std::vector<StepActionFactors> ends;
  StepActionFactors factors = initial_step_factors(
      model, static_cast<Eigen::Index>(model.cases.size()), model.contacts.size());
  std::size_t first = 0; // since the last change of what is mounted
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    const MountChanges changes = apply_step_actions(model.steps[s], factors);
    // An offset of MOUNT hangs on the state it was taken in: equal factors are no equal state
    // across it.
    first = changes.mounted.empty() && changes.dismounted.empty() ? first : s;
    for (std::size_t r = first; r < s && !same[s]; ++r) {
      if (ends[r].case_factor == factors.case_factor && ends[r].fit == factors.fit) {
        same[s] = r;
      }
    }
    ends.push_back(factors);
  }
  return same;
}

} // namespace spricka::analysis
