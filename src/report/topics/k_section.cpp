// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/k_section.hpp"

#include "base/by_dimension.hpp"
#include "model/model.hpp"
#include "report/topics/front_section.hpp"
#include "report/topics/k_tables.hpp"
#include "report/topics/result_rows.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace spricka::report {
namespace {

using NameTable = std::vector<std::string>;

constexpr std::size_t most_rows = 80; // of all steps' tables: more nobody reads

double size_of(const results::FrontResult& front) {
  return largest_K(front) + (front.two_materials ? std::abs(front.single_point().G) : 0.0);
}

/// Steps in order, with the largest K of each.
std::vector<std::pair<std::string, double>> largest_of_steps(const results::RunResult& run) {
  std::vector<std::pair<std::string, double>> steps;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      auto at = std::ranges::find(steps, step.step, &std::pair<std::string, double>::first);
      if (at == steps.end()) {
        at = steps.insert(at, {step.step, 0.0});
      }
      for (const results::FrontResult& front : step.fronts) {
        at->second = std::max(at->second, size_of(front));
      }
    }
  }
  return steps;
}

/// "2, 3, 4, 7" as "2 to 4, 7".
std::string ranges_of(const std::set<int>& numbers) {
  std::string text;
  for (auto at = numbers.begin(); at != numbers.end();) {
    const int first = *at;
    int last = first;
    while (++at != numbers.end() && *at == last + 1) {
      last = *at;
    }
    text += text.empty() ? "" : ", ";
    text += first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
  }
  return text;
}

/// Results for K: all that there are, to say "everywhere" where it is so, or some of them.
struct KResultExtent {
  std::set<int> increments;
  NameTable steps;
  NameTable ends; ///< tips
  std::size_t count = 0;

  void add(const FrontRow& row) {
    increments.insert(row.increment.number);
    add_unique(steps, row.step.step);
    add_unique(ends, row.front.name);
    ++count;
  }
};

/// Where K has no bar for one reason.
struct MissingBarReason {
  std::string why;
  KResultExtent where;
};

std::string place_of(const KResultExtent& gap, const KResultExtent& all) {
  NameTable parts;
  if (gap.increments != all.increments) {
    parts.push_back(fmt::format("increment{} {}", gap.increments.size() > 1 ? "s" : "",
                                ranges_of(gap.increments)));
  }
  if (gap.steps.size() != all.steps.size()) {
    parts.push_back(
        fmt::format("step{} {}", gap.steps.size() > 1 ? "s" : "", fmt::join(gap.steps, ", ")));
  }
  if (gap.ends.size() != all.ends.size()) {
    parts.push_back(
        fmt::format("tip{} {}", gap.ends.size() > 1 ? "s" : "", fmt::join(gap.ends, ", ")));
  }
  if (parts.empty()) {
    return gap.count == all.count ? "for any K here" : "for some K here";
  }
  // not a block of the table: of each of these some
  const bool whole = gap.count == gap.increments.size() * gap.steps.size() * gap.ends.size();
  return fmt::format("{}for {}", whole ? "" : "in part ", fmt::join(parts, ", "));
}

std::string words_of(const std::string& why) {
  return why == results::FrontResult().missing_bar_reason
             ? "it was not computed (a life with CORRECT=NO has error bars at its first length "
               "only, unless the deck asks for more by $CHECK or TOL on $TIPNET)"
             : why;
}

NameTable others_than(const std::string& name, NameTable names) {
  std::erase(names, name);
  return names;
}

std::size_t rows_of(const std::vector<ReportTable>& tables) {
  std::size_t rows = 0;
  for (const ReportTable& table : tables) {
    rows += table.rows.size();
  }
  return rows;
}

