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
#include <optional>
#include <utility>

namespace spricka::report {
namespace {

using results::Sensitivity;
using results::SensitivityParameter;

/// A point of a front that tables and pictures show.
struct SensitivePoint {
  const results::FrontResult& front;
  std::size_t index = 0;

  [[nodiscard]] const results::FrontPointResult& result() const { return front.points[index]; }
  [[nodiscard]] std::string name() const {
    return front.is_tip() ? front.name : fmt::format("{} point {}", front.name, result().number);
  }
  // By the value, above it or below; empty: nothing holds a body there.
  [[nodiscard]] std::optional<double> derivative(const Sensitivity& s, std::size_t mode,
                                                 bool above) const {
    const std::vector<std::array<double, 3>>& side = above ? s.above : s.below;
    return side.empty() ? std::nullopt : std::optional(side[index][mode]);
  }
};

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
std::optional<double> effect(const model::Model& model, const SensitivePoint& point,
                             const Sensitivity& s, std::size_t mode, bool up) {
  const std::optional<double> slope = point.derivative(s, mode, up);
  const double by = small_change(model, s);
  return slope ? std::optional((up ? by : -by) * *slope) : std::nullopt;
}

double strength(const model::Model& model, const SensitivePoint& point, const Sensitivity& s) {
  double most = 0.0;
  for (const bool up : {false, true}) {
    most = std::max(most, std::abs(effect(model, point, s, 0, up).value_or(0.0)));
  }
  return most;
}

std::vector<const Sensitivity*> sorted(const model::Model& model, const SensitivePoint& point) {
  std::vector<const Sensitivity*> order;
  for (const Sensitivity& s : point.front.sensitivities.of) {
    order.push_back(&s);
  }
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](const Sensitivity* s) { return strength(model, point, *s); });
  return order;
}

// Of each front the point inside with the largest K1; none where K is not known to depend on
// anything.
std::vector<SensitivePoint> leading_points(const results::StepResult& step) {
  std::vector<SensitivePoint> leading;
  for (const results::FrontResult& front : step.fronts) {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < front.points.size(); ++i) {
      if (!front.points[i].at_surface && (!most || front.points[i].K1 > front.points[*most].K1)) {
        most = i;
      }
    }
    if (most && !front.sensitivities.of.empty()) {
      leading.push_back({front, *most});
    }
  }
  return leading;
}

// One number where both sides agree, else both.
std::string both(const SensitivePoint& point, const Sensitivity& s,
                 const std::function<std::optional<double>(bool)>& value, const char* form) {
  const auto text = [&](bool up) {
    const std::optional<double> v = value(up);
    return v ? fmt::format(fmt::runtime(form), *v) : std::string("-");
  };
  bool same = !s.below.empty() && !s.above.empty();
  for (const std::size_t mode : {0U, 1U}) {
    same = same && point.derivative(s, mode, false) == point.derivative(s, mode, true);
  }
  return same ? text(true) : text(false) + " | " + text(true);
}

std::string bound(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : std::string("any");
}

// What is left of a change of K by round-off is none.
std::optional<double> clean(std::optional<double> value, double scale) {
  return value && std::abs(*value) < 1e-9 * scale ? std::optional(0.0) : value;
}

std::vector<std::string> row_of(const model::Model& model, const SensitivePoint& point,
                                const Sensitivity& s) {
  const double K1 = point.result().K1;
  const double K = std::hypot(K1, point.result().K2);
  const auto times_value = [&](bool up) {
    const std::optional<double> slope = point.derivative(s, 0, up);
    return clean(slope ? std::optional(s.value * *slope) : std::nullopt, K);
  };
  const auto percent = [&](bool up) {
    const std::optional<double> dK = effect(model, point, s, 0, up);
    const double sign = up ? 100.0 : -100.0; // of the change upwards
    return clean(dK && K1 != 0.0 ? std::optional(sign * *dK / std::abs(K1)) : std::nullopt,
                 K > 0.0 ? 1.0 : 0.0);
  };
  const auto of_mode_2 = [&](bool up) {
    const std::optional<double> dK = effect(model, point, s, 1, up);
    return clean(dK ? std::optional(up ? *dK : -*dK) : std::nullopt, K);
  };
  return {point.name(),
          words_of(s),
          fmt::format("{:.6g}{}", s.value, unit_of(model, s.cause)),
          s.value == 0.0 ? "" : both(point, s, times_value, "{:.5g}"),
          s.cause == SensitivityParameter::fit ? "1 um" : "1 %",
          both(point, s, percent, "{:+.4f}"),
          both(point, s, of_mode_2, "{:+.4g}"),
          s.range ? bound((*s.range)[0]) : "",
          s.range ? bound((*s.range)[1]) : ""};
}

