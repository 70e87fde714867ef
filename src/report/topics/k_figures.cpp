// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/plot.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/k_bars.hpp"
#include "report/topics/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace spricka::report {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::vector<std::string> tip_names(const results::RunResult& run) {
  std::vector<std::string> names;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        if (std::find(names.begin(), names.end(), front.name) == names.end()) {
          names.push_back(front.name);
        }
      }
    }
  }
  return names;
}

/// (a, K1) of one tip at the ends of one step, with the error bars of K1.
struct KLengthCurve {
  std::vector<DrawingPoint> points;
  std::vector<double> bars; ///< [point]
};

KLengthCurve history(const results::RunResult& run, std::string_view step, std::string_view tip) {
  KLengthCurve curve;
  for (const results::Increment& increment : run.increments) {
    const results::StepResult* const at = results::find_step(increment, step);
    const results::FrontResult* const found =
        at == nullptr ? nullptr : results::find_front(*at, tip);
    if (found != nullptr) {
      curve.points.push_back({found->a, found->tip().K1});
      curve.bars.push_back(drawn_k1_bar(*found));
    }
  }
  return curve;
}

bool grows(const results::RunResult& run, const std::vector<std::string>& tips,
           std::string_view step) {
  return std::any_of(tips.begin(), tips.end(), [&](const std::string& tip) {
    const std::vector<DrawingPoint> points = history(run, step, tip).points;
    return !points.empty() && points.front().x != points.back().x;
  });
}

std::vector<std::string> sources_of(const std::vector<KReference>& references) {
  std::vector<std::string> sources;
  for (const KReference& reference : references) {
    if (std::find(sources.begin(), sources.end(), reference.source) == sources.end()) {
      sources.push_back(reference.source);
    }
  }
  return sources;
}

/// Marks for references, one series for each source; no step: of all steps.
void add_references(Plot& plot, const std::vector<KReference>& references, std::string_view step) {
  constexpr std::array<MarkerShape, 4> shapes{MarkerShape::plus, MarkerShape::cross,
                                              MarkerShape::diamond, MarkerShape::triangle};
  const std::vector<std::string> sources = sources_of(references);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    PlotSeries series;
    series.name = sources[i].empty() ? "reference" : sources[i];
    series.joined = false;
    series.marker = shapes[i % shapes.size()];
    for (const KReference& reference : references) {
      if (reference.source == sources[i] && (step.empty() || reference.step == step)) {
        series.points.push_back({reference.a, reference.wanted});
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(series);
    }
  }
}

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

/// Tips, or steps, whose curves coincide, and the curve.
struct Group {
  std::vector<std::string> tips;
  std::vector<std::string> steps;
  KLengthCurve curve;
};

std::vector<Group> tip_groups(const results::RunResult& run, const std::vector<std::string>& tips,
                              const std::string& step) {
  std::vector<Group> groups;
  for (const std::string& tip : tips) {
    const KLengthCurve curve = history(run, step, tip);
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return coincide(group.curve.points, curve.points);
    });
    if (curve.points.empty()) {
      continue;
    }
    if (same != groups.end()) {
      same->tips.push_back(tip);
    } else {
      groups.push_back({{tip}, {step}, curve});
    }
  }
  return groups;
}

