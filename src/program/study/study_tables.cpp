// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/study_tables.hpp"

#include "program/study/cheapest.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Percent as a bare number, two digits.
std::string in_percent(double part) {
  return std::isfinite(part) ? fmt::format("{:.2g}", 100.0 * part) : "-";
}

std::string slope_words(const SeriesVerdict& series) {
  return series.slope ? fmt::format("{:.2f}", series.slope->power) : "-";
}

} // namespace

report::ReportTable settings_table(const Study& study) {
  report::ReportTable table{"Settings",
                            {{"setting", "", true},
                             {"freedoms", "", false},
                             {"CPU", "s", false},
                             {"memory", "MiB", false}},
                            {}};
  for (const GroupVerdict& group : study.verdict.groups) {
    const std::string name = display_name(group.group);
    table.columns.push_back({name + " error", "%", false});
    if (group.group == AnswerGroup::K) {
      table.columns.push_back({"corrected", "%", false});
      table.columns.push_back({"bar", "%", false});
    }
  }
  table.columns.push_back({"", "", true});
  for (std::size_t t = 0; t < study.trials.size(); ++t) {
    const Trial& trial = study.trials[t];
    std::vector<std::string> row{
        trial.setting.name, trial.unknowns > 0 ? fmt::format("{}", trial.unknowns) : "-",
        fmt::format("{:.2f}", trial.end.cpu),
        fmt::format("{:.0f}", static_cast<double>(trial.end.peak_memory) / 1048576.0)};
    for (const GroupVerdict& group : study.verdict.groups) {
      row.push_back(in_percent(group.errors[t].plain));
      if (group.group == AnswerGroup::K) {
        row.push_back(in_percent(group.errors[t].best));
        row.push_back(in_percent(group.errors[t].bar));
      }
    }
    row.push_back(trial.trouble);
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::ReportTable series_table(const Study& study) {
  report::ReportTable table{"Slopes and plateaus",
                            {{"answers", "", true},
                             {"series", "", true},
                             {"power", "", false},
                             {"theory", "", false},
                             {"plateau", "", false},
                             {"why", "", true}},
                            {}};
  for (const GroupVerdict& group : study.verdict.groups) {
    for (const SeriesVerdict& series : group.series) {
      table.rows.push_back(
          {display_name(group.group),
           fmt::format("{}{}", display_name(series.family), series.corrected ? ", corrected" : ""),
           slope_words(series), series.theory ? fmt::format("{:g}", *series.theory) : "",
           series.plateau ? percent(series.plateau->level) : "", series.reason});
    }
  }
  return table;
}

report::ReportTable distrusted_table(const Study& study) {
  report::ReportTable table{"References of the deck that finer meshes do not go to",
                            {{"check", "", true},
                             {"off by", "%", false},
                             {"finest is sure to", "%", false},
                             {"source", "", true}},
                            {}};
  std::map<std::string, std::size_t> worst; // by source
  for (std::size_t a = 0; a < study.verdict.references.size(); ++a) {
    const double off = study.verdict.references[a].deck_is_off;
    const auto [found, fresh] = worst.emplace(study.answers[a].check.source, a);
    if (!fresh && off > study.verdict.references[found->second].deck_is_off) {
      found->second = a;
    }
  }
  for (const auto& [source, a] : worst) {
    const AnswerReference& reference = study.verdict.references[a];
    if (reference.deck_is_off > 0.0 && reference.scale > 0.0) {
      table.rows.push_back({study.answers[a].text, in_percent(reference.deck_is_off),
                            in_percent(reference.uncertainty / reference.scale), source});
    }
  }
  return table;
}

} // namespace spricka::program