KReportSection front_section(const model::Model& model, const results::RunResult& run) {
  KReportSection section;
  if (!run.increments.empty()) {
    section.pictures = k_along_front_figures(model, run);
    section.tables = front_place_tables(model, run.increments.back());
    section.folded = front_tables(model, run.increments.back());
    for (ReportTable& table : section.folded) {
      table.title += ": every point";
    }
    if (!section.tables.empty()) {
      section.remarks.push_back("At the ends of a front K is what the points within go on to, with "
                                "the bar of the next one. All points are in k.csv.");
    }
  }
  return section;
}

KReportSection tip_section(const model::Model& model, const results::RunResult& run) {
  KReportSection section;
  const auto steps = largest_of_steps(run);
  const std::string leading = results::shown_step_name(model, run.increments);
  double largest = 0.0;
  for (const auto& [step, size] : steps) {
    largest = std::max(largest, size);
  }
  NameTable shown;
  NameTable nothing;
  for (const auto& [step, size] : steps) {
    add_unique(step == leading || size > 1e-9 * largest ? shown : nothing, step);
  }
  if (run.increments.size() == 1) {
    shown.insert(shown.end(), nothing.begin(), nothing.end());
    for (const KTableExtent extent : {KTableExtent::brief, KTableExtent::full}) {
      ReportTable table = tip_k_table(model, run.increments.front(), extent);
      table.title = "Stress intensity factors at the ends of the steps";
      (extent == KTableExtent::brief ? section.tables : section.folded).push_back(std::move(table));
    }
  } else {
    std::stable_partition(shown.begin(), shown.end(),
                          [&](const std::string& s) { return s == leading; });
    for (const std::string& step : shown) {
      section.tables.push_back(tip_k_table_over_increments(model, run, step, KTableExtent::brief));
    }
    if (rows_of(section.tables) > most_rows && shown.size() > 1) {
      section.tables = {tip_k_table_over_increments(model, run, leading, KTableExtent::brief)};
      section.remarks.push_back(
          fmt::format("K at the ends of the other steps ({}) is in k.csv and in the listing.",
                      fmt::join(others_than(leading, shown), ", ")));
      shown = {leading};
    }
    for (const std::string& step : shown) {
      section.folded.push_back(tip_k_table_over_increments(model, run, step, KTableExtent::full));
    }
    if (!nothing.empty()) {
      section.remarks.push_back(fmt::format("K is 0 at the end of {}.", fmt::join(nothing, ", ")));
    }
  }
  std::erase_if(section.tables, [](const ReportTable& table) { return table.rows.empty(); });
  for (ReportTable& table : section.folded) {
    table.title += ": raw K, G, T";
  }
  for (std::string& words : missing_error_bar_reasons(run, shown)) {
    section.remarks.push_back(std::move(words));
  }
  add_figure(section.curves, k_over_crack_length_figure(model, run));
  add_figure(section.curves, normalised_k_figure(model, run));
  return section;
}

} // namespace

std::vector<std::string> missing_error_bar_reasons(const results::RunResult& run,
                                                   const NameTable& steps) {
  std::vector<MissingBarReason> gaps;
  KResultExtent all;
  for (const FrontRow& row : front_rows(run.increments)) {
    const results::FrontResult& front = row.front;
    if (front.two_materials || std::ranges::find(steps, row.step.step) == steps.end()) {
      continue; // it has no K
    }
    all.add(row);
    if (front.has_error_bar()) {
      continue;
    }
    auto gap = std::ranges::find(gaps, front.missing_bar_reason, &MissingBarReason::why);
    if (gap == gaps.end()) {
      gap = gaps.insert(gap, MissingBarReason{front.missing_bar_reason, {}});
    }
    gap->where.add(row);
  }
  std::vector<std::string> words;
  words.reserve(gaps.size());
  for (const MissingBarReason& gap : gaps) {
    words.push_back(
        fmt::format("No error bar {}: {}.", place_of(gap.where, all), words_of(gap.why)));
  }
  return words;
}

KReportSection make_k_report_section(const model::Model& model, const results::RunResult& run) {
  constexpr base::ByDimension sections{tip_section, front_section};
  return sections.at(model.mesh.dim)(model, run);
}

} // namespace spricka::report
