// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/result_rows.hpp"
#include "results/result_unit.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace spricka::report {
namespace {

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::vector<std::string> front_names(const results::RunResult& run) {
  std::vector<std::string> names;
  for (const FrontRow& row : front_rows(run.increments)) {
    add_unique(names, row.front.name);
  }
  return names;
}

/// K1 of a front at the end of a step over its length, with error bars.
PlotSeries k_history(const results::RunResult& run, std::string_view step, std::string_view front) {
  PlotSeries curve;
  for (const results::CrackLengthResult& increment : run.increments) {
    if (const auto* const found = find_front_at_step(increment, step, front)) {
      curve.points.push_back({found->a, found->single_point().K1});
      curve.bars.push_back(k1_bar_for_plot(found));
    }
  }
  return curve;
}

bool grows(const results::RunResult& run, const std::vector<std::string>& fronts,
           std::string_view step) {
  return std::ranges::any_of(fronts, [&](const std::string& front) {
    const std::vector<DrawingPoint> points = k_history(run, step, front).points;
    return !points.empty() && points.front().x != points.back().x;
  });
}

constexpr std::array reference_marks{MarkerShape::plus, MarkerShape::cross, MarkerShape::diamond,
                                     MarkerShape::triangle};

/// Curves that no eye could tell apart: within a thousandth of the largest value.
bool coincide(const std::vector<DrawingPoint>& a, const std::vector<DrawingPoint>& b) {
  double largest = 0.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max({largest, std::abs(a[i].y), std::abs(b[i].y)});
    apart = std::max({apart, std::abs(a[i].y - b[i].y), std::abs(a[i].x - b[i].x)});
  }
  return a.size() == b.size() && apart <= 1e-3 * largest;
}

/// Fronts, or steps, whose curves coincide, and the curve.
struct CurveGroup {
  std::vector<std::string> fronts;
  std::vector<std::string> steps;
  PlotSeries curve;
};

std::vector<CurveGroup> groups_of_step(const results::RunResult& run,
                                       const std::vector<std::string>& fronts,
                                       const std::string& step) {
  std::vector<CurveGroup> groups;
  for (const std::string& front : fronts) {
    PlotSeries curve = k_history(run, step, front);
    const auto same = std::ranges::find_if(groups, [&](const CurveGroup& group) {
      return coincide(group.curve.points, curve.points);
    });
    if (same != groups.end()) {
      same->fronts.push_back(front);
    } else if (!curve.points.empty()) {
      groups.push_back({{front}, {step}, std::move(curve)});
    }
  }
  return groups;
}

std::vector<CurveGroup> groups_of(const model::Model& model, const results::RunResult& run,
                                  const std::vector<std::string>& fronts) {
  std::vector<CurveGroup> groups;
  for (const model::Step& step : model.steps) {
    for (CurveGroup& fresh : groups_of_step(run, fronts, step.name)) {
      const auto same = std::ranges::find_if(groups, [&](const CurveGroup& group) {
        return group.fronts == fresh.fronts && coincide(group.curve.points, fresh.curve.points);
      });
      if (same != groups.end()) {
        same->steps.push_back(step.name);
      } else {
        groups.push_back(std::move(fresh));
      }
    }
  }
  return groups;
}

PlotSeries group_series(const CurveGroup& group, bool name_fronts, std::size_t ink,
                        std::size_t pattern) {
  std::string name = fmt::format("{}", fmt::join(group.steps, ", "));
  if (name_fronts) {
    name += fmt::format(": {}", fmt::join(group.fronts, ", "));
  }
  PlotSeries series = styled_curve(std::move(name), ink, pattern);
  series.points = group.curve.points;
  series.bars = group.curve.bars;
  series.marker = palette_marker_shape(ink);
  return series;
}

double find_number(const model::Model& model, std::string_view name) {
  for (const auto& [parameter, value] : model.parameters) {
    if (upper_case(parameter) == name) {
      return value;
    }
  }
  return 0.0;
}

/// Empty where the reference is 0.
std::string percent(const KCheckReference& r) {
  return r.wanted == 0.0 ? std::string()
                         : fmt::format("{:+.2f}", 100.0 * (r.found / r.wanted - 1.0));
}

