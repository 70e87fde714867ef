// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/step_actions.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

/// Numbers that the language allows and that hardly any material, law, fit or check has.
namespace spricka::deck {

namespace {

// Of a key of the card that made something; of that thing where there is no such card or key.
base::SourceSpan key_span(const DeckContext& c, std::string_view card_name, std::string_view name,
                          std::string_view key, base::SourceSpan otherwise) {
  const CheckedCard* card = c.find_sound_card_named(card_name, name);
  return card != nullptr && card->has_key(key) ? card->find(key)->span : otherwise;
}

// Metals have 1e-5 to 3e-5 per degree, plastics and rubber 2e-4.
void odd_materials(DeckContext& c) {
  constexpr double most_expansion = 1e-3;
  for (const model::ElasticMaterial& material : c.model.materials) {
    if (std::abs(material.alpha) > most_expansion) {
      c.warning(
          key_span(c, "MATERIAL", material.name, "ALPHA", material.span), "W359",
          fmt::format("material {}: ALPHA = {:.4g} per degree is more than anything solid expands",
                      material.name, material.alpha),
          "steel has 1.2e-5, aluminium 2.3e-5; tables often leave out a factor of 1e-6");
    }
    if (material.nu < 0.0) {
      c.warning(key_span(c, "MATERIAL", material.name, "NU", material.span), "W362",
                fmt::format("material {}: with NU = {:.4g} it grows wider when it is pulled",
                            material.name, material.nu),
                "metals have 0.25 to 0.35");
    }
  }
}

double largest_modulus(const model::Model& model) {
  double largest = 0.0;
  for (const model::ElasticMaterial& material : model.materials) {
    largest = std::max(largest, material.E);
  }
  return largest;
}

// No solid bears a tenth of its modulus.
void odd_flow_stress(DeckContext& c, const CheckedCard& card) {
  constexpr double most = 0.1;
  const double stiffest = largest_modulus(c.model);
  const std::optional<double>& flow = c.model.growth->flow_stress;
  if (flow && *flow > most * stiffest) {
    c.warning(
        card.value_span("SFLOW"), "W360",
        fmt::format("SFLOW = {:.4g} {} is {:.3g} times the largest modulus: it would never end a "
                    "growth",
                    *flow, c.model.units.stress_name(), *flow / stiffest),
        "flow stresses are some thousandths of the modulus; write SFLOW=350[MPa]");
  }
}

// (K/E)^2 is the opening of the crack's tip times the flow stress over E: the toughest metals open
// by some millimetres before they tear, at some thousandths of E. Numbers without dimensions have
// moduli that are powers of ten.
void odd_toughness(DeckContext& c, const CheckedCard& card) {
  constexpr double most = 1e-5; // [m] steel 650 MPa m^0.5, aluminium 220
  const std::optional<double>& k_c = c.model.growth->constants.k_c;
  const double stiffest = largest_modulus(c.model);
  if (!k_c || std::pow(10.0, std::round(std::log10(stiffest))) == stiffest) {
    return;
  }
  const double bound = stiffest * std::sqrt(most / c.model.units.metre_per_length);
  if (*k_c > bound) {
    c.warning(
        card.value_span(card.has_key("K1C") ? "K1C" : "KC"), "W371",
        fmt::format("KC = {:.4g} {}: no material of such a modulus is tougher than {:.2g}, so that "
                    "it would never end a growth",
                    *k_c, c.model.units.stress_intensity_name(), bound),
        "KC counts in KUNIT, as C does, where it has no unit of its own; write KC=35[MPa*m^0.5]");
  }
}

// A measured table scatters; it does not turn round.
void falling_table(DeckContext& c, const CheckedCard& card) {
  const model::GrowthLawConstants& law = c.model.growth->constants;
  for (std::size_t i = 1; i < law.growth.size(); ++i) {
    if (law.growth[i] < law.growth[i - 1]) {
      c.warning(
          card.rows.size() == law.growth.size() ? card.rows[i].span : card.span, "W356",
          fmt::format("da/dN falls from {:.4g} to {:.4g} where delta_K grows from {:.4g} to {:.4g}",
                      law.growth[i - 1], law.growth[i], law.delta_k[i - 1], law.delta_k[i]),
          "a crack that is driven more grows faster; is an exponent of ten right?");
      return;
    }
  }
}

// Within REL 1 of a value lies 0 as well.
void wide_checks(DeckContext& c) {
  for (const model::ResultCheck& check : c.model.checks) {
    if (check.relative && check.tolerance >= 1.0) {
      c.warning(check.span, "W353",
                fmt::format("REL {:.4g} accepts anything from {:.4g} to {:.4g}, with 0 among it",
                            check.tolerance, check.value - check.tolerance * std::abs(check.value),
                            check.value + check.tolerance * std::abs(check.value)),
                fmt::format("REL is a part of the value: {:.4g} per cent is REL {:.4g}",
                            check.tolerance, 0.01 * check.tolerance));
    }
  }
}

void odd_ratios(DeckContext& c) {
  constexpr double least = -5.0;
  for (const model::GrowthTestReadings& test : c.model.tests) {
    if (test.ratio && *test.ratio < least) {
      c.warning(key_span(c, "TEST", test.name, "RATIO", test.span), "W363",
                fmt::format("RATIO = {:.4g}: the test would press {:.4g} times as hard as it pulls",
                            *test.ratio, -*test.ratio),
                "RATIO is K_min/K_max of the test, mostly 0 to 0.7");
    }
  }
}

// FIT has a part of the fit that the contact declares; the fit itself there makes almost none.
void odd_fit(DeckContext& c, const model::Step& step, const model::ApplyFit& fit) {
  const model::Contact& contact = c.model.contacts[fit.contact.index()];
  const double gap = std::abs(contact.gap.value_or(0.0));
  const auto is = [&](double value) {
    return std::abs(std::abs(fit.factor) - value) <= 1e-9 * value;
  };
  const double twentieths = 20.0 * fit.factor; // 0.1, 0.25, 0.5 may well be parts
  const bool round = fit.factor > 0.09 && std::abs(twentieths - std::round(twentieths)) < 1e-9;
  if (gap > 0.0 && !round && (is(gap) || is(2.0 * gap))) {
    c.warning(
        step.span, "W364",
        fmt::format("step {}: FIT {} {:.6g} is the fit that the contact declares, not a part of "
                    "it: {:.3g} {} in all",
                    step.name, contact.name, fit.factor, gap * std::abs(fit.factor),
                    c.model.units.length_name),
        fmt::format("FIT {} 1 applies the whole of it", contact.name));
  } else if (fit.factor < 0.0) {
    c.warning(
        step.span, "W364",
        fmt::format("step {}: FIT {} {:.6g} makes a gap of an interference, and an interference "
                    "of a gap",
                    step.name, contact.name, fit.factor),
        "FIT takes a part of the declared fit, 0 to 1; the sign belongs to the $CONTACT");
  }
}

// A contact that some step mounts is absent before that, whatever earlier steps say of its fit.
void fit_of_absent(DeckContext& c) {
  std::vector<const model::Step*> early(c.model.contacts.size(), nullptr);
  std::vector<bool> mounted(c.model.contacts.size(), false);
  for (const model::Step& step : c.model.steps) {
    for_each_action<model::MountContact>(
        step, [&](const model::MountContact& on) { mounted[on.contact.index()] = true; });
    for_each_action<model::ApplyFit>(step, [&](const model::ApplyFit& fit) {
      const std::size_t i = fit.contact.index();
      if (fit.factor != 0.0 && !mounted[i] && early[i] == nullptr) {
        early[i] = &step;
      }
    });
    for (std::size_t i = 0; i < mounted.size(); ++i) {
      if (mounted[i] && early[i] != nullptr) {
        c.warning(
            early[i]->span, "W367",
            fmt::format("step {}: contact {} and its fit are absent until step {} mounts it",
                        early[i]->name, c.model.contacts[i].name, step.name),
            "write MOUNT into the step that presses it in, or FIT into the step that mounts it");
        early[i] = nullptr;
      }
    }
  }
}

void odd_steps(DeckContext& c) {
  fit_of_absent(c);
  std::vector<bool> in = contacts_mounted_at_start(c.model);
  for (const model::Step& step : c.model.steps) {
    for (const model::StepAction& action : step.actions) {
      const auto* on = std::get_if<model::MountContact>(&action);
      const auto* off = std::get_if<model::DismountContact>(&action);
      if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        odd_fit(c, step, *fit);
      } else if (on != nullptr || off != nullptr) {
        const std::size_t i = on != nullptr ? on->contact.index() : off->contact.index();
        if (in[i] == (on != nullptr)) {
          c.warning(
              step.span, "W365",
              fmt::format("step {}: contact {} is {} already", step.name, c.model.contacts[i].name,
                          in[i] ? "mounted" : "absent"),
              in[i] ? "DISMOUNT stands between two MOUNT; mounted anew, its fit would count from "
                      "the bodies as they are then"
                    : "what a step mounts is absent before that step");
        }
        in[i] = on != nullptr;
      }
    }
  }
}

} // namespace

void check_implausible_values(DeckContext& context) {
  if (context.diagnostics.has_errors()) {
    return;
  }
  odd_materials(context);
  const CheckedCard* card = context.find_first_card("GROW");
  if (card != nullptr && context.model.growth) {
    odd_flow_stress(context, *card);
    odd_toughness(context, *card);
    falling_table(context, *card);
  }
  wide_checks(context);
  odd_ratios(context);
  odd_steps(context);
}

} // namespace spricka::deck
