// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_report.hpp"
#include "program/study/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The trial of the finest setting of a family that `wanted` holds for.
template <class Wanted>
std::optional<std::size_t> finest_of(const PlateauContext& view, SettingFamily family,
                                     const Wanted& wanted) {
  std::optional<std::size_t> finest;
  for (const std::size_t t : series_rows(view.study.trials, family)) {
    finest = view.study.trials[t].setting.family == family && wanted(t) ? t : finest;
  }
  return finest;
}

// The error on the finest setting of the series of all sizes.
double least_of_whole(const PlateauContext& view) {
  const auto finest = finest_of(view, SettingFamily::whole, [&](std::size_t t) {
    return std::isfinite(view.group.errors[t].plain);
  });
  return finest ? view.group.errors[*finest].plain : std::numeric_limits<double>::infinity();
}

bool is_own(const PlateauContext& view, std::size_t answer) {
  return view.study.answers[answer].group == view.group.group &&
         view.study.verdict.references[answer].scale > 0.0;
}

// How far the deck's references lie from what the finest setting has, its error taken out where it
// can be: their own uncertainty, if the plateau is as high.
double reference_distance(const PlateauContext& view) {
  double largest = 0.0;
  const Trial& finest = view.study.trials[*view.study.verdict.finest];
  for (std::size_t a = 0; a < view.study.answers.size(); ++a) {
    const AnswerReference& reference = view.study.verdict.references[a];
    if (is_own(view, a) && reference.of_deck) {
      const AnswerReading& reading = finest.readings[a];
      const double limit = std::isfinite(reading.best) ? reading.best : reading.value;
      largest = std::max(largest, std::abs(limit - reference.value) / reference.scale);
    }
  }
  return largest;
}

// How far all answers still move between the last two points of the plateau.
double movement_of(const PlateauContext& view) {
  const std::vector<std::size_t> rows = series_rows(view.study.trials, view.series.family);
  double largest = 0.0;
  for (std::size_t a = 0; a < view.study.answers.size() && rows.size() > 1; ++a) {
    if (is_own(view, a)) {
      const AnswerReading& last = view.study.trials[rows.back()].readings[a];
      const AnswerReading& before = view.study.trials[rows[rows.size() - 2]].readings[a];
      const bool best = view.series.corrected && std::isfinite(last.best);
      const double moved = best ? last.best - before.best : last.value - before.value;
      largest = std::max(largest, std::abs(moved) / view.study.verdict.references[a].scale);
    }
  }
  return largest;
}

// The answer with the largest error on the finest setting of the series.
std::optional<std::size_t> worst_answer(const PlateauContext& view) {
  const auto finest = finest_of(view, view.series.family, [](std::size_t) { return true; });
  std::optional<std::size_t> worst;
  double largest = 0.0;
  for (std::size_t a = 0; a < view.study.answers.size() && finest; ++a) {
    const AnswerReference& reference = view.study.verdict.references[a];
    const double error =
        std::abs(view.study.trials[*finest].readings[a].value - reference.value) / reference.scale;
    if (is_own(view, a) && error > largest) {
      largest = error;
      worst = a;
    }
  }
  return worst;
}

bool is_at_node(const std::string& quantity) {
  return quantity.ends_with(".MAX") || quantity.ends_with(".MIN") || quantity.ends_with(".NEAR") ||
         quantity.starts_with("ARC");
}

} // namespace

std::string plateau_reason(const PlateauContext& view, std::span<const ConvergencePoint> points) {
  const double level = view.series.plateau->level;
  if (view.series.family == SettingFamily::quarter) {
    return "quarter points are missing";
  }
  constexpr double six_digits = 3e-6;
  if (view.series.family == SettingFamily::peer && level < six_digits) {
    return "CalculiX writes six digits";
  }
  if (view.series.family == SettingFamily::peer && least_of_whole(view) < 0.6 * level) {
    return "CalculiX; the program goes below it on the same meshes";
  }
  if (view.series.family == SettingFamily::host && least_of_whole(view) < 0.6 * level) {
    return "the nets of the tips stay as they are";
  }
  if (view.series.family == SettingFamily::tip && least_of_whole(view) < 0.6 * level) {
    return "the meshes of the bodies stay as they are";
  }
  if (level <= 2.0 * view.group.floor) {
    return fmt::format(
        "the reference is known to {} only (bar or last change of the finest setting)",
        percent(view.group.floor));
  }
  const double still = movement_of(view);
  const double distance = reference_distance(view);
  if (still < 0.5 * level && distance > 0.5 * points.back().error) {
    return fmt::format("the reference's own uncertainty: finer meshes change by {} only and end "
                       "{} from it",
                       percent(still), percent(distance));
  }
  // What stops all sizes together stops each of them.
  const auto whole = std::ranges::find_if(view.group.series, [](const SeriesVerdict& series) {
    return series.family == SettingFamily::whole && !series.corrected && series.plateau;
  });
  if (whole != view.group.series.end() && whole->plateau->level > 0.7 * level) {
    return "as of all sizes";
  }
  if (const auto worst = worst_answer(view)) {
    const std::string& quantity = view.study.answers[*worst].check.quantity;
    if (is_at_node(quantity)) {
      return fmt::format("{} is the value of a single node, or has no bound where a contact ends",
                         view.study.answers[*worst].text);
    }
    if (quantity.starts_with("S.") && quantity.ends_with(".AT")) {
      return fmt::format("{} goes up and down with where in its element the point lies",
                         view.study.answers[*worst].text);
    }
    return fmt::format("no cause found; the largest error is that of {}",
                       view.study.answers[*worst].text);
  }
  return "no cause found";
}

} // namespace spricka::program
