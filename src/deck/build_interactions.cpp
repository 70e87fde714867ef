// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "model/model.hpp"

#include <array>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

/// How the cycles of a spectrum act on each other.
namespace spricka::deck {

namespace {

using model::CrackGrowthLaw;
using model::InteractionRule;

constexpr double pi = std::numbers::pi;
constexpr std::array zone_factors{
    std::pair("IRWIN2", 1.0 / (2.0 * pi)),
    std::pair("IRWIN6", 1.0 / (6.0 * pi)),
    std::pair("IRWIN_FULL", 1.0 / pi),
    std::pair("DUGDALE", pi / 8.0),
    std::pair("NASGRO_STRESS", pi / 8.0 / (1.15 * 1.15)),
    std::pair("NASGRO_STRAIN", pi / 8.0 / (2.55 * 2.55)),
};

constexpr std::array interaction_rules{
    std::pair("WHEELER", InteractionRule::wheeler),
    std::pair("WILLENBORG_1971", InteractionRule::willenborg_1971),
    std::pair("WILLENBORG", InteractionRule::willenborg),
    std::pair("MODIFIED", InteractionRule::modified),
    std::pair("CHANG", InteractionRule::chang),
    std::pair("CLOSURE", InteractionRule::closure),
};

void read_plastic_zone(DeckContext& c, const CheckedCard& card,
                       model::LoadInteractionDefinition& interaction) {
  if (interaction.rule == InteractionRule::closure) {
    return;
  }
  interaction.yield_stress = card.number_value("YIELD");
  if (card.has_key("KAPPA")) {
    interaction.zone_factor = card.number_value("KAPPA");
    return;
  }
  for (const auto& [name, factor] : zone_factors) {
    if (card.key_has_word("ZONE", name)) {
      interaction.zone_name = name;
      interaction.zone_factor = factor;
    }
  }
  if (interaction.zone_name.empty()) {
    c.error(card.span, "E106",
            fmt::format("$INTERACTION TYPE={} needs ZONE or KAPPA", card.word_value("TYPE")),
            "the plastic zone over (Kmax/YIELD)^2: ZONE=IRWIN2 is 1/(2 pi), in plane stress; "
            "ZONE=IRWIN6 is a third of it, in plane strain");
  }
}

void read_interaction(DeckContext& c, const CheckedCard& card) {
  model::LoadInteractionDefinition interaction;
  interaction.name = card.word_value("NAME");
  for (const auto& [name, rule] : interaction_rules) {
    interaction.rule = card.key_has_word("TYPE", name) ? rule : interaction.rule;
  }
  if (interaction.name == "NONE") {
    c.error(card.find("NAME")->span, "E108",
            "NAME: NONE is what cycles are that do not act on each other", "another name");
  }
  read_plastic_zone(c, card, interaction);
  interaction.exponent = card.number_value("W");
  interaction.shut_off_ratio = card.number_value("SOLR");
  interaction.threshold = card.optional_number("KTH");
  interaction.negative_minimum_is_zero =
      interaction.rule == InteractionRule::willenborg_1971 || card.key_has_word("MINIMUM", "ZERO");
  interaction.underload_factor = card.number_value("PHI0");
  interaction.threshold_slope = card.number_value("A");
  interaction.negative_exponent = card.number_value("Q");
  interaction.largest_ratio = card.number_value("RHIGH");
  interaction.smallest_ratio = card.number_value("RLOW");
  interaction.constraint = card.number_value("ALPHA");
  interaction.stress_ratio = card.number_value("SMAX");
  interaction.span = card.span;
  c.model.interactions.push_back(std::move(interaction));
}

/// Why a law does not serve an interaction, and what to do; empty: it does.
std::pair<std::string, std::string> misfit(const model::LoadInteractionDefinition& interaction,
                                           const model::CrackGrowthSettings& growth) {
  const model::GrowthLawConstants& law = growth.constants;
  const bool has_threshold = law.threshold > 0.0 || law.threshold_over_ratio;
  switch (interaction.rule) {
  case InteractionRule::willenborg_1971:
  case InteractionRule::willenborg:
  case InteractionRule::modified:
    if (growth.law == CrackGrowthLaw::paris ||
        (growth.law == CrackGrowthLaw::table && law.table_ratios.size() < 2)) {
      return {"it lowers K_max and K_min alike and acts by R alone, which the law does not know: "
              "it would do nothing",
              "LAW=WALKER, FORMAN or NASGRO, or TYPE=WHEELER"};
    }
    break;
  case InteractionRule::chang:
    if (growth.law != CrackGrowthLaw::walker || has_threshold ||
        law.at_negative_ratio != model::NegativeRatioRule::positive_part) {
      return {"it has a rule for R < 0 and a threshold of its own, and takes only WALKER without "
              "either",
              "LAW=WALKER without DKTH, DK0, DK1 and NEGATIVE"};
    }
    break;
  case InteractionRule::closure:
    if (growth.law != CrackGrowthLaw::paris) {
      return {"the effective range of K is what the law is given: one that knows R would count "
              "closure twice",
              "LAW=PARIS with C and M of the effective range"};
    }
    break;
  case InteractionRule::wheeler:
    break;
  }
  return {};
}

} // namespace

void build_interactions(DeckContext& context) {
  context.for_each_sound_card("INTERACTION",
                              [&](const CheckedCard& card) { read_interaction(context, card); });
}

void read_growth_interactions(DeckContext& context, const CheckedCard& card,
                              model::CrackGrowthSettings& growth) {
  if (!card.has_key("INTERACTION")) {
    return;
  }
  for (const NameReference& name : card.find("INTERACTION")->names) {
    std::optional<std::size_t> index;
    if (!is_no_interaction(EntityKind::interaction, name)) {
      const NameDefinition* found =
          find_referenced_definition(context, EntityKind::interaction, name);
      if (found == nullptr || found->index >= context.model.interactions.size()) {
        continue;
      }
      index = found->index;
      const auto [why, hint] = misfit(context.model.interactions[*index], growth);
      if (!why.empty()) {
        context.error(name.span, "E341", fmt::format("interaction {}: {}", name.name, why), hint);
      }
    }
    if (std::ranges::find(growth.interactions, index) != growth.interactions.end()) {
      context.error(name.span, "E110", fmt::format("INTERACTION names {} twice", name.name));
      continue;
    }
    growth.interactions.push_back(index);
  }
}

} // namespace spricka::deck