TornadoChart tornado_of(const model::Model& model, const SensitivePoint& point, std::string title) {
  const double K1 = point.result().K1;
  TornadoChart out;
  out.title = std::move(title);
  for (const Sensitivity* s : sorted(model, point)) {
    const double up = clean(effect(model, point, *s, 0, true), K1).value_or(0.0);
    const double down = clean(effect(model, point, *s, 0, false), K1).value_or(0.0);
    if (up == 0.0 && down == 0.0) {
      continue;
    }
    out.bars.push_back(
        {fmt::format("{} {}", words_of(*s), s->cause == SensitivityParameter::fit ? "1 µm" : "1 %"),
         100.0 * up / std::abs(K1), 100.0 * down / std::abs(K1),
         static_cast<std::size_t>(s->cause)});
  }
  return out;
}

// "value,": of a tip K1 and K2 below and above, of a point in space all three above.
std::string derivative_cells(const SensitivePoint& point, const Sensitivity& s) {
  std::string text;
  const bool tip = point.front.is_tip();
  for (std::size_t mode = 0; mode < (tip ? 2U : 3U); ++mode) {
    for (const bool above : {false, true}) {
      const std::optional<double> slope = point.derivative(s, mode, above);
      text += !tip && !above ? "" : slope ? fmt::format("{},", *slope) : ",";
    }
  }
  return text;
}

// Rows of one cause: one for each point, in space none where nothing holds a body above the value.
std::string rows_of_cause(const std::string& begin, const results::FrontResult& front,
                          const Sensitivity& s) {
  std::string text;
  for (std::size_t i = 0; i < (front.is_tip() ? 1 : s.above.size()); ++i) {
    const SensitivePoint point{front, i};
    const results::FrontPointResult& at = point.result();
    text += fmt::format("{},{},{},{}{},{},{},{}{},{}\n", begin, front.name, front.a,
                        front.is_tip() ? ""
                                       : fmt::format("{},{:d},{},", at.number, at.at_surface, at.s),
                        results::display_word(s.cause), s.name, s.value, derivative_cells(point, s),
                        s.range ? fmt::format("{}", (*s.range)[0]) : "",
                        s.range ? fmt::format("{}", (*s.range)[1]) : "");
  }
  return text;
}

} // namespace

void write_sensitivity_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run) {
  if (model.cracks.empty()) {
    return;
  }
  const bool space = model.mesh.dim == 3;
  const base::UnitSystem& units = model.units;
  std::string text = fmt::format(
      "# units: a{3} and values of FIT and A [{0}], of E [{1}], of LOAD [1]; dK1 dK2{4} [{2}] over "
      "the unit of the value\n"
      "increment,step,crack,a,{5}cause,name,value,{6},from,to\n",
      units.length_name, units.stress_name(), units.stress_intensity_name(), space ? ", s" : "",
      space ? " dK3" : "", space ? "point,at_surface,s," : "",
      space ? "dK1,dK2,dK3" : "dK1_below,dK1_above,dK2_below,dK2_above");
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      const std::string begin = fmt::format("{},{}", increment.number, step.step);
      for (const results::FrontResult& front : step.fronts) {
        for (const Sensitivity& s : front.sensitivities.of) {
          text += rows_of_cause(begin, front, s);
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
  for (const SensitivePoint& point : leading_points(*found)) {
    for (const Sensitivity* s : sorted(model, point)) {
      table.rows.push_back(row_of(model, point, *s));
    }
  }
  return table;
}

std::vector<std::string> sensitivity_notes(const model::Model& model,
                                           const results::Increment& increment) {
  std::vector<std::string> notes;
  const results::StepResult* found = results::find_step(increment, leading_step(model));
  if (found != nullptr) {
    for (const results::FrontResult& front : found->fronts) {
      for (const std::string& note : front.sensitivities.notes) {
        if (std::ranges::find(notes, note) == notes.end()) {
          notes.push_back(note);
        }
      }
    }
  }
  return notes;
}

std::vector<Figure> sensitivity_figures(const model::Model& model, const results::RunResult& run) {
  const std::string step = leading_step(model);
  Figure figure;
  for (const results::Increment* increment : chosen_increments(run, 3)) {
    const results::StepResult* found = results::find_step(*increment, step);
    for (const SensitivePoint& point :
         found != nullptr ? leading_points(*found) : std::vector<SensitivePoint>()) {
      if (point.front.invalid_reason.empty() && point.result().K1 > 0.0) {
        figure.drawings.push_back(
            draw_svg(tornado_of(model, point,
                                fmt::format("{}, a = {:.4g} {}", point.name(), point.front.a,
                                            model.units.length_name))));
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