std::vector<Group> groups_of(const model::Model& model, const results::RunResult& run,
                             const std::vector<std::string>& tips) {
  std::vector<Group> groups;
  for (const model::Step& step : model.steps) {
    for (Group& fresh : tip_groups(run, tips, step.name)) {
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return group.tips == fresh.tips && coincide(group.curve.points, fresh.curve.points);
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

PlotSeries group_series(const Group& group, bool name_tips, std::size_t ink, std::size_t pattern) {
  PlotSeries series;
  series.name = fmt::format("{}", fmt::join(group.steps, ", "));
  if (name_tips) {
    series.name += fmt::format(": {}", fmt::join(group.tips, ", "));
  }
  series.points = group.curve.points;
  series.bars = group.curve.bars;
  series.colour = palette_colour(ink);
  series.dash = dash_pattern(pattern);
  series.marker = closed_marker(ink);
  return series;
}

double find_number(const model::Model& model, std::string_view name) {
  for (const auto& [parameter, value] : model.parameters) {
    if (upper(parameter) == name) {
      return value;
    }
  }
  return 0.0;
}

/// Empty where the reference is 0.
std::string percent(const KReference& r) {
  return r.wanted == 0.0 ? std::string()
                         : fmt::format("{:+.2f}", 100.0 * (r.found / r.wanted - 1.0));
}

/// What stands beside the normalised plot: the references of its step.
ReportTable normalised_table(const NominalStressState& state,
                             const std::vector<KReference>& references, const std::string& step) {
  ReportTable table{"K₁ / (σ √(πa))",
                    {{"tip", "", true},
                     {"a/R", "", false},
                     {"computed", "", false},
                     {"reference", "", false},
                     {"error", "%", false}},
                    {}};
  for (const KReference& r : references) {
    if (r.step == step) {
      const double k0 = state.k0(r.a);
      table.rows.push_back({r.tip, fmt::format("{:.3g}", r.a / state.radius),
                            fmt::format("{:.3f}", r.found / k0),
                            fmt::format("{:.3f}", r.wanted / k0), percent(r)});
    }
  }
  return table;
}

} // namespace

double NominalStressState::k0(double a) const {
  return sigma * std::sqrt(std::numbers::pi * a);
}

std::optional<NominalStressState> find_nominal_state(const model::Model& model) {
  const NominalStressState state{find_number(model, "R"), find_number(model, "SIGMA")};
  return state.radius > 0.0 && state.sigma > 0.0 ? std::optional(state) : std::nullopt;
}

std::vector<KReference> k_references(const model::Model& model, const results::RunResult& run) {
  std::vector<KReference> references;
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
        results::find_front_at(run, *step, *tip, a == nullptr ? 0.0 : *a);
    if (found != nullptr && found->is_tip()) {
      references.push_back({.tip = *tip,
                            .step = *step,
                            .a = a == nullptr ? found->a : *a,
                            .wanted = check.value,
                            .found = found->tip().K1,
                            .source = check.source,
                            .bar = found->has_error_bar() ? found->tip().bar[0].size() : 0.0});
    }
  }
  return references;
}

std::optional<Figure> k_figure(const model::Model& model, const results::RunResult& run) {
  const std::vector<std::string> tips = tip_names(run);
  const std::string k_unit = typeset_unit(model.units.stress_intensity_name());
  Plot plot{"Stress intensity factor over crack length",
            fmt::format("a  [{}]", model.units.length_name),
            fmt::format("K₁  [{}]", k_unit),
            {}};
  bool any = false;
  std::string last_step;
  std::size_t ink = 0;
  std::size_t pattern = 0;
  for (const Group& group : groups_of(model, run, tips)) {
    any = any || grows(run, tips, group.steps.front());
    // Tips of one step share its colour and differ by their dashes.
    if (!plot.series.empty()) {
      const bool same_step = group.steps.front() == last_step;
      ink += same_step ? 0 : 1;
      pattern = same_step ? pattern + 1 : 0;
    }
    last_step = group.steps.front();
    plot.series.push_back(group_series(group, tips.size() > 1, ink, pattern));
  }
  add_references(plot, k_references(model, run), "");
  if (!any) {
    return std::nullopt;
  }
  return Figure{{draw_svg(plot)},
                "",
                "Stress intensity factor K₁ at the ends of the steps over the crack length a." +
                    error_bar_note(plot.series)};
}

std::optional<Figure> normalised_figure(const model::Model& model, const results::RunResult& run) {
  const std::optional<NominalStressState> state = find_nominal_state(model);
  const std::string step = leading_step(model);
  const std::vector<std::string> tips = tip_names(run);
  if (!state || !grows(run, tips, step)) {
    return std::nullopt;
  }
  Plot plot{"Normalised stress intensity factor over crack length", "a / R", "K₁ / (σ √(πa))", {}};
  std::size_t ink = 0;
  for (const Group& group : tip_groups(run, tips, step)) {
    plot.series.push_back(group_series(group, tips.size() > 1, ink, ink));
    ++ink;
  }
  add_references(plot, k_references(model, run), step);
  for (PlotSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      DrawingPoint& p = series.points[i];
      if (i < series.bars.size()) {
        series.bars[i] /= state->k0(p.x);
      }
      p = {p.x / state->radius, p.y / state->k0(p.x)};
    }
  }
  plot.legend_below = true;
  const ReportTable table = normalised_table(*state, k_references(model, run), step);
  Figure figure{
      {draw_svg(plot)},
      "",
      fmt::format(
          "K₁ at the end of step {} over σ √(πa), against a/R; R = {:.6g} {}, σ = {:.4g} {} "
          "(the deck's parameters R and SIGMA).{}",
          step, state->radius, model.units.length_name, state->sigma, model.units.stress_name(),
          table.rows.empty() ? "" : " Marks: values the deck compares with.") +
          error_bar_note(plot.series)};
  if (!table.rows.empty()) {
    figure.drawings.push_back(to_html(table));
  }
  return figure;
}

ReportTable reference_table(const model::Model& model, const results::RunResult& run) {
  const std::string k_unit = model.units.stress_intensity_name();
  ReportTable table{"K1 beside its references",
                    {{"tip", "", true},
                     {"step", "", true},
                     {"a", model.units.length_name, false},
                     {"K1", k_unit, false},
                     {"+-", k_unit, false},
                     {"reference", k_unit, false},
                     {"error", "%", false},
                     {"source", "", true}},
                    {}};
  for (const KReference& r : k_references(model, run)) {
    table.rows.push_back({r.tip, r.step, fmt::format("{:.4g}", r.a), fmt::format("{:.5g}", r.found),
                          r.bar > 0.0 ? format_error_bar(r.bar) : "",
                          fmt::format("{:.5g}", r.wanted), percent(r), r.source});
  }
  return table;
}

double drawn_k1_bar(const results::FrontResult& tip) {
  return tip.has_error_bar() ? tip.tip().bar[0].size() : no_bar;
}

std::vector<const results::Increment*> chosen_increments(const results::RunResult& run,
                                                         std::size_t limit) {
  std::vector<const results::Increment*> chosen;
  const std::size_t count = std::min(limit, run.increments.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count > 1 ? i * (run.increments.size() - 1) / (count - 1) : 0;
    chosen.push_back(&run.increments[at]);
  }
  return chosen;
}

} // namespace spricka::report
