// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_law_summary.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>

namespace spricka::report {

namespace {

std::string stated(const std::string& text) {
  return text.empty() ? "not stated" : text;
}

// "3.2 to 40", "from 3.2", "not stated".
std::string range_words(const std::optional<double>& low, const std::optional<double>& high) {
  return low && high ? fmt::format("{:.4g} to {:.4g}", *low, *high)
         : low       ? fmt::format("from {:.4g}", *low)
         : high      ? fmt::format("to {:.4g}", *high)
                     : "not stated";
}

} // namespace

std::string growth_law_summary(const model::Model& model, const results::GrowthResult& growth) {
  const model::CrackGrowthSettings& settings = *model.growth;
  const model::GrowthLawConstants& law = settings.constants;
  const model::GrowthLawData& data = settings.data;
  const base::OutputUnit K = model.units.output_stress_intensity();
  const base::OutputUnit length = model.units.output_length();
  std::string out =
      fmt::format("Law: {}", model::growth_law_words.at(static_cast<std::size_t>(settings.law)));
  out += data.name.empty()
             ? std::string()
             : fmt::format(" with the constants of {}, found in {}", data.name, data.place);
  if (law.k_c) {
    out += "; KC = " + K.text(*law.k_c, 5);
    out +=
        data.thickness ? " for a thickness of " + length.text(*data.thickness, 4) : std::string();
  }
  out += law.threshold_over_ratio
             ? fmt::format("; threshold over R from {} = {}",
                           law.threshold_over_ratio->at_zero_ratio ? "DK0" : "DK1",
                           K.text(law.threshold_over_ratio->delta_k, 4))
         : law.threshold > 0.0 ? fmt::format("; threshold {} for all R", K.text(law.threshold, 4))
                               : "; no threshold";
  out += ".\n";
  if (!data.name.empty()) {
    out += fmt::format("Its source: {}; form {}, orientation {}, environment {}. Its data: delta K "
                       "{}{}, R {}. Scatter (standard deviation of ln C): {}.\n",
                       stated(data.source), stated(data.form), stated(data.orientation),
                       stated(data.environment),
                       range_words(in_output_unit(data.lowest_delta_k, K),
                                   in_output_unit(data.highest_delta_k, K)),
                       data.lowest_delta_k || data.highest_delta_k ? " " + K.name : "",
                       range_words(data.lowest_ratio, data.highest_ratio),
                       data.scatter ? fmt::format("{:.3g}", *data.scatter) : "not stated");
  }
  const model::LawUse& use = growth.law_use;
  if (use.lowest_delta_k <= use.highest_delta_k) {
    out += fmt::format("Cycles that grow have delta K from {:.4g} to {:.4g} {} and R from {:.3g} "
                       "to {:.3g}.\n",
                       K.from_deck(use.lowest_delta_k), K.from_deck(use.highest_delta_k), K.name,
                       use.lowest_ratio, use.highest_ratio);
  }
  return out;
}

} // namespace spricka::report
