// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

const std::vector<std::string> changeable{"STEP", "GROW", "SPECTRUM"};

// Cracks that grew by the same rules may go on: to other lengths, or to a later end.
std::optional<CheckpointMismatch> growth_mismatch(const CheckpointList& found,
                                                  const std::vector<CardFingerprint>& cards,
                                                  const model::Model& model,
                                                  const std::string& file) {
  const auto d = first_card_difference(select_cards(found.cards, {"GROW", "SPECTRUM"}),
                                       select_cards(cards, {"GROW", "SPECTRUM"}));
  if (!d) {
    return std::nullopt;
  }
  const bool lengths = !model.growth || model.growth->law == model::CrackGrowthLaw::increment;
  const std::array<double, 2> ends = growth_length_and_cycle_limits(model);
  const bool further = ends[0] >= found.ends[0] && ends[1] >= found.ends[1];
  // Rates are kept with the stations: another spectrum would have others.
  const bool same_history = !first_card_difference(select_cards(found.cards, {"SPECTRUM"}),
                                                   select_cards(cards, {"SPECTRUM"}));
  if (found.growth == growth_settings_text(model) && (lengths || (further && same_history))) {
    return std::nullopt;
  }
  if (found.growth == growth_settings_text(model) && same_history) {
    const bool length = ends[0] < found.ends[0];
    return CheckpointMismatch{
        "E561", d->span,
        fmt::format("{}: its cracks grew for a later end, and may go on to another one "
                    "only if it is later still: {}, which it had as {:.6g}",
                    file,
                    length ? fmt::format("AMAX is {:.6g}", ends[0])
                           : fmt::format("CYCLES is {:.6g}", ends[1]),
                    found.ends[length ? 0 : 1])};
  }
  return CheckpointMismatch{"E561", d->span,
                            fmt::format("{}: its cracks grew by other rules: {}", file, d->text)};
}

} // namespace

std::optional<CheckpointMismatch> Checkpoint::find_mismatch() {
  if (place_.read.empty()) {
    return std::nullopt;
  }
  const auto of = [&](const CardDifference& d) {
    return CheckpointMismatch{
        "E561", d.span,
        fmt::format("{} was written for another deck: {}", place_.read.string(), d.text)};
  };
  if (const auto d = first_card_difference(exclude_cards(found_.cards, changeable),
                                           exclude_cards(cards_, changeable))) {
    return of(*d);
  }
  if (auto steps = misfit_of_steps()) {
    return steps;
  }
  if (auto growth = growth_mismatch(found_, cards_, model_, place_.read.string())) {
    return growth;
  }
  int last = 0;
  for (const CheckpointEntry& e : found_.entries) {
    last = std::max(last, e.number);
  }
  if (place_.at && *place_.at > last) {
    return CheckpointMismatch{"E562", model_.restart ? model_.restart->span : base::SourceSpan{},
                              fmt::format("AT={}, but {} holds {} increment{}", *place_.at,
                                          place_.read.string(), last, last == 1 ? "" : "s")};
  }
  if (place_.at) {
    std::erase_if(found_.entries, [&](const CheckpointEntry& e) { return e.number > *place_.at; });
  }
  return std::nullopt;
}

// Steps are walked one after another: those behind the common ones change nothing before them.
std::optional<CheckpointMismatch> Checkpoint::misfit_of_steps() {
  const std::vector<CardFingerprint> before = select_cards(found_.cards, {"STEP"});
  const std::vector<CardFingerprint> now = select_cards(cards_, {"STEP"});
  const auto d = first_card_difference(before, now);
  if (!d) {
    return std::nullopt;
  }
  const std::vector<CardFingerprint> shorter(
      before.begin(),
      before.begin() + static_cast<std::ptrdiff_t>(std::min(now.size(), before.size())));
  // Steps that are gone from the end leave the others as they were.
  if (now.size() < before.size() && !first_card_difference(shorter, now)) {
    dropped_steps_ = before.size() - now.size();
    tell("W561", fmt::format("the last {} of {} steps are gone from the deck: what increments of "
                             "{} say of them is left out",
                             dropped_steps_, before.size(), place_.read.string()));
    return std::nullopt;
  }
  return CheckpointMismatch{"E561", d->span,
                            fmt::format("{}: its increments were solved with other steps: {}",
                                        place_.read.string(), d->text)};
}

} // namespace spricka::archive
