// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/commands/materials_help.hpp"

#include "archive/safe_file.hpp"
#include "deck/growth_laws.hpp"
#include "grammar/wrap.hpp"

#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

std::string stated_or_not(const std::string& what, const std::string& text) {
  return fmt::format("{} {}", what, text.empty() ? "not stated" : text);
}

std::string limits(const std::optional<double>& low, const std::optional<double>& high,
                   double unit) {
  return low && high ? fmt::format("{:.4g} to {:.4g}", *low / unit, *high / unit)
         : low       ? fmt::format("from {:.4g}", *low / unit)
         : high      ? fmt::format("to {:.4g}", *high / unit)
                     : std::string();
}

// In MPa m^0.5 and mm, as figures are compared that come from anywhere.
std::string describe_growth_law(const model::GrowthLawDefinition& law,
                                const base::UnitSystem& units) {
  const double K = base::factor_to_deck_units(*base::parse_unit("MPa*m^0.5"), units);
  const model::GrowthLawData& data = law.data;
  std::string text = fmt::format("{}; {}; {}; ", stated_or_not("form", data.form),
                                 stated_or_not("orientation", data.orientation),
                                 stated_or_not("environment", data.environment));
  text += law.constants.k_c ? fmt::format("KC {:.4g} MPa m^0.5", *law.constants.k_c / K) : "no KC";
  text += law.constants.k_c && data.thickness ? fmt::format(" for {:.4g} mm", *data.thickness) : "";
  text += law.toughness ? " (THICK gives that of another thickness)" : "";
  const std::string range = limits(data.lowest_delta_k, data.highest_delta_k, K);
  text += fmt::format("; data: {}, {}; source: {}",
                      range.empty() ? "delta K not stated" : "delta K " + range + " MPa m^0.5",
                      stated_or_not("R", limits(data.lowest_ratio, data.highest_ratio, 1.0)),
                      data.source.empty() ? "not stated" : data.source);
  return text;
}

} // namespace

std::string list_shipped_growth_laws(std::size_t width) {
  const std::filesystem::path file = deck::find_shipped_growth_laws();
  if (file.empty()) {
    throw archive::FileFailure("E530", "the growth laws that ship with the program are not there");
  }
  const base::UnitSystem units; // mm, N
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::string text = "Growth laws that ship, for $GROW MATERIAL=NAME THICK=..; spricka help law:\n";
  for (const model::GrowthLawDefinition& law :
       deck::read_growth_law_file(file, units, sources, diagnostics)) {
    text += fmt::format("\n{}  {}\n", law.data.name,
                        model::growth_law_words.at(static_cast<std::size_t>(law.law)));
    text += grammar::wrap_paragraph(describe_growth_law(law, units), 2, width);
  }
  return text + fmt::format("\n{}\n", file.string());
}

} // namespace spricka::program
