// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/growth_law_figure.hpp"

#include "life/growth_law.hpp"
#include "model/model.hpp"
#include "report/topics/growth_point_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::report {
namespace {

using results::GrowthResult;
using results::GrowthStation;

constexpr double same_ratio = 0.02; // R that one curve stands for

/// A length of the axis of delta K.
struct RangeOfK {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Plot law_plot(const model::Model& model, const std::string& per) {
  Plot plot{"Growth law over the range it was used in",
            axis_title("ΔK", model.units.output_stress_intensity()),
            axis_title("da/dN", model.units.output_length() / base::OutputUnit{per}),
            {}};
  plot.log_x = true;
  plot.log_y = true;
  plot.legend_below = true;
  return plot;
}

/// What the law gave at the lengths that were solved; of each point a series of marks.
std::vector<PlotSeries> marks_of_stations(const results::RunResult& run) {
  std::vector<PlotSeries> all;
  const std::vector<ReportedGrowthPoint> reported = name_reported_growth_points(run);
  for (std::size_t t = 0; t < reported.size(); ++t) {
    PlotSeries series = marker_series(reported[t].name, palette_marker_shape(t));
    series.colour = styled_curve("", t, 0).colour;
    for (const GrowthStation& station : run.growth->stations) {
      const results::GrownPointResult& tip = station.points[reported[t].index];
      const double range = tip.K_max - tip.K_min;
      if (range > 0.0 && tip.rate > 0.0) {
        series.points.push_back({range, tip.rate});
      }
    }
    if (!series.points.empty()) {
      all.push_back(std::move(series));
    }
  }
  return all;
}

/// The least and the largest R of the cycles, one of them where they are alike.
std::vector<double> ratios_to_draw(const model::LawUse& use) {
  return use.highest_ratio - use.lowest_ratio > same_ratio
             ? std::vector{use.lowest_ratio, use.highest_ratio}
             : std::vector{use.lowest_ratio};
}

/// A law as lines in a plot.
class LawCurves {
public:
  /// Over the delta K of these cycles, on a crack of length `a`.
  LawCurves(const model::CrackGrowthSettings& growth, const model::LawUse& use, double a)
      : growth_(growth),
        law_(growth.law, growth.constants), place_{.a = a}, used_{use.lowest_delta_k,
                                                                  use.highest_delta_k} {}

  /// At R: full within the delta K of the cycles, dashed on through the range of the data.
  void add(double R, std::size_t ink, Plot& plot) const {
    add_line(fmt::format("R = {:.3g}", R), R, used_, {ink, 0}, plot);
    const RangeOfK all = with_range_of_data(R);
    if (all.low < used_.low) {
      add_line("", R, {all.low, used_.low}, {ink, 1}, plot);
    }
    if (all.high > used_.high) {
      add_line("", R, {used_.high, all.high}, {ink, 1}, plot);
    }
    if (const std::optional<std::array<double, 2>> ends = law_.table_K_range(R)) {
      PlotSeries marks =
          marker_series(fmt::format("first and last row, R = {:.3g}", R), MarkerShape::plus);
      for (const double range : *ends) {
        const double delta_k = R < 0.0 ? range * (1.0 - R) : range;
        marks.points.push_back({delta_k, rate(delta_k, R)});
      }
      plot.series.push_back(std::move(marks));
    }
  }

private:
  [[nodiscard]] double rate(double delta_k, double R) const {
    const double K_max = delta_k / (1.0 - R);
    return law_.growth_rate(K_max, R * K_max, place_);
  }

  [[nodiscard]] RangeOfK with_range_of_data(double R) const {
    RangeOfK range = used_;
    const model::GrowthLawData& data = growth_.data;
    for (const std::optional<double>& limit : {data.lowest_delta_k, data.highest_delta_k}) {
      if (limit && *limit > 0.0) {
        range.add(*limit);
      }
    }
    if (const std::optional<std::array<double, 2>> rows = law_.table_K_range(R)) {
      range.add(R < 0.0 ? (*rows)[0] * (1.0 - R) : (*rows)[0]);
      range.add(R < 0.0 ? (*rows)[1] * (1.0 - R) : (*rows)[1]);
    }
    return range;
  }

