// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/growth_laws.hpp"

#include "base/shipped_files.hpp"
#include "deck/law_constants.hpp"
#include "deck/load.hpp"
#include "grammar/catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view law_file_name = "materials.deck";

/// Where a law is looked for, and how the listing calls the place.
struct LawFile {
  fs::path path;
  std::string place;
};

std::vector<LawFile> law_files(const DeckContext& c, const CheckedCard& card) {
  const fs::path deck = c.sources.file_name(card.span.file);
  std::vector<LawFile> files{
      {deck.parent_path() / law_file_name, fmt::format("{} beside the deck", law_file_name)}};
  if (const fs::path shipped = find_shipped_growth_laws(); !shipped.empty()) {
    files.push_back({shipped, "the materials that ship"});
  }
  std::erase_if(files, [&](const LawFile& file) {
    std::error_code unknown;
    return !fs::exists(file.path, unknown) || fs::equivalent(file.path, deck, unknown);
  });
  return files;
}

void set_own_toughness(model::GrowthLawDefinition& law) {
  if (law.toughness && law.data.thickness) {
    law.constants.k_c = toughness_of_thickness(*law.toughness, *law.data.thickness);
  }
}

// Constants that count in KUNIT and AUNIT stay; these units, and all else, change.
void convert_units(model::GrowthLawDefinition& law, const base::UnitSystem& from,
                   const base::UnitSystem& to) {
  const double length = from.metre_per_length / to.metre_per_length;
  const double stress = from.newton_per_force / to.newton_per_force / (length * length);
  const double K = stress * std::sqrt(length);
  const auto scale = [](std::optional<double>& value, double factor) {
    value = value ? std::optional(*value * factor) : std::nullopt;
  };
  model::GrowthLawConstants& constants = law.constants;
  constants.k_unit *= K;
  constants.a_unit *= length;
  constants.threshold *= K;
  if (constants.threshold_over_ratio) {
    constants.threshold_over_ratio->delta_k *= K;
    constants.threshold_over_ratio->intrinsic_length *= length;
  }
  scale(constants.k_part_through, K);
  scale(constants.k_c, K);
  if (law.toughness) {
    law.toughness->plane_strain *= K;
    law.toughness->yield *= stress;
  }
  scale(law.data.thickness, length);
  scale(law.data.lowest_delta_k, K);
  scale(law.data.highest_delta_k, K);
}

// A file of laws describes no model.
void refuse_other_cards(DeckContext& c) {
  constexpr std::array<std::string_view, 6> known{"DECK", "PARAMETER", "INCLUDE",
                                                  "LAW",  "REQUIRE",   "END"};
  for (const CheckedCard& card : c.cards) {
    if (std::ranges::find(known, card.spec->name) == known.end()) {
      c.error(card.span, "E329",
              fmt::format("${} in a file of growth laws, which holds $LAW", card.spec->name));
      return;
    }
  }
}

// What MATERIAL leaves to $LAW.
bool refuse_constants_beside_material(DeckContext& c, const CheckedCard& card) {
  std::vector<std::string_view> given;
  base::SourceSpan first;
  for (const CheckedValue& value : card.values) {
    const std::string_view name = value.key->name;
    if (value.given && name != "THICK" && (name == "LAW" || grammar::is_law_constant(name))) {
      first = given.empty() ? value.span : first;
      given.push_back(name);
    }
  }
  const bool rows = !card.rows.empty();
  if (given.empty() && !rows) {
    return false;
  }
  c.error(given.empty() ? card.rows.front().span : first, given.empty() ? "E115" : "E110",
          given.empty() ? "with MATERIAL $GROW has no data lines: the rows of a table stand on $LAW"
                        : fmt::format("MATERIAL={} says the law, and so does {}",
                                      card.name_reference("MATERIAL").name, fmt::join(given, " ")),
          "a $LAW NAME=.. of its own with these constants, or $GROW without MATERIAL; THICK goes "
          "with both");
  return true;
}

