// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/checkpoint.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

const std::vector<std::string> changeable{"STEP", "GROW", "SPECTRUM", "INTERACTION", "LAW"};

bool grows_by_law(const model::Model& model) {
  return model.growth && model.growth->law != model::CrackGrowthLaw::increment;
}

struct DecksCompared {
  const CheckpointList& found;
  const std::vector<CardFingerprint>& cards; ///< of the deck now
  const model::Model& model;
  std::string file; ///< that is read
};

// Cracks that grew by the same rules may go on: to other lengths, or to a later end. Fronts serve
// another law and a nearer end, too, as far as these lead to them (`another_law`).
std::optional<CheckpointMismatch>
growth_mismatch(const DecksCompared& decks,
                const std::function<std::string()>& why_law_moves_fronts, bool& another_law) {
  const auto& [found, cards, model, file] = decks;
  auto d =
      first_card_difference(select_cards(found.cards, {"GROW", "SPECTRUM", "INTERACTION", "LAW"}),
                            select_cards(cards, {"GROW", "SPECTRUM", "INTERACTION", "LAW"}));
  const bool same = found.growth == growth_settings_text(model);
  if (!d && !same && model.growth && !model.growth->data.name.empty()) {
    // the file that it is in has changed
    d = CardDifference{.span = model.growth->span,
                       .text =
                           fmt::format("the law {} has other constants", model.growth->data.name)};
  }
  if (!d) {
    return std::nullopt;
  }
  const bool lengths = !grows_by_law(model);
  const std::array<double, 2> ends = growth_length_and_cycle_limits(model);
  const bool further = ends[0] >= found.ends[0] && ends[1] >= found.ends[1];
  // Rates are kept with the stations: other cycles would have others.
  const bool same_history =
      !first_card_difference(select_cards(found.cards, {"SPECTRUM", "INTERACTION"}),
                             select_cards(cards, {"SPECTRUM", "INTERACTION"}));
  if (same && (lengths || (further && same_history))) {
    return std::nullopt;
  }
  std::string why;
  if (!lengths && found.course == growth_course_text(model)) {
    why = why_law_moves_fronts();
    another_law = why.empty();
  }
  if (another_law) {
    return std::nullopt;
  }
  if (same && same_history) {
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
                            fmt::format("{}: its cracks grew by other rules: {}{}", file, d->text,
                                        why.empty() ? "" : "; " + why)};
}

// Of fronts that were taken over from another law only the last one has a state of this one: with
// AT the growth does not go on from there.
bool is_last_state_of_another_law(const DecksCompared& decks) {
  const std::vector<CheckpointEntry>& entries = decks.found.entries;
  const auto last = std::ranges::max_element(
      entries, {}, [](const CheckpointEntry& e) { return std::pair(e.round, e.number); });
  return grows_by_law(decks.model) && last != entries.end() &&
         last->law != growth_law_text(decks.model, decks.cards);
}

// Steps are walked one after another: those behind the common ones change nothing before them.
// `dropped`: how many are gone.
std::optional<CheckpointMismatch> step_mismatch(const DecksCompared& decks, std::size_t& dropped) {
  const std::vector<CardFingerprint> before = select_cards(decks.found.cards, {"STEP"});
  const std::vector<CardFingerprint> now = select_cards(decks.cards, {"STEP"});
  const auto d = first_card_difference(before, now);
  if (!d) {
    return std::nullopt;
  }
  const std::vector<CardFingerprint> shorter(
      before.begin(),
      before.begin() + static_cast<std::ptrdiff_t>(std::min(now.size(), before.size())));
  // Steps that are gone from the end leave the others as they were.
  if (now.size() < before.size() && !first_card_difference(shorter, now)) {
    dropped = before.size() - now.size();
    return std::nullopt;
  }
  return CheckpointMismatch{
      "E561", d->span,
      fmt::format("{}: its increments were solved with other steps: {}", decks.file, d->text)};
}

} // namespace

std::optional<CheckpointMismatch>
Checkpoint::find_mismatch(const std::function<std::string()>& why_law_moves_fronts) {
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
  const DecksCompared decks{found_, cards_, model_, place_.read.string()};
  if (auto steps = step_mismatch(decks, dropped_steps_)) {
    return steps;
  }
  if (dropped_steps_ > 0) {
    tell("W561",
         fmt::format("the last {} of {} steps are gone from the deck: what increments of "
                     "{} say of them is left out",
                     dropped_steps_, select_cards(found_.cards, {"STEP"}).size(), decks.file));
  }
  if (auto growth = growth_mismatch(decks, why_law_moves_fronts, another_law_)) {
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
  another_law_ = another_law_ || is_last_state_of_another_law(decks);
  return std::nullopt;
}

} // namespace spricka::archive