  void add_line(std::string name, double R, const RangeOfK& over,
                const std::array<std::size_t, 2>& ink_and_dash, Plot& plot) const {
    constexpr int parts = 60;
    PlotSeries line = styled_curve(std::move(name), ink_and_dash[0], ink_and_dash[1]);
    for (int i = 0; i <= parts; ++i) {
      const double delta_k =
          over.low * std::pow(over.high / over.low, static_cast<double>(i) / parts);
      const double there = rate(delta_k, R);
      if (there > 0.0 && std::isfinite(there)) {
        line.points.push_back({delta_k, there});
      }
    }
    plot.series.push_back(std::move(line));
  }

  const model::CrackGrowthSettings& growth_;
  life::GrowthRateLaw law_;
  model::PlaceOnCrack place_;
  RangeOfK used_;
};

/// The limits of the data as upright lines through the whole plot.
void add_limits_of_data(const model::GrowthLawData& data, Plot& plot) {
  RangeOfK rates;
  for (const PlotSeries& series : plot.series) {
    for (const DrawingPoint& point : series.points) {
      rates.add(point.y);
    }
  }
  for (const auto& [limit, name] :
       {std::pair(data.lowest_delta_k, "least"), std::pair(data.highest_delta_k, "largest")}) {
    if (limit && *limit > 0.0 && rates.high > rates.low) {
      PlotSeries line = styled_curve(fmt::format("{} ΔK of the data", name), 7, 2);
      line.points = {{*limit, rates.low}, {*limit, rates.high}};
      line.colour = "#666";
      plot.series.push_back(std::move(line));
    }
  }
}

std::string words_on_data(const model::CrackGrowthSettings& growth) {
  const model::GrowthLawData& data = growth.data;
  const bool known = data.lowest_delta_k || data.highest_delta_k;
  if (!known && growth.law != model::CrackGrowthLaw::table) {
    return " The range of the law's data is not stated.";
  }
  std::string words = " Dashed: on through the range of its data.";
  if (data.lowest_ratio || data.highest_ratio) {
    words += fmt::format(" Their R: {}{}{}.",
                         data.lowest_ratio ? fmt::format("from {:.3g}", *data.lowest_ratio) : "",
                         data.lowest_ratio && data.highest_ratio ? " " : "",
                         data.highest_ratio ? fmt::format("to {:.3g}", *data.highest_ratio) : "");
  }
  return words;
}

} // namespace

std::optional<Figure> growth_law_figure(const model::Model& model, const results::RunResult& run) {
  const GrowthResult& growth = *run.growth;
  const model::LawUse& use = growth.law_use;
  if (!(use.highest_delta_k >= use.lowest_delta_k) || growth.stations.empty()) {
    return std::nullopt;
  }
  const bool pass = growth.unit == "pass";
  std::vector<PlotSeries> marks = marks_of_stations(run);
  Plot plot = law_plot(model, "cycle");
  const LawCurves curves(*model.growth, use, growth.stations.front().points.front().a);
  const std::vector<double> ratios = ratios_to_draw(use);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    curves.add(ratios[i], i, plot);
  }
  if (!pass) {
    std::ranges::copy(marks, std::back_inserter(plot.series));
  }
  add_limits_of_data(model.growth->data, plot);
  std::vector<std::string> drawings{draw_svg(plot)};
  const base::OutputUnit K = model.units.output_stress_intensity();
  if (pass && !marks.empty()) {
    Plot of_pass = law_plot(model, growth.unit);
    of_pass.label = "Growth of a pass over the ΔK of its extremes";
    of_pass.series = std::move(marks);
    drawings.push_back(draw_svg(of_pass));
  }
  return Figure{
      std::move(drawings), "",
      fmt::format("The growth law at the R of the cycles that grow, {:.3g} to {:.3g}, over their "
                  "ΔK, {:.4g} to {:.4g} {}{}.{}",
                  use.lowest_ratio, use.highest_ratio, K.from_deck(use.lowest_delta_k),
                  K.from_deck(use.highest_delta_k), typeset_unit(K.name),
                  pass ? "; at the right the growth of a pass at the lengths that were solved"
                       : "; marks: at the lengths that were solved",
                  words_on_data(*model.growth))};
}

} // namespace spricka::report