std::optional<model::GrowthLawDefinition> find_law(DeckContext& c, const CheckedCard& card) {
  const NameReference wanted = card.name_reference("MATERIAL");
  const std::vector<EntityKind> kinds{EntityKind::law};
  if (const NameDefinition* found = c.names.find(kinds, wanted.name, {})) {
    return found->poisoned || found->index >= c.growth_laws.size()
               ? std::nullopt
               : std::optional(c.growth_laws[found->index]);
  }
  if (c.names.is_poisoned(kinds, wanted.name, {})) {
    return std::nullopt;
  }
  std::vector<std::string> known;
  for (const model::GrowthLawDefinition& law : c.growth_laws) {
    known.push_back(law.data.name);
  }
  for (const LawFile& file : law_files(c, card)) {
    const std::size_t errors = c.diagnostics.error_count();
    std::vector<model::GrowthLawDefinition> laws;
    try {
      laws = read_growth_law_file(file.path, c.model.units, c.sources, c.diagnostics);
    } catch (const std::system_error& trouble) {
      c.error(wanted.span, "E308", trouble.what());
    }
    for (model::GrowthLawDefinition& law : laws) {
      if (law.data.name == wanted.name) {
        law.data.place = file.place;
        return std::move(law);
      }
      known.push_back(law.data.name);
    }
    if (c.diagnostics.error_count() > errors) {
      return std::nullopt; // the law may be what could not be read
    }
  }
  const std::string other = c.names.describe_other_kind(kinds, wanted.name);
  c.error(wanted.span, "E301",
          fmt::format("there is no growth law '{}': neither in the deck, nor in {} beside it, nor "
                      "among those that ship",
                      wanted.name, law_file_name),
          other.empty() ? base::make_spelling_hint(wanted.name, known)
                        : other + "; spricka help materials lists the laws that ship");
  return std::nullopt;
}

// K_c of the thickness that $GROW gives, or the law has.
void set_toughness(DeckContext& c, const CheckedCard& card, model::GrowthLawDefinition& law) {
  const bool thick = card.has_key("THICK");
  if (!law.toughness && thick) {
    c.error(card.value_span("THICK"), "E110",
            fmt::format("THICK means nothing with {}, whose KC is one number", law.data.name),
            "only a law with K1C has a toughness for each thickness");
    return;
  }
  law.data.thickness = thick ? card.optional_number("THICK") : law.data.thickness;
  set_own_toughness(law);
  if (law.toughness && !law.data.thickness) {
    c.error(card.span, "E106",
            fmt::format("$GROW MATERIAL={} needs THICK: the toughness of {} depends on the "
                        "thickness",
                        law.data.name, law.data.name),
            "THICK=2.54: the thickness of the part");
  }
}

} // namespace

void build_growth_laws(DeckContext& context) {
  context.for_each_sound_card("LAW", [&](const CheckedCard& card) {
    model::GrowthLawDefinition law = read_growth_law(context, card, "TYPE");
    law.data.place = "the deck";
    set_own_toughness(law);
    context.growth_laws.push_back(std::move(law));
  });
}

model::GrowthLawDefinition growth_law_of_card(DeckContext& context, const CheckedCard& card) {
  if (!card.has_key("MATERIAL")) {
    if (!card.has_key("LAW")) {
      context.error(
          card.span, "E106", "$GROW needs LAW, or MATERIAL",
          "LAW=PARIS with its constants, or MATERIAL, the name of a $LAW or of a law that "
          "ships: spricka help materials");
      return {};
    }
    model::GrowthLawDefinition law = read_growth_law(context, card, "LAW");
    set_own_toughness(law);
    return law;
  }
  if (refuse_constants_beside_material(context, card)) {
    return {};
  }
  std::optional<model::GrowthLawDefinition> law = find_law(context, card);
  if (!law) {
    return {};
  }
  set_toughness(context, card, *law);
  return std::move(*law);
}

std::filesystem::path find_shipped_growth_laws() {
  return base::find_shipped_file(fs::path("share/spricka/materials") / law_file_name);
}

std::vector<model::GrowthLawDefinition> read_growth_law_file(const fs::path& file,
                                                             const base::UnitSystem& units,
                                                             base::SourceTexts& sources,
                                                             base::Diagnostics& diagnostics) {
  const DeckFileCards loaded = read_deck_and_includes(file, sources, diagnostics);
  DeckContext own{sources, diagnostics};
  if (loaded.incomplete) {
    own.names.poison_everything();
    own.scope.incomplete = true;
  }
  check_cards_and_define_names(own, loaded.cards, {});
  refuse_other_cards(own);
  if (check_requirements(own)) {
    build_growth_laws(own);
    check_growth_laws(own);
  }
  for (model::GrowthLawDefinition& law : own.growth_laws) {
    convert_units(law, own.model.units, units);
  }
  return std::move(own.growth_laws);
}

} // namespace spricka::deck
