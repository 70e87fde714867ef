// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study.hpp"
#include "program/study/variant_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// How far the answer still moves at the fine end.
double movement(const std::vector<StudyTrial>& trials, const std::vector<std::size_t>& series,
                std::size_t answer) {
  const std::size_t n = series.size();
  double most = n > 1 ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t back = 2; back <= std::min<std::size_t>(n, 3); ++back) {
    most = std::max(most, std::abs(trials[series[n - 1]].readings[answer].of_mesh() -
                                   trials[series[n - back]].readings[answer].of_mesh()));
  }
  return most;
}

AnswerReference reference_of(const AnswerRequest& answer, std::size_t a,
                             const std::vector<StudyTrial>& trials,
                             const std::vector<std::size_t>& series) {
  AnswerReference reference;
  const AnswerReading& finest = trials[series.back()].readings[a];
  const double moved = movement(trials, series, a);
  reference.uncertainty = finest.has_bar() ? finest.bar : moved;
  reference.value = finest.value;
  if (answer.reference && std::isfinite(finest.value)) {
    const double off = std::abs(finest.value - *answer.reference);
    constexpr double round_off = 1e-9;
    if (off <= std::max(reference.uncertainty, round_off * std::abs(*answer.reference))) {
      reference.value = *answer.reference;
      reference.uncertainty = 0.0;
      reference.of_deck = true;
    } else {
      reference.deck_is_off = off / std::abs(*answer.reference);
    }
  }
  return reference;
}

void widen(double& largest, double value) {
  if (std::isfinite(value)) {
    largest = std::isfinite(largest) ? std::max(largest, value) : value;
  }
}

AnswerGroupErrors errors_of(AnswerGroup group, const Study& study, const StudyTrial& trial,
                            bool is_finest) {
  AnswerGroupErrors errors{none, none, none};
  bool all_best = true;
  for (std::size_t a = 0; a < trial.readings.size(); ++a) {
    const AnswerReference& reference = study.references[a];
    if (study.answers[a].group != group || !(reference.scale > 0.0)) {
      continue;
    }
    const AnswerReading& reading = trial.readings[a];
    const bool itself = is_finest && !reference.of_deck;
    if (!itself || reading.has_bar()) { // against its own corrected value
      widen(errors.plain, std::abs(reading.of_mesh() - reference.value) / reference.scale);
    }
    all_best = all_best && reading.has_bar() && !itself;
    widen(errors.best, std::abs(reading.value - reference.value) / reference.scale);
    widen(errors.bar, reading.bar / reference.scale);
  }
  errors.best = all_best ? errors.best : none;
  return errors;
}

// Energy falls with twice the degree of the elements where nothing is singular (Strang and Fix
// 1973, chapter 3). K is a derivative of the energy, whose error is that of the elements at the
// tip: they have sqrt(r) and r of the displacement by quarter points, and lack r^(3/2), of an
// energy proportional to h^3; without quarter points they lack sqrt(r), of an energy proportional
// to h.
std::optional<double> theory_of(AnswerGroup group, SettingFamily family, bool cracked) {
  if (group == AnswerGroup::K) {
    return family == SettingFamily::quarter                                 ? std::optional(1.0)
           : family == SettingFamily::whole || family == SettingFamily::tip ? std::optional(3.0)
                                                                            : std::nullopt;
  }
  const bool smooth = group == AnswerGroup::energy && !cracked;
  return smooth && family == SettingFamily::whole    ? std::optional(4.0)
         : smooth && family == SettingFamily::linear ? std::optional(2.0)
                                                     : std::nullopt;
}

// The deck as it is stands in the series of all sizes.
SettingFamily series_family(const StudyTrial& trial) {
  const SettingFamily family = trial.variant.family;
  return family == SettingFamily::given ? SettingFamily::whole : family;
}

// Of a trial and all finer ones of its family.
double lasting_error(const AnswerGroupVerdict& group, const std::vector<StudyTrial>& trials,
                     std::size_t t, bool corrected) {
  double largest = group.errors[t].plain_or_corrected(corrected);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const bool finer = series_family(trials[i]) == series_family(trials[t]) &&
                       trials[i].variant.fineness > trials[t].variant.fineness;
    if (finer && std::isfinite(group.errors[i].plain_or_corrected(corrected))) {
      largest = std::max(largest, group.errors[i].plain_or_corrected(corrected));
    }
  }
  return largest;
}

