// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/variant_report.hpp"
#include "program/study/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace spricka::program {

namespace {

/// A setting that could be chosen.
struct CheapestCandidate {
  std::size_t trial = 0;
  bool corrected = false;
  double error = 0.0;
};

// The deck as it is stands in the series of all sizes.
SettingFamily series_family(SettingFamily family) {
  return family == SettingFamily::given ? SettingFamily::whole : family;
}

double lasting_error(const GroupVerdict& group, const std::vector<Trial>& trials, std::size_t t,
                     bool corrected) {
  const auto own = [&](std::size_t i) {
    return corrected ? group.errors[i].best : group.errors[i].plain;
  };
  double largest = own(t);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const bool finer =
        series_family(trials[i].setting.family) == series_family(trials[t].setting.family) &&
        trials[i].setting.fineness > trials[t].setting.fineness;
    if (finer && std::isfinite(own(i))) {
      largest = std::max(largest, own(i));
    }
  }
  return largest;
}

std::vector<CheapestCandidate> candidates_of(const GroupVerdict& group,
                                             const std::vector<Trial>& trials) {
  std::vector<CheapestCandidate> all;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].readings.empty() || trials[t].setting.family == SettingFamily::peer) {
      continue;
    }
    for (const bool corrected : {false, true}) {
      const double error = lasting_error(group, trials, t, corrected);
      if (std::isfinite(error)) {
        all.push_back({t, corrected, error});
      }
    }
  }
  std::ranges::stable_sort(all, [&](const CheapestCandidate& a, const CheapestCandidate& b) {
    return trials[a.trial].end.cpu < trials[b.trial].end.cpu;
  });
  return all;
}

// By CPU; what differs by less than a clock can tell is chosen by freedoms, and plain values before
// corrected ones.
const CheapestCandidate* choose(const std::vector<CheapestCandidate>& all, double floor,
                                double tolerance, const std::vector<Trial>& trials) {
  constexpr double alike = 1.15; // CPU of one and the same run differs so much
  const CheapestCandidate* best = nullptr;
  double least = 0.0;
  for (const CheapestCandidate& candidate : all) {
    if (!(candidate.error + floor <= tolerance)) {
      continue;
    }
    const Trial& trial = trials[candidate.trial];
    least = best == nullptr ? trial.end.cpu : least; // they come in this order
    const bool fewer = best != nullptr && trial.unknowns < trials[best->trial].unknowns;
    if (best == nullptr || (fewer && trial.end.cpu <= alike * least)) {
      best = &candidate;
    }
  }
  return best;
}

std::string cheapest_sentence(const GroupVerdict& group, const std::vector<Trial>& trials,
                              const CheapestSetting& found) {
  const char* const what = display_name(group.group);
  if (found.trial) {
    const Trial& trial = trials[*found.trial];
    return fmt::format("{} within {:g} %: {} gives {} for {:.2f} s{}", what,
                       100.0 * found.tolerance, trial.setting.name, percent(found.error),
                       trial.end.cpu,
                       found.corrected ? ", with the estimated error taken out" : "");
  }
  if (group.floor >= found.tolerance) {
    return fmt::format("{} within {:g} %: not to be told, the reference is known to {} only", what,
                       100.0 * found.tolerance, percent(group.floor));
  }
  return fmt::format("{} within {:g} %: none of the settings that were run", what,
                     100.0 * found.tolerance);
}

} // namespace

std::vector<CheapestSetting> cheapest_settings(const GroupVerdict& group,
                                               const std::vector<Trial>& trials) {
  const std::vector<CheapestCandidate> all = candidates_of(group, trials);
  std::vector<CheapestSetting> found;
  for (const double tolerance : std::array{1e-2, 1e-3, 1e-4}) {
    CheapestSetting cheapest{tolerance, std::nullopt, false, 0.0, {}};
    if (const CheapestCandidate* best = choose(all, group.floor, tolerance, trials)) {
      cheapest.trial = best->trial;
      cheapest.corrected = best->corrected;
      cheapest.error = best->error;
    }
    cheapest.words = cheapest_sentence(group, trials, cheapest);
    found.push_back(std::move(cheapest));
  }
  return found;
}

} // namespace spricka::program
