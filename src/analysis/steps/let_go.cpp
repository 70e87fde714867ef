// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/let_go.hpp"

#include "analysis/steps/step_factors.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// The body that a refusal of an unheld load names; null: another refusal, or a cause is told
// already.
const SubstructuredBody* body_named(const std::vector<SubstructuredBody>& bodies,
                                    std::string_view refusal) {
  constexpr std::string_view before = "body ";
  constexpr std::string_view behind = " is loaded but not held";
  const std::size_t end = refusal.find(behind);
  const std::size_t begin = refusal.rfind(before, end);
  if (end == std::string_view::npos || begin == std::string_view::npos ||
      refusal.find("no $CONTACT") != std::string_view::npos) {
    return nullptr;
  }
  const std::string_view name = refusal.substr(begin + before.size(), end - begin - before.size());
  const auto found = std::ranges::find_if(
      bodies, [&](const SubstructuredBody& body) { return std::string_view(body.name) == name; });
  return found == bodies.end() ? nullptr : &*found;
}

bool has(const SubstructuredBody& body, const contact::ContactSurface& surface) {
  return !surface.facets.empty() &&
         std::ranges::binary_search(body.body.nodes, surface.facets.front().nodes.front());
}

// When a contact that is not mounted in a step was or will be; empty: it is mounted.
std::string not_there(const model::Model& model, std::size_t contact, const model::Step& at) {
  StepActionFactors factors = initial_step_factors(
      model, static_cast<Eigen::Index>(model.cases.size()), model.contacts.size());
  std::string gone;
  std::string comes;
  bool behind = false;
  bool there = factors.mounted[contact];
  bool there_then = there;
  for (const model::Step& step : model.steps) {
    apply_step_actions(step, factors);
    const bool now = factors.mounted[contact];
    if (!behind) {
      gone = there && !now ? step.name : now ? std::string() : gone;
      there_then = now;
    } else if (now && comes.empty()) {
      comes = step.name;
    }
    there = now;
    behind = behind || &step == &at;
  }
  return there_then      ? ""
         : !gone.empty() ? fmt::format("was dismounted in step {}", gone)
                         : fmt::format("is not mounted before step {}", comes);
}

} // namespace

std::string explain_release(const model::Model& model, const Discretisation& scene,
                            const std::vector<SubstructuredBody>& bodies, const model::Step& step,
                            std::string_view refusal) {
  const SubstructuredBody* body = body_named(bodies, refusal);
  if (body == nullptr) {
    return {};
  }
  std::string absent;
  std::string pressing;
  for (std::size_t c = 0; c < model.contacts.size() && c < scene.pairs.size(); ++c) {
    const contact::PairConstraints& pair = scene.pairs[c];
    if (!has(*body, pair.contact) && !has(*body, pair.target)) {
      continue;
    }
    const std::string& name = model.contacts[c].name;
    if (const std::string when = not_there(model, c, step); !when.empty()) {
      absent += fmt::format("{}contact {} {}", absent.empty() ? "" : ", ", name, when);
    } else if (model.contacts[c].type == model::ContactType::unilateral) {
      pressing += fmt::format("{}{}", pressing.empty() ? "" : ", ", name);
    }
  }
  if (!absent.empty()) {
    return ": its " + absent;
  }
  return pressing.empty()
             ? ""
             : fmt::format(": contact {} only presses and does not hold it so", pressing);
}

} // namespace spricka::analysis
