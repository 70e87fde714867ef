// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/output_units.hpp"
#include "deck/step_actions.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

/// What steps and the growth of a crack ask for together that nobody means, or hardly anybody.
namespace spricka::deck {

namespace {

// Whether the deck gives a contact the number 0 as its gap; an expression may have other values.
bool is_net_fit(const DeckContext& c, const model::Contact& contact) {
  if (contact.gap != 0.0) {
    return false;
  }
  const CheckedCard* card = c.find_sound_card_named("CONTACT", contact.name);
  const bool has_gap = card != nullptr && card->has_key("GAP");
  return has_gap && c.sources.text(card->find("GAP")->span).find('(') == std::string_view::npos;
}

// At the end of every step; what a fit of gap 0 is scaled by counts for nothing.
std::vector<StepEndState> factors_of_steps(const DeckContext& c) {
  std::vector<StepEndState> ends = step_end_states(c.model);
  for (std::size_t i = 0; i < c.model.contacts.size(); ++i) {
    const bool none = is_net_fit(c, c.model.contacts[i]);
    for (StepEndState& end : ends) {
      end.fit[i] = none ? 0.0 : end.fit[i];
    }
  }
  return ends;
}

void unused_cases(DeckContext& c) {
  std::vector<bool> used(c.model.cases.size(), false);
  for_each_action<model::ApplyLoad>(
      c.model.steps, [&](const model::ApplyLoad& load) { used[load.load_case.index()] = true; });
  for (std::size_t i = 0; i < used.size() && !c.model.steps.empty(); ++i) {
    const model::LoadCase& load_case = c.model.cases[i];
    if (!used[i] && !load_case.loads.empty()) {
      c.warning(load_case.loads.front().span, "W452",
                fmt::format("load case {} is in no $STEP: it acts nowhere", load_case.name),
                fmt::format("a line LOAD {} 1 below a $STEP", load_case.name));
    }
  }
}

// A first step says where the others begin, with LOAD .. 0 too; one without a line solves what is
// there from the beginning.
void idle_steps(DeckContext& c, const std::vector<StepEndState>& factors) {
  for (std::size_t s = 0; s < factors.size(); ++s) {
    const model::Step& step = c.model.steps[s];
    const bool loads = has_action<model::ApplyLoad>(step);
    const auto is_zero = [](double factor) { return factor == 0.0; };
    const bool none = std::ranges::all_of(factors[s].load, is_zero) &&
                      std::ranges::all_of(factors[s].fit, is_zero);
    const bool first = s == 0 && !loads && !step.actions.empty() && none;
    const bool later =
        s > 0 && factors[s].load == factors[s - 1].load && factors[s].fit == factors[s - 1].fit;
    if ((first || later) && !mounts_or_dismounts_contact(step)) {
      c.warning(
          step.span, "W453",
          s == 0
              ? fmt::format("step {} changes nothing: its fits have GAP=0", step.name)
              : fmt::format("step {} changes nothing: it ends with the loads and fits of step {}",
                            step.name, c.model.steps[s - 1].name),
          "LOAD case factor, FIT contact factor, MOUNT or DISMOUNT below it; or take it away");
    }
  }
}

// Where K has no other cause than the loads, more of them at KMIN is KMIN and KMAX exchanged.
void exchanged_steps(DeckContext& c, const CheckedCard& card,
                     const std::vector<StepEndState>& factors) {
  const model::CrackGrowthSettings& growth = *c.model.growth;
  if (!growth.kmax.valid() || !growth.kmin.valid() || !c.model.contacts.empty() ||
      !c.model.mpcs.empty()) {
    return;
  }
  const std::vector<double>& high = factors[growth.kmax.index()].load;
  const std::vector<double>& low = factors[growth.kmin.index()].load;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    product += high[i] * low[i];
    square += low[i] * low[i];
  }
  const double r = square > 0.0 ? product / square : 1.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    apart = std::max(apart, std::abs(high[i] - r * low[i]));
  }
  if (r >= 0.0 && r < 1.0 && apart <= 1e-12 * std::sqrt(square)) {
    c.error(card.value_span("KMAX"), "E453",
            fmt::format("the loads at KMAX are {:.4g} times those at KMIN: nothing could grow", r),
            "KMAX names the step with the largest K, KMIN that with the smallest");
  }
}

