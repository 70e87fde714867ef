// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_report.hpp"
#include "program/study/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The deck as it is stands in the series of all sizes.
SettingFamily series_family(const StudyTrial& trial) {
  const SettingFamily family = trial.setting.family;
  return family == SettingFamily::given ? SettingFamily::whole : family;
}

// Of a trial and all finer ones of its family.
double lasting_error(const AnswerGroupVerdict& group, const std::vector<StudyTrial>& trials,
                     std::size_t t, bool corrected) {
  double largest = group.errors[t].of(corrected);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const bool finer = series_family(trials[i]) == series_family(trials[t]) &&
                       trials[i].setting.fineness > trials[t].setting.fineness;
    if (finer && std::isfinite(group.errors[i].of(corrected))) {
      largest = std::max(largest, group.errors[i].of(corrected));
    }
  }
  return largest;
}

std::string cheapest_sentence(const AnswerGroupVerdict& group,
                              const std::vector<StudyTrial>& trials, const CheapestSetting& found) {
  const std::string what =
      fmt::format("{} within {:g} %: ", display_name(group.group), 100.0 * found.tolerance);
  if (found.trial) {
    const StudyTrial& trial = trials[*found.trial];
    return what + fmt::format("{} gives {} for {:.2f} s{}", trial.setting.name,
                              percent(found.error), trial.end.cpu,
                              found.corrected ? ", with the estimated error taken out" : "");
  }
  return what + (group.floor >= found.tolerance
                     ? fmt::format("not to be told, the reference is known to {} only",
                                   percent(group.floor))
                     : "none of the settings that were run");
}

} // namespace

std::vector<CheapestSetting> cheapest_settings(const AnswerGroupVerdict& group,
                                               const std::vector<StudyTrial>& trials) {
  std::vector<CheapestSetting> found;
  for (const double tolerance : std::array{1e-2, 1e-3, 1e-4}) {
    std::vector<RunCost> costs; // [2 trial + corrected] plain values before corrected ones
    for (std::size_t i = 0; i < 2 * trials.size(); ++i) {
      const StudyTrial& trial = trials[i / 2];
      const bool own = !trial.readings.empty() && trial.setting.family != SettingFamily::peer &&
                       lasting_error(group, trials, i / 2, i % 2 == 1) + group.floor <= tolerance;
      costs.push_back({own ? trial.end.cpu : std::numeric_limits<double>::infinity(),
                       static_cast<double>(trial.unknowns)});
    }
    CheapestSetting& cheapest = found.emplace_back();
    cheapest.tolerance = tolerance;
    if (const std::optional<std::size_t> best = cheapest_run(costs)) {
      cheapest.trial = *best / 2;
      cheapest.corrected = *best % 2 == 1;
      cheapest.error = lasting_error(group, trials, *best / 2, cheapest.corrected);
    }
    cheapest.words = cheapest_sentence(group, trials, cheapest);
  }
  return found;
}

} // namespace spricka::program
