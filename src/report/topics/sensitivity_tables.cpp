// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/sensitivity_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/tornado.hpp"
#include "report/topics/dimension_columns.hpp"
#include "report/topics/result_rows.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
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

// What the value of a cause is written in; a load's is a factor.
base::OutputUnit unit_of(const model::Model& model, SensitivityParameter cause) {
  switch (cause) {
  case SensitivityParameter::load:
    return {};
  case SensitivityParameter::modulus:
    return model.units.output_stress();
  case SensitivityParameter::fit:
  case SensitivityParameter::length:
  case SensitivityParameter::axis:
    break;
  }
  return model.units.output_length();
}

// 1 %, or one micrometre of a fit, in the unit of the value.
double small_change(const model::Model& model, const Sensitivity& s) {
  return s.cause == SensitivityParameter::fit ? 1e-6 / model.units.metre_per_length
                                              : 0.01 * s.value;
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
  for (const Sensitivity& s : point.front.sensitivities.by_parameter) {
    order.push_back(&s);
  }
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](const Sensitivity* s) { return strength(model, point, *s); });
  return order;
}

// Of each front the point inside with the largest K1; none where K is not known to depend on
// anything.
std::vector<SensitivePoint> leading_points(const results::LoadStepResult& step) {
  std::vector<SensitivePoint> leading;
  for (const results::FrontResult& front : step.fronts) {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < front.points.size(); ++i) {
      if (!front.points[i].at_surface && (!most || front.points[i].K1 > front.points[*most].K1)) {
        most = i;
      }
    }
    if (most && !front.sensitivities.by_parameter.empty()) {
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

/// A row of the table: a cause at a point.
struct CauseRow {
  SensitivePoint point;
  const Sensitivity& cause;

  // The change by 1 % or a micrometre more, the other side's in the same direction.
  [[nodiscard]] std::optional<double> change(const model::Model& model, std::size_t mode,
                                             bool up) const {
    const std::optional<double> dK = effect(model, point, cause, mode, up);
    return dK ? std::optional(up ? *dK : -*dK) : std::nullopt;
  }
};

Columns<CauseRow> cause_columns(const model::Model& model) {
  const base::OutputUnit unit = model.units.output_stress_intensity();
  const auto K = [](const CauseRow& row) {
    return std::hypot(row.point.result().K1, row.point.result().K2);
  };
  Columns<CauseRow> columns;
  columns.words("tip", [](const CauseRow& row) { return row.point.name(); });
  columns.words("by", [](const CauseRow& row) { return words_of(row.cause); });
  columns.number("value", "", [&model](const CauseRow& row) {
    const base::OutputUnit of_value = unit_of(model, row.cause.cause);
    return of_value.name.empty() ? fmt::format("{:.6g}", row.cause.value)
                                 : of_value.text(row.cause.value, 6);
  });
  columns.fill_only_if([](const CauseRow& row) { return row.cause.value != 0.0; });
  columns.number("value dK1/dvalue", unit.name, [=](const CauseRow& row) {
    const auto times_value = [&](bool up) {
      const std::optional<double> slope = row.point.derivative(row.cause, 0, up);
      return in_output_unit(
          clean(slope ? std::optional(row.cause.value * *slope) : std::nullopt, K(row)), unit);
    };
    return both(row.point, row.cause, times_value, "{:.5g}");
  });
  columns.fill_only_if({});
  columns.number("for", "", [](const CauseRow& row) {
    return row.cause.cause == SensitivityParameter::fit ? "1 um" : "1 %";
  });
  columns.number("K1 changes", "%", [=, &model](const CauseRow& row) {
    const auto percent = [&](bool up) {
      const double K1 = row.point.result().K1;
      const std::optional<double> dK = row.change(model, 0, up);
      return clean(dK && K1 != 0.0 ? std::optional(100.0 * *dK / std::abs(K1)) : std::nullopt,
                   K(row) > 0.0 ? 1.0 : 0.0);
    };
    return both(row.point, row.cause, percent, "{:+.4f}");
  });
  columns.number("K2 changes", unit.name, [=, &model](const CauseRow& row) {
    const auto of_mode_2 = [&](bool up) {
      return in_output_unit(clean(row.change(model, 1, up), K(row)), unit);
    };
    return both(row.point, row.cause, of_mode_2, "{:+.4g}");
  });
  columns.fill_only_if([](const CauseRow& row) { return row.cause.range.has_value(); });
  for (const auto& [name, side] : {std::pair("kept from", 0U), {"to", 1U}}) {
    columns.number(name, "", [&model, side = side](const CauseRow& row) {
      return bound(unit_of(model, row.cause.cause).from_deck(row.cause.range->at(side)));
    });
  }
  return columns;
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

/// A row of the file: a cause at a point of a front at the end of a step.
struct SensitivityRow : FrontRow {
  const Sensitivity& cause;
  std::size_t index = 0;
  [[nodiscard]] SensitivePoint point() const { return {front, index}; }
};

/// A derivative by the value above it or below, and what its columns' names end with.
struct DerivativeSide {
  const char* ending;
  bool above;
};
constexpr std::array<DerivativeSide, 2> both_sides{{{"_below", false}, {"_above", true}}};
constexpr std::array<DerivativeSide, 1> above_alone{{{"", true}}};

/// What the file has of derivatives, and the line of units of them and of points.
struct DerivativeColumns {
  std::span<const DerivativeSide> sides;
  const char* K;
  const char* s;
};
constexpr base::ByDimension<DerivativeColumns> derivative_columns{
    {both_sides, "dK1 dK2", ""}, {above_alone, "dK1 dK2 dK3", ", s"}};

void add_derivatives(Columns<SensitivityRow>& columns, const model::Model& model) {
  const int dim = model.mesh.dim;
  const base::OutputUnit K = model.units.output_stress_intensity();
  for (std::size_t mode = 0; mode < dimension_columns.at(dim).modes; ++mode) {
    for (const auto& [end, above] : derivative_columns.at(dim).sides) {
      columns.exact(fmt::format("dK{}{}", mode + 1, end),
                    [&model, K, mode, above = above](const SensitivityRow& row) {
                      return in_output_unit(row.point().derivative(row.cause, mode, above),
                                            K / unit_of(model, row.cause.cause));
                    });
    }
  }
}

// One row for each point and cause, in space none where nothing holds a body above the value.
std::vector<SensitivityRow> sensitivity_rows(const results::RunResult& run) {
  std::vector<SensitivityRow> rows;
  for (const FrontRow& row : front_rows(run.increments)) {
    for (const Sensitivity& cause : row.front.sensitivities.by_parameter) {
      for (std::size_t i = 0; i < (row.front.is_tip() ? 1 : cause.above.size()); ++i) {
        rows.push_back({row, cause, i});
      }
    }
  }
  return rows;
}

} // namespace

void write_sensitivity_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run) {
  if (model.cracks.empty()) {
    return;
  }
  using Row = SensitivityRow;
  const int dim = model.mesh.dim;
  Columns<Row> columns = step_columns<Row>();
  columns.exact("crack", [](const Row& row) { return row.front.name; })
      .exact("a", model.units.output_length(), [](const Row& row) { return row.front.a; });
  if (dimension_columns.at(dim).points) {
    columns.exact("point", [](const Row& row) { return row.point().result().number; })
        .exact("at_surface", [](const Row& row) { return row.point().result().at_surface ? 1 : 0; })
        .exact("s", model.units.output_length(),
               [](const Row& row) { return row.point().result().s; });
  }
  columns.exact("cause", [](const Row& row) { return results::display_word(row.cause.cause); })
      .exact("name", [](const Row& row) { return row.cause.name; })
      .exact("value", [&model](const Row& row) {
        return unit_of(model, row.cause.cause).from_deck(row.cause.value);
      });
  add_derivatives(columns, model);
  columns.fill_only_if([](const Row& row) { return row.cause.range.has_value(); });
  for (const auto& [name, side] : {std::pair("from", 0U), {"to", 1U}}) {
    columns.exact(name, [&model, side = side](const Row& row) {
      return unit_of(model, row.cause.cause).from_deck(row.cause.range->at(side));
    });
  }
  const base::UnitSystem& units = model.units;
  const std::string words = fmt::format(
      "a{3} and values of FIT and A [{0}], of E [{1}], of LOAD [1]; {4} [{2}] over the unit "
      "of the value",
      units.output_length().name, units.output_stress().name, units.output_stress_intensity().name,
      derivative_columns.at(dim).s, derivative_columns.at(dim).K);
  write_file(file, columns.csv(words, sensitivity_rows(run)));
}

ReportTable sensitivity_table(const model::Model& model,
                              const results::CrackLengthResult& increment) {
  const std::string step = results::shown_step_name(model, {&increment, 1});
  std::vector<CauseRow> rows;
  if (const results::LoadStepResult* const found = results::find_step(increment, step)) {
    for (const SensitivePoint& point : leading_points(*found)) {
      for (const Sensitivity* cause : sorted(model, point)) {
        rows.push_back({point, *cause});
      }
    }
  }
  return cause_columns(model).table(
      fmt::format("Sensitivity of K1 and K2 at the end of step {}, contact state held fixed", step),
      rows);
}

std::vector<std::string> missing_sensitivity_reasons(const model::Model& model,
                                                     const results::CrackLengthResult& increment) {
  std::vector<std::string> notes;
  const results::LoadStepResult* found =
      results::find_step(increment, results::shown_step_name(model, {&increment, 1}));
  if (found != nullptr) {
    for (const results::FrontResult& front : found->fronts) {
      for (const std::string& note : front.sensitivities.notes) {
        add_unique(notes, note);
      }
    }
  }
  return notes;
}

std::vector<Figure> sensitivity_figures(const model::Model& model, const results::RunResult& run) {
  const std::string step = results::shown_step_name(model, run.increments);
  Figure figure;
  for (const results::CrackLengthResult* increment : sample_increments(run, 3)) {
    const results::LoadStepResult* found = results::find_step(*increment, step);
    for (const SensitivePoint& point :
         found != nullptr ? leading_points(*found) : std::vector<SensitivePoint>()) {
      if (point.front.invalid_reason.empty() && point.result().K1 > 0.0) {
        figure.drawings.push_back(
            draw_svg(tornado_of(model, point,
                                fmt::format("{}, a = {}", point.name(),
                                            model.units.output_length().text(point.front.a, 4)))));
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