std::string_view threshold_key(const CheckedCard& card) {
  return card.has_key("DK0") ? "DK0" : card.has_key("DK1") ? "DK1" : "DKTH";
}

// Fits have slopes of 0 to 4 above R = 0, of some tenths below, and lengths of some hundredths of
// a millimetre.
void odd_threshold(DeckContext& c, const CheckedCard& card,
                   const model::ThresholdOverRatio& threshold) {
  constexpr double longest = 1e-3; // [m]
  if (threshold.intrinsic_length * c.model.units.metre_per_length > longest) {
    c.warning(card.value_span("AINTRINSIC"), "W455",
              fmt::format("AINTRINSIC = {:.4g} {}: cracks as long as this would count as short",
                          threshold.intrinsic_length, c.model.units.length_name),
              "it is 0.0381 mm in NASGRO's fits, and counts in the unit of lengths of the deck");
  }
  if (threshold.slope_above < 0.0 || threshold.slope_above > 5.0 ||
      std::abs(threshold.slope_below) > 1.0) {
    const bool above = std::abs(threshold.slope_below) <= 1.0;
    c.warning(card.value_span(above ? "CTHP" : "CTHM"), "W455",
              fmt::format("{} = {:.4g}: fits have 0 to 4 for CTHP and some tenths for CTHM",
                          above ? "CTHP" : "CTHM",
                          above ? threshold.slope_above : threshold.slope_below),
              "are the two exchanged?");
  }
}

// Of $GROW or $LAW.
void odd_constants(DeckContext& c, const CheckedCard& card, model::CrackGrowthLaw type,
                   const model::GrowthLawConstants& law) {
  const double threshold =
      law.threshold_over_ratio ? law.threshold_over_ratio->delta_k : law.threshold;
  const auto look = [&](std::string_view key, std::string_view name, const auto& K_c) {
    if (K_c && *K_c <= threshold) {
      c.error(card.value_span(key), "E454",
              fmt::format("{} = {:.4g} is not above {} = {:.4g} (in KUNIT): nothing could grow",
                          name, *K_c / law.k_unit, threshold_key(card), threshold / law.k_unit),
              "numbers without a unit are in KUNIT");
    }
  };
  look(card.has_key("K1C") ? "K1C" : "KC", "KC", law.k_c);
  look("KIE", "KIE", law.k_part_through);
  if (card.spec->name == "GROW" && law.k_part_through &&
      std::ranges::all_of(c.model.cracks, &model::CrackDefinition::is_line)) {
    c.error(card.value_span("KIE"), "E110",
            "KIE is the toughness of surface and corner cracks, of which the deck has none",
            "KC, or K1C and its constants, are those of through cracks");
  }
  if (law.threshold_over_ratio) {
    odd_threshold(c, card, *law.threshold_over_ratio);
  }
  if (type == model::CrackGrowthLaw::walker && (law.p < 0.0 || law.p > 1.0)) {
    c.warning(
        card.value_span("P"), "W455",
        fmt::format("P = {:.4g} is not within 0 and 1: da/dN = C (delta K / (1-R)^(1-P))^M", law.p),
        "P = 1 is Paris' law, P = 0 knows K_max alone, metals have 0.3 to 0.8; other books write "
        "(1-R)^P or M*(1-P) as the exponent");
  }
  if (law.at_negative_ratio == model::NegativeRatioRule::whole_range &&
      (law.p_below < 0.0 || law.p_below > 1.0)) {
    c.warning(card.value_span("PM"), "W455",
              fmt::format("PM = {:.4g} is not within 0 and 1: for R < 0 da/dN = C (delta K / "
                          "(1-R)^(1-PM))^M",
                          law.p_below),
              "PM = 0 knows K_max alone; metals have 0 to 0.3");
  }
  if (type == model::CrackGrowthLaw::nasgro && (law.p < 0.0 || law.q < 0.0)) {
    c.warning(card.value_span(law.p < 0.0 ? "P" : "Q"), "W455",
              "a negative P or Q makes the law slower towards KC, or faster towards "
              "DKTH",
              "P and Q of NASGRO are 0 to 1");
  }
  const bool has_M = type != model::CrackGrowthLaw::table;
  if (has_M && (law.m < 1.0 || law.m > 15.0)) {
    c.warning(card.value_span("M"), "W455",
              fmt::format("M = {:.4g}: exponents of growth laws are 2 to 5", law.m),
              law.C > 1.0 ? "are C and M exchanged?" : "");
  }
}

