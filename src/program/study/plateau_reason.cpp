// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study.hpp"
#include "program/study/variant_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The error on the finest setting of the series of all sizes.
double least_of_whole(const PlateauContext& view) {
  double error = std::numeric_limits<double>::infinity();
  for (const std::size_t t : find_trials_of_family(view.study.trials, SettingFamily::whole)) {
    const bool own = view.study.trials[t].variant.family == SettingFamily::whole;
    error = own && std::isfinite(view.group.errors[t].plain) ? view.group.errors[t].plain : error;
  }
  return error;
}

/// What the answers of the group say of a plateau.
struct PlateauAnswers {
  /// How far the deck's references lie from what the finest setting has, its error taken out where
  /// it can be: their own uncertainty, if the plateau is as high.
  double distance = 0.0;
  double movement = 0.0; ///< how far answers still move between the last two points
  double worst_error = 0.0;
  std::optional<std::size_t> worst; ///< the largest error on the finest setting of the series
};

PlateauAnswers assess_answers(const PlateauContext& view) {
  const std::vector<StudyTrial>& trials = view.study.trials;
  const std::vector<std::size_t> rows = find_trials_of_family(trials, view.series.family);
  std::optional<std::size_t> own_finest;
  for (const std::size_t t : rows) {
    own_finest = trials[t].variant.family == view.series.family ? t : own_finest;
  }
  PlateauAnswers found;
  for (std::size_t a = 0; a < view.study.answers.size(); ++a) {
    const AnswerReference& reference = view.study.references[a];
    if (view.study.answers[a].group != view.group.group || !(reference.scale > 0.0)) {
      continue;
    }
    if (reference.of_deck) {
      const AnswerReading& reading = trials[*view.study.finest].readings[a];
      found.distance =
          std::max(found.distance, std::abs(reading.value - reference.value) / reference.scale);
    }
    if (rows.size() > 1) {
      const AnswerReading& last = trials[rows.back()].readings[a];
      const AnswerReading& before = trials[rows[rows.size() - 2]].readings[a];
      const double moved =
          view.series.corrected ? last.value - before.value : last.of_mesh() - before.of_mesh();
      found.movement = std::max(found.movement, std::abs(moved) / reference.scale);
    }
    const double error =
        own_finest ? std::abs(trials[*own_finest].readings[a].of_mesh() - reference.value) /
                         reference.scale
                   : 0.0;
    if (error > found.worst_error) {
      found.worst_error = error;
      found.worst = a;
    }
  }
  return found;
}

// What the answer with the largest error is known for.
std::string reason_of_answer(const AnswerRequest& answer) {
  const std::string& quantity = answer.check.quantity;
  if (quantity.ends_with(".MAX") || quantity.ends_with(".MIN") || quantity.ends_with(".NEAR") ||
      quantity.starts_with("ARC")) {
    return answer.text + " is the value of a single node, or has no bound where a contact ends";
  }
  if (quantity.starts_with("S.") && quantity.ends_with(".AT")) {
    return answer.text + " goes up and down with where in its element the point lies";
  }
  return "no cause found; the largest error is that of " + answer.text;
}

// What stays as it is in a family alone; empty: nothing does.
const char* unchanged_part(SettingFamily family) {
  switch (family) {
  case SettingFamily::peer:
    return "CalculiX; the program goes below it on the same meshes";
  case SettingFamily::host:
    return "the nets of the tips follow in part only, or not at all";
  case SettingFamily::tip:
    return "the meshes of the bodies stay as they are";
  default:
    return "";
  }
}

} // namespace

std::string plateau_reason(const PlateauContext& view, std::span<const MeshSizeAndError> points) {
  const double level = view.series.plateau->level;
  if (view.series.family == SettingFamily::quarter) {
    return "quarter points are missing";
  }
  constexpr double format_six_digits = 3e-6;
  if (view.series.family == SettingFamily::peer && level < format_six_digits) {
    return "CalculiX writes six digits";
  }
  std::string unchanged = unchanged_part(view.series.family);
  if (!unchanged.empty() && least_of_whole(view) < 0.6 * level) {
    return unchanged;
  }
  if (level <= 2.0 * view.group.floor) {
    return fmt::format(
        "the reference is known to {} only (bar or last change of the finest setting)",
        percent(view.group.floor));
  }
  const PlateauAnswers answers = assess_answers(view);
  if (answers.movement < 0.5 * level && answers.distance > 0.5 * points.back().error) {
    return fmt::format("the reference's own uncertainty: finer meshes change by {} only and end "
                       "{} from it",
                       percent(answers.movement), percent(answers.distance));
  }
  // What stops all sizes together stops each of them.
  const auto whole = std::ranges::find_if(view.group.series, [](const SeriesVerdict& series) {
    return series.family == SettingFamily::whole && !series.corrected && series.plateau;
  });
  if (whole != view.group.series.end() && whole->plateau->level > 0.7 * level) {
    return "as of all sizes";
  }
  return answers.worst ? reason_of_answer(view.study.answers[*answers.worst]) : "no cause found";
}

} // namespace spricka::program