/// What stands beside the normalised plot: the references of its step.
ReportTable normalised_table(const FigureReferenceValues& state,
                             const std::vector<KCheckReference>& references,
                             const std::string& step) {
  std::vector<KCheckReference> rows;
  std::ranges::copy_if(references, std::back_inserter(rows),
                       [&](const KCheckReference& r) { return r.step == step; });
  const auto over_k0 = [&](double KCheckReference::*K) {
    return [&state, K](const KCheckReference& r) { return r.*K / state.k0(r.a); };
  };
  Columns<KCheckReference> columns;
  columns.words("tip", &KCheckReference::tip)
      .number(
          "a/R", "", [&](const KCheckReference& r) { return r.a / state.radius; }, "{:.3g}")
      .number("computed", "", over_k0(&KCheckReference::found), "{:.3f}")
      .number("reference", "", over_k0(&KCheckReference::wanted), "{:.3f}")
      .number("error", "%", percent);
  return columns.table("K₁ / (σ √(πa))", rows);
}

} // namespace

void add_figure(std::vector<Figure>& figures, std::optional<Figure> figure) {
  if (figure) {
    figures.push_back(std::move(*figure));
  }
}

double FigureReferenceValues::k0(double a) const {
  return sigma * std::sqrt(std::numbers::pi * a);
}

std::optional<FigureReferenceValues> find_figure_reference_values(const model::Model& model) {
  const FigureReferenceValues state{find_number(model, "R"), find_number(model, "SIGMA")};
  return state.radius > 0.0 && state.sigma > 0.0 ? std::optional(state) : std::nullopt;
}

std::vector<KCheckReference> k_references(const model::Model& model,
                                          const results::RunResult& run) {
  std::vector<KCheckReference> references;
  for (const model::ResultCheck& check : model.checks) {
    if ((check.quantity != "K" && check.quantity != "K1") || check.arguments.size() < 2) {
      continue;
    }
    const auto* const tip = std::get_if<std::string>(&check.arguments[0]);
    const auto* const step = std::get_if<std::string>(&check.arguments[1]);
    if (tip == nullptr || step == nullptr) {
      continue;
    }
    const double* const a =
        check.arguments.size() > 2 ? std::get_if<double>(&check.arguments[2]) : nullptr;
    // A check without a length speaks of the first one.
    const results::FrontResult* const found =
        results::find_front_at_length(run, *step, *tip, a == nullptr ? 0.0 : *a);
    if (found != nullptr && found->is_tip()) {
      references.push_back(
          {.tip = *tip,
           .step = *step,
           .a = a == nullptr ? found->a : *a,
           .wanted = results::wanted_value(model.units, check, run),
           .found = found->single_point().K1,
           .source = check.source,
           .bar = found->has_error_bar() ? found->single_point().bar[0].size() : 0.0});
    }
  }
  return references;
}

Plot KFigureScale::plot(const model::Model& model, const std::string& label) const {
  return {label,
          state ? "a / R" : axis_title("a", model.units.output_length()),
          state ? "K₁ / (σ √(πa))" : axis_title("K₁", model.units.output_stress_intensity()),
          {}};
}