// Lengths of $GROW count, not A0; those that are all shorter were hardly meant.
void shorter_lengths(DeckContext& c, const CheckedCard& card) {
  const model::CrackGrowthSettings& growth = *c.model.growth;
  for (std::size_t i = 0; i < c.model.cracks.size() && !growth.lengths.empty(); ++i) {
    const model::CrackDefinition& crack = c.model.cracks[i];
    const bool own = c.own_lengths != nullptr && c.own_lengths->contains(crack.name);
    if (growth.grows(base::CrackId(i)) && !own && crack.a0 &&
        growth.lengths.front() < *crack.a0 * (1.0 - 1e-9)) {
      c.warning(
          card.rows.empty() ? card.span : card.rows.front().span, "W454",
          fmt::format("the first length, {:.6g}, is shorter than A0 = {:.6g} of crack {}: a crack "
                      "only grows",
                      growth.lengths.front(), *crack.a0, crack.name),
          "the lengths of $GROW are solved and A0 is not: take the A0 of the first length");
    }
  }
}

void growing_cracks(DeckContext& c, const std::vector<StepEndState>& factors) {
  const CheckedCard* card = c.find_first_card("GROW");
  if (card == nullptr || !c.model.growth) {
    return;
  }
  if (c.model.cracks.empty()) {
    c.error(card->span, "E452", "$GROW, but the deck has no crack that could grow",
            "$CRACK gives a crack its place and first length");
    return;
  }
  if (c.model.growth->law == model::CrackGrowthLaw::increment) {
    shorter_lengths(c, *card);
    return;
  }
  if (!card->has_key("MATERIAL")) {
    odd_constants(c, *card, c.model.growth->law, c.model.growth->constants);
  }
  exchanged_steps(c, *card, factors);
}

// A deck that gives $GROW constants of its own has hardly meant to leave its laws aside.
void unused_laws(DeckContext& c) {
  const bool none = !c.model.growth || c.model.growth->data.name.empty();
  if (const CheckedCard* card = c.find_first_card("LAW"); card != nullptr && none) {
    c.warning(card->span, "W357", "no $GROW uses a law of the deck: it counts nowhere",
              fmt::format("$GROW MATERIAL={} in place of LAW and its constants",
                          card->word_value("NAME")));
  }
}

} // namespace

void check_growth_laws(DeckContext& context) {
  if (context.diagnostics.has_errors()) {
    return;
  }
  std::size_t i = 0;
  context.for_each_sound_card("LAW", [&](const CheckedCard& card) {
    const model::GrowthLawDefinition& law = context.growth_laws[i++];
    odd_constants(context, card, law.law, law.constants);
  });
}

void check_steps_and_growth(DeckContext& context) {
  check_output_life(context);
  if (context.diagnostics.has_errors()) {
    return;
  }
  const std::vector<StepEndState> factors = factors_of_steps(context);
  unused_cases(context);
  idle_steps(context, factors);
  growing_cracks(context, factors);
  check_growth_laws(context);
  unused_laws(context);
}

} // namespace spricka::deck
