// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/spectrum_tables.hpp"

#include "base/tidy.hpp"
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>

namespace spricka::report {

namespace {

using results::GrowthResult;
using results::SpectrumLevel;

const model::SpectrumDefinition& spectrum_of_growth(const model::Model& model) {
  return model.spectra[*model.growth->spectrum];
}

/// Loads as the deck lists them: in its unit, or as places t on the path.
class LoadScale {
public:
  explicit LoadScale(const model::Model& model)
      : values_(spectrum_of_growth(model).values),
        name_(values_ ? "load"
                      : fmt::format("t of load path {}",
                                    model.load_paths[spectrum_of_growth(model).path].name)) {}

  [[nodiscard]] double load(double t) const { return values_ ? values_->value_at(t) : t; }
  [[nodiscard]] double range(double t) const {
    return values_ ? std::abs(values_->at_to - values_->at_from) * t : t;
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string unit() const { return values_ ? values_->unit : std::string(); }
  [[nodiscard]] std::string words(double number) const {
    return fmt::format("{:.6g}{}{}", number, unit().empty() ? "" : " ", unit());
  }

private:
  std::optional<model::SpectrumValues> values_;
  std::string name_;
};

// What is made of cycles before they are shown.
std::string_view counting_words(const model::SpectrumDefinition& spectrum) {
  return !spectrum.sequence ? "as the deck lists them"
         : spectrum.counting == model::CycleCounting::pairs
             ? "each valley with the peak behind it (COUNT=PAIRS)"
             : "counted by rainflow (COUNT=RAINFLOW)";
}

/// A peak of the loads, and how often it comes.
struct Peak {
  double top = 0.0;
  double count = 0.0;
};

std::vector<Peak> peaks_of(const model::SpectrumDefinition& spectrum) {
  std::vector<Peak> peaks;
  for (const std::array<double, 3>& cycle : spectrum.cycles) {
    peaks.push_back({cycle[1], cycle[2]});
  }
  const std::vector<double>& t = spectrum.turning_points;
  for (std::size_t i = 0; i < t.size(); ++i) { // the pass is repeated: its ends meet
    const double before = t[(i + t.size() - 1) % t.size()];
    const double after = t[(i + 1) % t.size()];
    if (t[i] > before && t[i] >= after) {
      peaks.push_back({t[i], 1.0});
    }
  }
  std::ranges::sort(peaks, std::greater<>(), &Peak::top);
  return peaks;
}

/// Levels, falling, and how many reach them, as a curve of steps that begins at half a one.
std::vector<DrawingPoint> steps(const std::vector<std::array<double, 2>>& reached) {
  std::vector<DrawingPoint> points;
  double before = 0.5;
  for (const auto& [level, count] : reached) {
    points.push_back({std::min(before, count), level}); // a step, down and on
    points.push_back({count, level});
    before = count;
  }
  return points;
}

bool has_parts(const GrowthResult& growth) {
  return !growth.spectrum_parts.peaks.empty() &&
         std::isfinite(growth.spectrum_parts.peaks.front().growth);
}

/// A row of the tables, with the scale of its numbers.
struct LevelRow {
  const SpectrumLevel& level;
  double low = 0.0, high = 0.0; ///< as the deck lists loads
  bool of_ranges = false;
};

std::vector<LevelRow> rows_of(const std::vector<SpectrumLevel>& levels, const LoadScale& scale,
                              bool ranges) {
  std::vector<LevelRow> rows;
  rows.reserve(levels.size());
  for (const SpectrumLevel& level : levels) {
    const auto [low, high] = ranges ? std::minmax({scale.range(level.low), scale.range(level.high)})
                                    : std::minmax({scale.load(level.low), scale.load(level.high)});
    rows.push_back(
        {level, base::restore_short_decimal(low), base::restore_short_decimal(high), ranges});
  }
  return rows;
}

ReportTable level_table(const GrowthResult& growth, const LoadScale& scale, bool ranges) {
  const std::string unit = scale.unit();
  Columns<LevelRow> columns;
  columns.number(ranges ? "range from" : "peak from", unit, &LevelRow::low)
      .number("to", unit, &LevelRow::high)
      .number("cycles", "", [](const LevelRow& row) { return row.level.cycles; })
      .number("and above", "", [](const LevelRow& row) { return row.level.reached; });
  if (!ranges) {
    columns.number("rises through", "", [](const LevelRow& row) { return row.level.crossed; });
  }
  if (has_parts(growth)) {
    columns
        .number(
            "of the growth", "%", [](const LevelRow& row) { return 100.0 * row.level.growth; },
            "{:.3f}")
        .number(
            "of the life", "%", [](const LevelRow& row) { return 100.0 * row.level.life; },
            "{:.3f}");
  }
  return columns.table(
      ranges ? "Cycles of a pass by their ranges" : "Cycles of a pass by their peaks",
      rows_of(ranges ? growth.spectrum_parts.ranges : growth.spectrum_parts.peaks, scale, ranges));
}

// Cycles that CLIP and OMIT have had, and what the life was without.
std::string reduction_words(const model::SpectrumDefinition& spectrum, const GrowthResult& growth,
                            const LoadScale& scale, const results::OtherSpectrumLife& other) {
  const bool omitted = other.name == "without OMIT";
  std::string out =
      omitted ? fmt::format("OMIT={} leaves out {:.7g} of {:.7g} cycles of a pass",
                            scale.words(scale.range(spectrum.omit.value_or(0.0))),
                            other.cycles_per_pass - growth.cycles_per_pass, other.cycles_per_pass)
              : fmt::format("CLIP={} cuts higher loads down to it",
                            scale.words(scale.load(spectrum.clip.value_or(0.0))));
  if (!other.ratio) {
    return out + "; what that does to the life is not known.\n";
  }
  return out + fmt::format("; without it the life would be {:.5g} times as long ({:+.2g} %), "
                           "without interaction of cycles.\n",
                           *other.ratio, 100.0 * (*other.ratio - 1.0));
}

} // namespace

std::vector<ReportTable> spectrum_tables(const model::Model& model, const results::RunResult& run) {
  std::vector<ReportTable> tables;
  if (!run.growth || !model.growth->spectrum) {
    return tables;
  }
  const LoadScale scale(model);
  const results::SpectrumParts& parts = run.growth->spectrum_parts;
  if (parts.peaks.size() > 1) {
    tables.push_back(level_table(*run.growth, scale, false));
  }
  if (parts.ranges.size() > 1) {
    tables.push_back(level_table(*run.growth, scale, true));
  }
  return tables;
}

void write_spectrum_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::RunResult& run) {
  if (!run.growth || !model.growth->spectrum) {
    return;
  }
  const LoadScale scale(model);
  const results::SpectrumParts& parts = run.growth->spectrum_parts;
  std::vector<LevelRow> rows = rows_of(parts.peaks, scale, false);
  std::ranges::copy(rows_of(parts.ranges, scale, true), std::back_inserter(rows));
  Columns<LevelRow> columns;
  columns.exact("of", [](const LevelRow& row) { return row.of_ranges ? "range" : "peak"; })
      .exact("from", &LevelRow::low)
      .exact("to", &LevelRow::high)
      .exact("t_from", [](const LevelRow& row) { return row.level.low; })
      .exact("t_to", [](const LevelRow& row) { return row.level.high; })
      .exact("cycles", [](const LevelRow& row) { return row.level.cycles; })
      .exact("reached", [](const LevelRow& row) { return row.level.reached; })
      .fill_only_if([](const LevelRow& row) { return !row.of_ranges; })
      .exact("crossed", [](const LevelRow& row) { return row.level.crossed; })
      .fill_only_if([](const LevelRow& row) { return std::isfinite(row.level.growth); })
      .exact("growth_share", [](const LevelRow& row) { return row.level.growth; })
      .exact("life_share", [](const LevelRow& row) { return row.level.life; });
  const std::string units = fmt::format(
      "from to [{}], t_from t_to [t of load path {}], cycles reached crossed [per pass]",
      scale.unit().empty() ? "load" : scale.unit(),
      model.load_paths[spectrum_of_growth(model).path].name);
  write_file(file, columns.csv(units, rows));
}

std::string spectrum_summary(const model::Model& model, const results::RunResult& run) {
  if (!run.growth || !model.growth->spectrum) {
    return {};
  }
  const GrowthResult& growth = *run.growth;
  const model::SpectrumDefinition& spectrum = spectrum_of_growth(model);
  const LoadScale scale(model);
  std::string out =
      fmt::format("Spectrum {}: cycles {}.\n", spectrum.name, counting_words(spectrum));
  if (!spectrum.origin.empty()) {
    out += spectrum.origin + ".\n";
  }
  for (const results::OtherSpectrumLife& other : growth.spectrum_parts.others) {
    if (!other.name.starts_with("COUNT=")) {
      out += reduction_words(spectrum, growth, scale, other);
    } else if (other.ratio) {
      out += fmt::format("By {} the life would be {:.5g} times as long ({:+.2g} %), without "
                         "interaction of cycles.\n",
                         other.name, *other.ratio, 100.0 * (*other.ratio - 1.0));
    }
  }
  if (growth.followed && spectrum.sequence) {
    out +=
        "With friction the life by the other COUNT is not known: K is no function of the load.\n";
  }
  return out;
}

std::optional<Figure> exceedance_figure(const model::Model& model, const GrowthResult& growth) {
  if (!model.growth->spectrum) {
    return std::nullopt;
  }
  const model::SpectrumDefinition& spectrum = spectrum_of_growth(model);
  const LoadScale scale(model);
  std::vector<std::array<double, 2>> reached;
  double sum = 0.0;
  for (const Peak& peak : peaks_of(spectrum)) {
    sum += peak.count;
    const double load = scale.load(peak.top);
    if (!reached.empty() && reached.back()[0] == load) {
      reached.back()[1] = sum;
    } else {
      reached.push_back({load, sum});
    }
  }
  if (reached.size() < 2 && growth.ranges.size() < 2) {
    return std::nullopt;
  }
  const auto curve = [](const std::string& title, const std::string& x, const MeasureTitle& y,
                        const std::vector<std::array<double, 2>>& of) {
    PlotSeries series = styled_curve("", 0, 0);
    series.points = steps(of);
    Plot plot{title, axis_title(x, {}), y, {series}};
    plot.log_x = true;
    plot.legend_below = true; // beside each other
    return plot;
  };
  std::vector<std::array<double, 2>> ranges = growth.ranges;
  for (auto& [range, count] : ranges) {
    range = scale.range(range);
  }
  Plot levels = curve("Exceedances of the spectrum", "times in a pass",
                      axis_title(scale.name(), {scale.unit()}), reached);
  levels.series.front().name = "peaks that reach the load";
  PlotSeries crossed = styled_curve("rises through the load", 1, 1);
  for (const SpectrumLevel& level : growth.spectrum_parts.peaks) {
    crossed.points.push_back({level.crossed, scale.load(level.low)});
  }
  levels.series.push_back(std::move(crossed));
  std::vector<std::string> drawings{
      draw_svg(levels),
      draw_svg(curve("Ranges of the spectrum's cycles", "cycles in a pass of this range or more",
                     axis_title("range of " + scale.name(), {scale.unit()}), ranges))};
  std::string more;
  if (has_parts(growth) && growth.spectrum_parts.peaks.size() > 1) {
    Plot shares{"What the levels do",
                axis_title("peak, " + scale.name(), {scale.unit()}),
                axis_title("part of the whole", {"%"}),
                {styled_curve("of the growth", 0, 0), styled_curve("of the life", 1, 1)}};
    shares.legend_below = true;
    for (const SpectrumLevel& level : growth.spectrum_parts.peaks) {
      const double load = 0.5 * (scale.load(level.low) + scale.load(level.high));
      shares.series[0].points.push_back({load, 100.0 * level.growth});
      shares.series[1].points.push_back({load, 100.0 * level.life});
    }
    for (std::size_t k = 0; k < shares.series.size(); ++k) {
      shares.series[k].marker = palette_marker_shape(k);
    }
    drawings.push_back(draw_svg(shares));
    more = " The last picture: which part of the crack's growth, and of its life, the cycles of "
           "each level "
           "make, without interaction of cycles.";
  }
  return Figure{std::move(drawings), "",
                fmt::format("Spectrum {}: how many of the {:.6g} peaks of a pass reach a load, and "
                            "how many of its {:.6g} cycles have a range; cycles {}.{}",
                            spectrum.name, sum, growth.cycles_per_pass, counting_words(spectrum),
                            more)};
}

} // namespace spricka::report