void add_reference_marks(Plot& plot, const std::vector<KCheckReference>& references,
                         std::string_view step, std::span<const MarkerShape> shapes,
                         const KFigureScale& scale) {
  std::vector<std::string> sources;
  for (const KCheckReference& reference : references) {
    add_unique(sources, reference.source);
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    PlotSeries series =
        marker_series(sources[i].empty() ? "reference" : sources[i], shapes[i % shapes.size()]);
    for (const KCheckReference& reference : references) {
      if (reference.source == sources[i] && (step.empty() || reference.step == step)) {
        series.points.push_back(scale(reference.a, reference.wanted));
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
}

std::optional<Figure> k_over_crack_length_figure(const model::Model& model,
                                                 const results::RunResult& run) {
  const std::vector<std::string> fronts = front_names(run);
  Plot plot = KFigureScale().plot(model, "Stress intensity factor over crack length");
  bool any = false;
  std::string last_step;
  std::size_t ink = 0;
  std::size_t pattern = 0;
  for (const CurveGroup& group : groups_of(model, run, fronts)) {
    any = any || grows(run, fronts, group.steps.front());
    // Curves of one step share its colour and differ by their dashes.
    if (!plot.series.empty()) {
      const bool same_step = group.steps.front() == last_step;
      ink += same_step ? 0 : 1;
      pattern = same_step ? pattern + 1 : 0;
    }
    last_step = group.steps.front();
    plot.series.push_back(group_series(group, fronts.size() > 1, ink, pattern));
  }
  add_reference_marks(plot, k_references(model, run), "", reference_marks, {});
  if (!any) {
    return std::nullopt;
  }
  return Figure{{draw_svg(plot)},
                "",
                "Stress intensity factor K₁ at the ends of the steps over the crack length a." +
                    error_bar_note(plot.series)};
}

std::optional<Figure> normalised_k_figure(const model::Model& model,
                                          const results::RunResult& run) {
  const KFigureScale scale{find_figure_reference_values(model)};
  const std::string step = results::shown_step_name(model, run.increments);
  const std::vector<std::string> fronts = front_names(run);
  if (!scale.state || !grows(run, fronts, step)) {
    return std::nullopt;
  }
  Plot plot = scale.plot(model, "Normalised stress intensity factor over crack length");
  std::size_t ink = 0;
  for (const CurveGroup& group : groups_of_step(run, fronts, step)) {
    PlotSeries series = group_series(group, fronts.size() > 1, ink, ink);
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const DrawingPoint p = series.points[i];
      series.points[i] = scale(p.x, p.y);
      series.bars[i] /= scale.state->k0(p.x);
    }
    plot.series.push_back(std::move(series));
    ++ink;
  }
  const std::vector<KCheckReference> references = k_references(model, run);
  add_reference_marks(plot, references, step, reference_marks, scale);
  plot.legend_below = true;
  const ReportTable table = normalised_table(*scale.state, references, step);
  Figure figure{{draw_svg(plot)},
                "",
                fmt::format("K₁ at the end of step {} over σ √(πa), against a/R; R = {}, σ = {} "
                            "(the deck's parameters R and SIGMA).{}",
                            step, model.units.output_length().text(scale.state->radius, 6),
                            model.units.output_stress().text(scale.state->sigma, 4),
                            table.rows.empty() ? "" : " Marks: values the deck compares with.") +
                    error_bar_note(plot.series)};
  if (!table.rows.empty()) {
    figure.drawings.push_back(table_to_html(table));
  }
  return figure;
}

ReportTable k_reference_table(const model::Model& model, const results::RunResult& run) {
  const base::OutputUnit k_unit = model.units.output_stress_intensity();
  Columns<KCheckReference> columns;
  columns.words("tip", &KCheckReference::tip)
      .words("step", &KCheckReference::step)
      .number("a", model.units.output_length(), &KCheckReference::a, "{:.4g}")
      .number("K1", k_unit, &KCheckReference::found, "{:.5g}")
      .number("+-", k_unit.name,
              [k_unit](const KCheckReference& r) {
                return r.bar > 0.0 ? format_error_bar(k_unit.from_deck(r.bar)) : "";
              })
      .number("reference", k_unit, &KCheckReference::wanted, "{:.5g}")
      .number("error", "%", percent)
      .words("source", &KCheckReference::source);
  return columns.table("K1 beside its references", k_references(model, run));
}

double k1_bar_for_plot(const results::FrontResult* front) {
  return front != nullptr && front->is_tip() && front->has_error_bar()
             ? front->single_point().bar[0].size()
             : no_bar;
}

std::vector<const results::CrackLengthResult*> sample_increments(const results::RunResult& run,
                                                                 std::size_t limit) {
  std::vector<const results::CrackLengthResult*> chosen;
  const std::size_t count = std::min(limit, run.increments.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count > 1 ? i * (run.increments.size() - 1) / (count - 1) : 0;
    chosen.push_back(&run.increments[at]);
  }
  return chosen;
}

} // namespace spricka::report
