// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/file.hpp"
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <string_view>

// fmt writes the shortest decimal number that reads back to the same bits, whatever the locale.

namespace spricka::report {

namespace {

std::string_view state_name(results::ContactState state) {
  switch (state) {
  case results::ContactState::open:
    return "open";
  case results::ContactState::closed:
    return "closed";
  case results::ContactState::stick:
    return "stick";
  case results::ContactState::slip:
    break;
  }
  return "slip";
}

} // namespace

void write_k_csv(const std::filesystem::path& file, const model::Model& model,
                 const results::Run& run) {
  const base::UnitSystem& units = model.units;
  const bool opening = std::any_of(model.vces.begin(), model.vces.end(),
                                   [](const model::Vce& vce) { return vce.opening; });
  std::string text = fmt::format(
      "# units: a [{0}], K1 K2 and what begins with them [{1}], G [{2}/{0}], T [{3}], increment "
      "and "
      "spread [1]\n"
      "increment,step,crack,a,K1,K2,G,spread,T,K1_bar,K1_best,K1_eta,K1_sum,K1_flip,K2_bar,K2_best,"
      "K2_eta,K2_sum,K2_flip{4}\n",
      units.length_name, units.stress_intensity_name(), units.force_name, units.stress_name(),
      opening ? ",K1_opening,K2_opening" : "");
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        fmt::format_to(out, "{},{},{},{},", increment.number, step.step, tip.name, tip.a);
        if (tip.two_materials) {
          fmt::format_to(out, ",,{},,", tip.G);
        } else {
          fmt::format_to(out, "{},{},{},{},{}", tip.K1, tip.K2, tip.G, tip.spread, tip.T);
        }
        for (const results::KBar& bar : tip.bar) { // empty cells: there is no bar
          text += tip.no_bar.empty() ? fmt::format(",{},{},{},{},{}", bar.size(), bar.best, bar.eta,
                                                   bar.sum, bar.flip)
                                     : ",,,,,";
        }
        if (opening && tip.K_opening) {
          fmt::format_to(out, ",{},{}", (*tip.K_opening)[0], (*tip.K_opening)[1]);
        } else if (opening) {
          text += ",,";
        }
        text += '\n';
      }
    }
  }
  write_file(file, text);
}

void write_pressure_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::Run& run) {
  const bool rubs =
      std::any_of(model.contacts.begin(), model.contacts.end(),
                  [](const model::Contact& c) { return c.mu > 0.0; }) ||
      std::any_of(model.cracks.begin(), model.cracks.end(),
                  [](const model::Crack& c) { return c.faces_in_contact && c.mu > 0.0; });
  std::string text =
      rubs ? fmt::format("# units: x y slip slip_path [{0}], theta [deg], p_lumped p_consistent "
                         "q_lumped q_consistent [{1}], increment [1]\n"
                         "increment,step,contact,x,y,theta,p_lumped,p_consistent,q_lumped,"
                         "q_consistent,slip,slip_path,state\n",
                         model.units.length_name, model.units.stress_name())
           : fmt::format("# units: x y [{}], theta [deg], p_lumped p_consistent [{}], increment "
                         "[1]\nincrement,step,contact,x,y,theta,p_lumped,p_consistent\n",
                         model.units.length_name, model.units.stress_name());
  auto out = std::back_inserter(text);
  constexpr double degree = 180.0 / std::numbers::pi;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::ContactResult& contact : step.contacts) {
        if (!contact.mounted) {
          continue; // absent, not open: it has no pressure
        }
        for (const results::ContactPoint& point : contact.points) {
          fmt::format_to(out, "{},{},{},{},{},{},{},{}", increment.number, step.step, contact.name,
                         point.x[0], point.x[1], point.theta * degree, point.p_lumped,
                         point.p_consistent);
          if (rubs) {
            fmt::format_to(out, ",{},{},{},{},{}", point.q_lumped, point.q_consistent, point.slip,
                           point.slip_path, state_name(point.state));
          }
          text += '\n';
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
