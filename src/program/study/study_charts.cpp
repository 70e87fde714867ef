// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_charts.hpp"

#include "report/drawing/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double least_error = 1e-12; // of an answer: below it there is round-off

struct CurveKind {
  SettingFamily family;
  bool corrected;
};
constexpr std::array curves{
    CurveKind{SettingFamily::whole, false},      CurveKind{SettingFamily::whole, true},
    CurveKind{SettingFamily::host, false},       CurveKind{SettingFamily::tip, false},
    CurveKind{SettingFamily::quarter, false},    CurveKind{SettingFamily::linear, false},
    CurveKind{SettingFamily::transition, false}, CurveKind{SettingFamily::tolerance, false},
    CurveKind{SettingFamily::tube, false},       CurveKind{SettingFamily::path, false},
    CurveKind{SettingFamily::part, false},       CurveKind{SettingFamily::asked, false},
    CurveKind{SettingFamily::asked, true},       CurveKind{SettingFamily::peer, false}};

bool takes_given(SettingFamily family) {
  return family == SettingFamily::whole || family == SettingFamily::host ||
         family == SettingFamily::tip || family == SettingFamily::asked;
}

bool is_joined(SettingFamily family) {
  return family != SettingFamily::transition && family != SettingFamily::tube &&
         family != SettingFamily::path;
}

std::vector<std::size_t> rows_of(const Study& study, SettingFamily family) {
  std::vector<std::size_t> rows;
  std::size_t own = 0;
  for (std::size_t t = 0; t < study.trials.size(); ++t) {
    const SettingFamily found = study.trials[t].setting.family;
    const bool given = takes_given(family) && found == SettingFamily::given;
    if (!study.trials[t].readings.empty() && (found == family || given)) {
      rows.push_back(t);
      own += found == family ? 1 : 0;
    }
  }
  std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
    return study.trials[a].setting.fineness < study.trials[b].setting.fineness;
  });
  return own > 0 ? rows : std::vector<std::size_t>();
}

report::Plot group_plot(const Study& study, const GroupVerdict& group, bool against_cpu) {
  report::Plot plot;
  plot.label = fmt::format("error of {} against {}", display_name(group.group),
                           against_cpu ? "CPU time" : "freedoms");
  plot.x_name = against_cpu ? "CPU  [s]" : "freedoms";
  plot.y_name = fmt::format("largest error of {}  [%]", display_name(group.group));
  plot.log_x = true;
  plot.log_y = true;
  plot.legend_below = true;
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto [family, corrected] = curves.at(i);
    report::PlotSeries series;
    series.name = fmt::format("{}{}", display_name(family), corrected ? ", corrected" : "");
    series.colour = report::palette_colour(i);
    series.dash = report::dash_pattern(i / 7 + (corrected ? 1 : 0));
    series.marker = report::closed_marker(i);
    series.joined = is_joined(family);
    for (const std::size_t row : rows_of(study, family)) {
      const GroupErrors& errors = group.errors[row];
      const double error = corrected ? errors.best : errors.plain;
      const double x =
          against_cpu ? study.trials[row].end.cpu : static_cast<double>(study.trials[row].unknowns);
      if (std::isfinite(error) && x > 0.0) {
        series.points.push_back({x, 100.0 * std::max(error, least_error)});
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
  if (group.floor > 0.0 && high > low) {
    report::PlotSeries floor;
    floor.name = "the reference is no better";
    floor.colour = "#888";
    floor.dash = "5 4";
    floor.points = {{low, 100.0 * group.floor}, {high, 100.0 * group.floor}};
    plot.series.push_back(std::move(floor));
  }
  return plot;
}

} // namespace

std::vector<report::Figure> study_figures(const Study& study, const GroupVerdict& group) {
  report::Figure figure;
  figure.drawings = {draw_svg(group_plot(study, group, true)),
                     draw_svg(group_plot(study, group, false))};
  figure.caption = fmt::format(
      "The largest error of {} of all answers of the group, against the CPU time of the whole run "
      "and against its freedoms.",
      display_name(group.group));
  return {figure};
}

} // namespace spricka::program