// For 1, 0.1 and 0.01 %: the setting of the least CPU (within 15 % of it, of the fewest freedoms)
// whose error, and that of all finer ones of its family, is below it together with what the
// references are uncertain by. CalculiX is not among them.
std::string cheapest_setting(const AnswerGroupVerdict& group, const std::vector<StudyTrial>& trials,
                             double tolerance) {
  std::vector<RankedRunCost> costs; // [2 trial + corrected] plain values before corrected ones
  for (std::size_t i = 0; i < 2 * trials.size(); ++i) {
    const StudyTrial& trial = trials[i / 2];
    const bool own = !trial.readings.empty() && trial.variant.family != SettingFamily::peer &&
                     lasting_error(group, trials, i / 2, i % 2 == 1) + group.floor <= tolerance;
    costs.push_back({own ? trial.end.cpu : std::numeric_limits<double>::infinity(),
                     static_cast<double>(trial.unknowns)});
  }
  const std::string what =
      fmt::format("{} within {:g} %: ", display_name(group.group), 100.0 * tolerance);
  if (const std::optional<std::size_t> best = cheapest_run(costs)) {
    const StudyTrial& trial = trials[*best / 2];
    const bool corrected = *best % 2 == 1;
    return what + fmt::format("{} gives {} for {:.2f} s{}", trial.variant.name,
                              percent(lasting_error(group, trials, *best / 2, corrected)),
                              trial.end.cpu,
                              corrected ? ", with the estimated error taken out" : "");
  }
  return what + (group.floor >= tolerance
                     ? fmt::format("not to be told, the reference is known to {} only",
                                   percent(group.floor))
                     : "none of the settings that were run");
}

class GroupJudge {
public:
  GroupJudge(const Study& study, AnswerGroup group) : study_(study), trials_(study.trials) {
    found_.group = group;
  }

  std::optional<AnswerGroupVerdict> run() {
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      found_.errors.push_back(errors_of(found_.group, study_, trials_[t], t == study_.finest));
    }
    if (std::ranges::none_of(
            found_.errors, [](double plain) { return std::isfinite(plain); },
            &AnswerGroupErrors::plain)) {
      return std::nullopt;
    }
    find_floor();
    for (const SettingFamily family :
         {SettingFamily::whole, SettingFamily::host, SettingFamily::tip, SettingFamily::quarter,
          SettingFamily::linear, SettingFamily::asked, SettingFamily::peer}) {
      judge_series(family, false);
      if (family == SettingFamily::whole || family == SettingFamily::asked) {
        judge_series(family, true);
      }
    }
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      found_.sentences.push_back(cheapest_setting(found_, trials_, tolerance));
    }
    compare_with_peer();
    return std::move(found_);
  }

