// SPDX-License-Identifier: GPL-3.0-or-later
// Crack lengths that are set in a session.
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "program/shell/session.hpp"
#include "program/shell/trouble.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

void join(analysis::RegionPlan& plan, const analysis::RegionPlan& more) {
  for (std::size_t e = 0; e < plan.region.size(); ++e) {
    plan.region[e] = plan.region[e] || more.region[e];
  }
}

void set_size(model::CrackDefinition& crack, const CrackSize& size) {
  if (crack.kind == model::CrackDefinitionKind::ellipse) {
    crack.plane.a = size.a;
    crack.plane.c = size.c;
  } else {
    crack.a0 = size.a;
  }
}

// What another size needs to know of a crack; or why there is none.
base::Trouble sizeable(const model::CrackDefinition& crack, bool with_c) {
  if (crack.kind == model::CrackDefinitionKind::drawn) {
    return invalid_input(
        fmt::format("the front of crack {} is drawn by its points, it has no length", crack.name),
        "make its points expressions of a parameter and use set");
  }
  if (crack.kind == model::CrackDefinitionKind::front) {
    return invalid_input(
        fmt::format("crack {} is one of the mesh: it has a front, no length", crack.name));
  }
  if (with_c && crack.kind != model::CrackDefinitionKind::ellipse) {
    return invalid_input(
        fmt::format("crack {} has one length: there is no second axis", crack.name));
  }
  return {};
}

} // namespace

void ShellSession::set_lengths_on(model::Model& model) const {
  for (const auto& [name, size] : lengths_) {
    set_size(*std::ranges::find(model.cracks, name, &model::CrackDefinition::name), size);
  }
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

analysis::RegionPlan ShellSession::plan_lengths() const {
  base::Diagnostics ignored;
  analysis::RegionPlan needed = analysis::plan_region(*model_, {0.0, 0.0}, ignored);
  if (!needed.split ||
      (plan_.split && std::ranges::equal(plan_.region, needed.region,
                                         [](bool has, bool needs) { return has || !needs; }))) {
    return needed.split ? plan_ : needed;
  }
  if (plan_.split) {
    join(needed, plan_);
  }
  // Lengths to come are likely to be near: room for half and for half as much again.
  model::Model near = *model_;
  for (const double times : {0.5, 0.75, 1.25, 1.5}) {
    base::Diagnostics misfit; // a length that does not fit needs no room
    for (std::size_t c = 0; c < near.cracks.size(); ++c) {
      const std::optional<double> a = model_->cracks[c].a0;
      near.cracks[c].a0 = a ? std::optional(times * *a) : std::nullopt;
    }
    const analysis::RegionPlan more = analysis::plan_region(near, {0.0, 0.0}, misfit);
    if (!misfit.has_errors()) {
      join(needed, more);
    }
  }
  return needed;
}

base::Trouble ShellSession::set_crack_length(const std::string& crack, double a,
                                             std::optional<double> c) {
  std::size_t index = 0;
  if (base::Trouble trouble = find_name(crack_names(*model_), "crack", crack, index)) {
    return trouble;
  }
  for (const double size : {a, c.value_or(a)}) {
    if (!(size > 0.0) || !std::isfinite(size)) {
      return invalid_input(fmt::format("a crack length is positive, not {:.6g}", size));
    }
  }
  if (base::Trouble trouble = sizeable(model_->cracks[index], c.has_value())) {
    return trouble;
  }
  const model::CrackDefinition before = model_->cracks[index];
  analysis::RegionPlan plan = plan_;
  CrackSize size{a, 0.0};
  if (before.kind == model::CrackDefinitionKind::ellipse) {
    size.c = c.value_or(a / before.plane.a * before.plane.c);
  }
  set_size(model_->cracks[index], size);
  plan_ = plan_lengths();
  if (base::Trouble trouble = rebuild()) {
    model_->cracks[index] = before;
    plan_ = std::move(plan);
    return trouble;
  }
  lengths_[crack] = size;
  return {};
}

} // namespace spricka::program
