// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

const std::vector<std::string> changeable{"STEP", "GROW", "SPECTRUM"};

} // namespace

std::optional<Misfit> Checkpoint::misfit() {
  if (place_.read.empty()) {
    return std::nullopt;
  }
  const auto of = [&](const CardDifference& d) {
    return Misfit{"E561", d.span,
                  fmt::format("{} was written for another deck: {}", place_.read.string(), d.text)};
  };
  if (const auto d =
          first_difference(without(found_.cards, changeable), without(cards_, changeable))) {
    return of(*d);
  }
  if (auto steps = misfit_of_steps()) {
    return steps;
  }
  if (auto growth = misfit_of_growth()) {
    return growth;
  }
  int last = 0;
  for (const KeptEntry& e : found_.entries) {
    last = std::max(last, e.number);
  }
  if (place_.at && *place_.at > last) {
    return Misfit{"E562", model_.restart ? model_.restart->span : base::SourceSpan{},
                  fmt::format("AT={}, but {} holds {} increment{}", *place_.at,
                              place_.read.string(), last, last == 1 ? "" : "s")};
  }
  if (place_.at) {
    std::erase_if(found_.entries, [&](const KeptEntry& e) { return e.number > *place_.at; });
  }
  return std::nullopt;
}

// Steps are walked one after another: those behind the common ones change nothing before them.
std::optional<Misfit> Checkpoint::misfit_of_steps() {
  const std::vector<CardMark> before = only(found_.cards, {"STEP"});
  const std::vector<CardMark> now = only(cards_, {"STEP"});
  const auto d = first_difference(before, now);
  if (!d) {
    return std::nullopt;
  }
  const std::vector<CardMark> shorter(
      before.begin(),
      before.begin() + static_cast<std::ptrdiff_t>(std::min(now.size(), before.size())));
  // Steps that are gone from the end leave the others as they were.
  if (now.size() < before.size() && !first_difference(shorter, now)) {
    dropped_steps_ = before.size() - now.size();
    tell("W561", fmt::format("the last {} of {} steps are gone from the deck: what increments of "
                             "{} say of them is left out",
                             dropped_steps_, before.size(), place_.read.string()));
    return std::nullopt;
  }
  return Misfit{"E561", d->span,
                fmt::format("{}: its increments were solved with other steps: {}",
                            place_.read.string(), d->text)};
}

std::optional<Misfit> Checkpoint::misfit_of_growth() const {
  const auto d = first_difference(only(found_.cards, {"GROW", "SPECTRUM"}),
                                  only(cards_, {"GROW", "SPECTRUM"}));
  if (!d) {
    return std::nullopt;
  }
  const bool lengths = !model_.growth || model_.growth->law == model::CrackGrowthLaw::increment;
  const std::array<double, 2> ends = growth_ends(model_);
  const bool further = ends[0] >= found_.ends[0] && ends[1] >= found_.ends[1];
  // Rates are kept with the stations: another spectrum would have others.
  const bool same_history =
      !first_difference(only(found_.cards, {"SPECTRUM"}), only(cards_, {"SPECTRUM"}));
  if (found_.growth == growth_rules(model_) && (lengths || (further && same_history))) {
    return std::nullopt; // other lengths, or a later end
  }
  if (found_.growth == growth_rules(model_) && same_history) {
    const bool length = ends[0] < found_.ends[0];
    return Misfit{"E561", d->span,
                  fmt::format("{}: its cracks grew for a later end, and may go on to another one "
                              "only if it is later still: {}, which it had as {:.6g}",
                              place_.read.string(),
                              length ? fmt::format("AMAX is {:.6g}", ends[0])
                                     : fmt::format("CYCLES is {:.6g}", ends[1]),
                              found_.ends[length ? 0 : 1])};
  }
  return Misfit{
      "E561", d->span,
      fmt::format("{}: its cracks grew by other rules: {}", place_.read.string(), d->text)};
}

} // namespace spricka::archive