private:
  void find_floor() {
    for (std::size_t a = 0; a < study_.answers.size(); ++a) {
      const AnswerReference& reference = study_.references[a];
      if (study_.answers[a].group == found_.group && reference.scale > 0.0) {
        own_ = own_ || !reference.of_deck;
        found_.floor = std::max(found_.floor, reference.uncertainty / reference.scale);
      }
    }
  }

  void judge_series(SettingFamily family, bool corrected) {
    const std::vector<std::size_t> rows = find_trials_of_family(trials_, family);
    std::vector<MeshSizeAndError> points;
    for (const std::size_t row : rows) {
      const double error = found_.errors[row].plain_or_corrected(corrected);
      if (std::isfinite(error)) {
        points.push_back({1.0 / trials_[row].variant.fineness, error});
      }
    }
    if (rows.size() < 2 || points.size() < 2 ||
        trials_[rows.front()].variant.fineness == trials_[rows.back()].variant.fineness) {
      return;
    }
    SeriesVerdict series;
    series.family = family;
    series.corrected = corrected;
    series.plateau = find_error_plateau(points);
    if (!corrected) {
      // The energy is singular where some answer is about a crack.
      const bool cracked =
          std::ranges::count(study_.answers, AnswerGroup::K, &AnswerRequest::group) > 0;
      series.theory = theory_of(found_.group, family, cracked);
    }
    // Differences to values of the finest mesh, which has an error of the same law.
    const bool alike = family == SettingFamily::whole || family == SettingFamily::asked;
    const bool to_finest = alike && own_ && !has_bars() && study_.finest;
    const double reference = to_finest ? 1.0 / trials_[*study_.finest].variant.fineness : 0.0;
    const std::size_t falling = series.plateau ? series.plateau->first + 1 : points.size();
    // A corrected value is several times better than its bar (manual, error_bar.md).
    constexpr double better = 0.5;
    series.slope =
        fit_convergence_rate(std::span(points).first(falling),
                             own_ && !to_finest ? better * found_.floor : 0.0, reference);
    if (series.plateau) {
      series.reason = plateau_reason({found_, series, study_}, points);
    }
    found_.series.push_back(std::move(series));
  }

  // Of the finest mesh that CalculiX has an error for; both by the answers that CalculiX has: those
  // of the first step.
  void compare_with_peer() {
    std::optional<std::size_t> peer;
    for (const std::size_t t : find_trials_of_family(trials_, SettingFamily::peer)) {
      if (std::isfinite(found_.errors[t].plain) &&
          (!peer || trials_[t].variant.fineness > trials_[*peer].variant.fineness)) {
        peer = t;
      }
    }
    if (!peer) {
      return;
    }
    const auto same_mesh = std::ranges::find_if(trials_, [&](const StudyTrial& trial) {
      return trial.variant.family != SettingFamily::peer &&
             trial.variant.deck == trials_[*peer].variant.deck;
    });
    StudyTrial own = *same_mesh;
    for (std::size_t a = 0; a < study_.answers.size(); ++a) {
      if (!std::isfinite(trials_[*peer].readings[a].value)) {
        own.readings[a] = AnswerReading();
      }
    }
    const bool is_finest = same_mesh - trials_.begin() ==
                           static_cast<std::ptrdiff_t>(study_.finest.value_or(trials_.size()));
    const double error = errors_of(found_.group, study_, own, is_finest).plain;
    found_.sentences.push_back(fmt::format(
        "{} by CalculiX: {} gives {} for {:.2f} s, the program on the same mesh {} "
        "for {:.2f} s",
        display_name(found_.group), own.variant.name, percent(found_.errors[*peer].plain),
        trials_[*peer].end.cpu,
        std::isfinite(error) ? percent(error) : "what errors are counted from", own.end.cpu));
  }

  [[nodiscard]] bool has_bars() const {
    return study_.finest && std::isfinite(found_.errors[*study_.finest].bar);
  }

  const Study& study_;
  const std::vector<StudyTrial>& trials_;
  AnswerGroupVerdict found_;
  bool own_ = false; ///< some reference is of the finest setting
};

} // namespace

std::vector<std::size_t> find_trials_of_family(const std::vector<StudyTrial>& trials,
                                               SettingFamily family) {
  constexpr std::array of_sizes{SettingFamily::whole, SettingFamily::host, SettingFamily::tip,
                                SettingFamily::asked};
  const bool given = std::ranges::find(of_sizes, family) != of_sizes.end();
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const SettingFamily own = trials[i].variant.family;
    if (!trials[i].readings.empty() && (own == family || (given && own == SettingFamily::given))) {
      rows.push_back(i);
    }
  }
  std::ranges::stable_sort(rows, {}, [&](std::size_t i) { return trials[i].variant.fineness; });
  return rows;
}

void assess_trials(Study& study) {
  std::vector<std::size_t> series = find_trials_of_family(study.trials, SettingFamily::whole);
  if (series.size() < 2) {
    series = find_trials_of_family(study.trials, SettingFamily::asked);
  }
  if (series.empty()) {
    return;
  }
  study.finest = series.back();
  std::vector<double> values;
  for (std::size_t a = 0; a < study.answers.size(); ++a) {
    study.references.push_back(reference_of(study.answers[a], a, study.trials, series));
    values.push_back(study.references.back().value);
  }
  const std::vector<double> scales = answer_scales(study.answers, values);
  for (std::size_t a = 0; a < scales.size(); ++a) {
    study.references[a].scale = scales[a];
  }
  for (int g = 0; g <= static_cast<int>(AnswerGroup::other); ++g) {
    if (auto group = GroupJudge(study, static_cast<AnswerGroup>(g)).run()) {
      study.groups.push_back(std::move(*group));
    }
  }
}

} // namespace spricka::program
