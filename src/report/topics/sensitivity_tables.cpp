// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/sensitivity_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/tornado.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

namespace spricka::report {
namespace {

using results::Sensitivity;
using results::SensitivityParameter;

using Side = std::optional<std::array<double, 2>>;

// 1 %, or one micrometre of a fit, in the unit of the value.
double small_change(const model::Model& model, const Sensitivity& s) {
  return s.cause == SensitivityParameter::fit ? 1e-6 / model.units.metre_per_length
                                              : 0.01 * s.value;
}

std::string unit_of(const model::Model& model, SensitivityParameter cause) {
  switch (cause) {
  case SensitivityParameter::load:
    return {};
  case SensitivityParameter::modulus:
    return " " + model.units.stress_name();
  case SensitivityParameter::fit:
  case SensitivityParameter::length:
  case SensitivityParameter::axis:
    break;
  }
  return " " + model.units.length_name;
}

std::string words_of(const Sensitivity& s) {
  return results::display_word(s.cause) + " " + s.name;
}

// What K1 or K2 changes by with the small change up or down.
std::optional<double> effect(const model::Model& model, const Sensitivity& s, std::size_t mode,
                             bool up) {
  const Side& side = up ? s.above : s.below;
  const double by = small_change(model, s);
  return side ? std::optional((up ? by : -by) * (*side)[mode]) : std::nullopt;
}

double strength(const model::Model& model, const Sensitivity& s) {
  double most = 0.0;
  for (const bool up : {false, true}) {
    most = std::max(most, std::abs(effect(model, s, 0, up).value_or(0.0)));
  }
  return most;
}

std::vector<const Sensitivity*> sorted(const model::Model& model, const results::TipResult& tip) {
  std::vector<const Sensitivity*> order;
  for (const Sensitivity& s : tip.sensitivities.of) {
    order.push_back(&s);
  }
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](const Sensitivity* s) { return strength(model, *s); });
  return order;
}

Side of_point(const std::vector<std::array<double, 3>>& along, std::size_t point) {
  return along.empty() ? Side() : Side({along[point][0], along[point][1]});
}

// The point inside with the largest K1, as a tip of its own; empty: K there is not known to depend
// on anything.
std::optional<results::TipResult> tip_of(const results::FrontResult& front) {
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    if (!front.points[i].at_surface && (!most || front.points[i].K1 > front.points[*most].K1)) {
      most = i;
    }
  }
  if (!most || front.sensitivities.of.empty()) {
    return std::nullopt;
  }
  results::TipResult tip;
  tip.name = fmt::format("{} point {}", front.name, front.points[*most].number);
  tip.a = front.a;
  tip.K1 = front.points[*most].K1;
  tip.K2 = front.points[*most].K2;
  tip.invalid_reason = front.invalid_reason;
  for (const results::FrontSensitivity& s : front.sensitivities.of) {
    tip.sensitivities.of.push_back(
        {s.cause, s.name, s.value, of_point(s.below, *most), of_point(s.above, *most), s.range});
  }
  return tip;
}

std::vector<results::TipResult> tips_of(const results::StepResult& step) {
  std::vector<results::TipResult> tips = step.tips;
  for (const results::FrontResult& front : step.fronts) {
    if (std::optional<results::TipResult> tip = tip_of(front)) {
      tips.push_back(std::move(*tip));
    }
  }
  return tips;
}

// One number where both sides agree, else both.
std::string both(const Sensitivity& s, const std::function<std::optional<double>(bool)>& value,
                 const char* form) {
  const auto text = [&](bool up) {
    const std::optional<double> v = value(up);
    return v ? fmt::format(fmt::runtime(form), *v) : std::string("-");
  };
  return s.slope() ? text(true) : text(false) + " | " + text(true);
}

std::string bound(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : std::string("any");
}

// What is left of a change of K by round-off is none.
std::optional<double> clean(std::optional<double> value, double scale) {
  return value && std::abs(*value) < 1e-9 * scale ? std::optional(0.0) : value;
}

std::vector<std::string> row_of(const model::Model& model, const results::TipResult& tip,
                                const Sensitivity& s) {
  const double K = std::hypot(tip.K1, tip.K2);
  const auto times_value = [&](bool up) {
    const Side& side = up ? s.above : s.below;
    return clean(side ? std::optional(s.value * (*side)[0]) : std::nullopt, K);
  };
  const auto percent = [&](bool up) {
    const std::optional<double> dK = effect(model, s, 0, up);
    const double sign = up ? 100.0 : -100.0; // of the change upwards
    return clean(dK && tip.K1 != 0.0 ? std::optional(sign * *dK / std::abs(tip.K1)) : std::nullopt,
                 K > 0.0 ? 1.0 : 0.0);
  };
  const auto of_mode_2 = [&](bool up) {
    const std::optional<double> dK = effect(model, s, 1, up);
    return clean(dK ? std::optional(up ? *dK : -*dK) : std::nullopt, K);
  };
  return {tip.name,
          words_of(s),
          fmt::format("{:.6g}{}", s.value, unit_of(model, s.cause)),
          s.value == 0.0 ? "" : both(s, times_value, "{:.5g}"),
          s.cause == SensitivityParameter::fit ? "1 um" : "1 %",
          both(s, percent, "{:+.4f}"),
          both(s, of_mode_2, "{:+.4g}"),
          s.range ? bound((*s.range)[0]) : "",
          s.range ? bound((*s.range)[1]) : ""};
}

std::string cell(const Side& side, std::size_t mode) {
  return side ? fmt::format("{}", (*side)[mode]) : std::string();
}

TornadoChart tornado_of(const model::Model& model, const results::TipResult& tip,
                        std::string title) {
  TornadoChart out;
  out.title = std::move(title);
  for (const Sensitivity* s : sorted(model, tip)) {
    const double up = clean(effect(model, *s, 0, true), tip.K1).value_or(0.0);
    const double down = clean(effect(model, *s, 0, false), tip.K1).value_or(0.0);
    if (up == 0.0 && down == 0.0) {
      continue;
    }
    out.bars.push_back(
        {fmt::format("{} {}", words_of(*s), s->cause == SensitivityParameter::fit ? "1 µm" : "1 %"),
         100.0 * up / std::abs(tip.K1), 100.0 * down / std::abs(tip.K1),
         static_cast<std::size_t>(s->cause)});
  }
  return out;
}

} // namespace

namespace {

// One row for each point of a front and each cause.
void write_fronts(const std::filesystem::path& file, const model::Model& model,
                  const results::RunResult& run) {
  const base::UnitSystem& units = model.units;
  std::string text = fmt::format(
      "# units: a, s and values of FIT and A [{0}], of E [{1}], of LOAD [1]; dK1 dK2 dK3 [{2}] "
      "over "
      "the unit of the value\n"
      "increment,step,crack,a,point,at_surface,s,cause,name,value,dK1,dK2,dK3,from,to\n",
      units.length_name, units.stress_name(), units.stress_intensity_name());
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        for (const results::FrontSensitivity& s : front.sensitivities.of) {
          for (std::size_t i = 0; i < s.above.size(); ++i) {
            const results::FrontPointResult& place = front.points[i];
            fmt::format_to(out, "{},{},{},{},{},{:d},{},{},{},{},{},{},{},{},{}\n",
                           increment.number, step.step, front.name, front.a, place.number,
                           place.at_surface, place.s, results::display_word(s.cause), s.name,
                           s.value, s.above[i][0], s.above[i][1], s.above[i][2], cell(s.range, 0),
                           cell(s.range, 1));
          }
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace

void write_sensitivity_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run) {
  if (model.cracks.empty()) {
    return;
  }
  if (model.mesh.dim == 3) {
    write_fronts(file, model, run);
    return;
  }
  const base::UnitSystem& units = model.units;
  std::string text = fmt::format(
      "# units: a and values of FIT and A [{0}], of E [{1}], of LOAD [1]; dK1 dK2 [{2}] over the "
      "unit of the value\n"
      "increment,step,crack,a,cause,name,value,dK1_below,dK1_above,dK2_below,dK2_above,from,to\n",
      units.length_name, units.stress_name(), units.stress_intensity_name());
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        for (const Sensitivity& s : tip.sensitivities.of) {
          text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", increment.number,
                              step.step, tip.name, tip.a, results::display_word(s.cause), s.name,
                              s.value, cell(s.below, 0), cell(s.above, 0), cell(s.below, 1),
                              cell(s.above, 1), cell(s.range, 0), cell(s.range, 1));
        }
      }
    }
  }
  write_file(file, text);
}

ReportTable sensitivity_table(const model::Model& model, const results::Increment& increment) {
  const std::string step = leading_step(model);
  const std::string unit = model.units.stress_intensity_name();
  ReportTable table{
      fmt::format("Sensitivity of K1 and K2 at the end of step {}, contact state held fixed", step),
      {{"tip", "", true},
       {"by", "", true},
       {"value", "", false},
       {"value dK1/dvalue", unit, false},
       {"for", "", false},
       {"K1 changes", "%", false},
       {"K2 changes", unit, false},
       {"kept from", "", false},
       {"to", "", false}},
      {}};
  const results::StepResult* found = results::find_step(increment, step);
  if (found == nullptr) {
    return table;
  }
  for (const results::TipResult& tip : tips_of(*found)) {
    for (const Sensitivity* s : sorted(model, tip)) {
      table.rows.push_back(row_of(model, tip, *s));
    }
  }
  return table;
}

std::vector<std::string> sensitivity_notes(const model::Model& model,
                                           const results::Increment& increment) {
  std::vector<std::string> notes;
  const results::StepResult* found = results::find_step(increment, leading_step(model));
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& note : more) {
      if (std::ranges::find(notes, note) == notes.end()) {
        notes.push_back(note);
      }
    }
  };
  if (found != nullptr) {
    for (const results::TipResult& tip : found->tips) {
      add(tip.sensitivities.notes);
    }
    for (const results::FrontResult& front : found->fronts) {
      add(front.sensitivities.notes);
    }
  }
  return notes;
}

std::vector<Figure> sensitivity_figures(const model::Model& model, const results::RunResult& run) {
  const std::string step = leading_step(model);
  Figure figure;
  for (const results::Increment* increment : chosen_increments(run, 3)) {
    const results::StepResult* found = results::find_step(*increment, step);
    for (const results::TipResult& tip :
         found != nullptr ? tips_of(*found) : std::vector<results::TipResult>()) {
      if (tip.invalid_reason.empty() && tip.K1 > 0.0 && !tip.sensitivities.of.empty()) {
        figure.drawings.push_back(draw_svg(tornado_of(
            model, tip,
            fmt::format("{}, a = {:.4g} {}", tip.name, tip.a, model.units.length_name))));
      }
    }
  }
  if (figure.drawings.empty()) {
    return {};
  }
  figure.caption =
      fmt::format("Change of K₁ at the end of step {}, in percent, for 1 % more of a load, a "
                  "modulus or a crack length and for 1 µm more of a normal interference (full "
                  "bars), and for as much less (pale bars). The contact state is held fixed.",
                  step);
  return {figure};
}

} // namespace spricka::report
