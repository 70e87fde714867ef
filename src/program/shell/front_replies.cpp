// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/front_replies.hpp"

#include "base/quantity.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/front_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using results::FrontPointResult;
using results::FrontResult;

/// The points with the smallest and the largest K1, those at the surface left out: K there is a
/// number of the mesh.
std::pair<const FrontPointResult*, const FrontPointResult*> extremes(const FrontResult& front) {
  const FrontPointResult* least = nullptr;
  const FrontPointResult* most = nullptr;
  for (const FrontPointResult& place : front.points) {
    if (place.at_surface && front.points.size() > 2) {
      continue;
    }
    if (least == nullptr || place.K1 < least->K1) {
      least = &place;
    }
    if (most == nullptr || place.K1 > most->K1) {
      most = &place;
    }
  }
  return {least, most};
}

// The present state as an increment of its own, with these fronts and nothing else.
results::Increment fronts_alone(const ShellSession& session, const std::string& only) {
  results::Increment alone;
  results::StepResult& step = alone.steps.emplace_back();
  step.step = "NOW";
  for (const FrontResult& front : session.current_result().fronts) {
    if (is_of_crack(front.name, only)) {
      step.fronts.push_back(front);
    }
  }
  return alone;
}

std::string summary(const ShellSession& session) {
  const base::UnitSystem& units = session.model().units;
  const std::string K = units.stress_intensity_name();
  report::ReportTable table{"",
                            {{"front", "", true},
                             {"K1", "", true},
                             {"point", "", false},
                             {"x", units.length_name, false},
                             {"y", units.length_name, false},
                             {"z", units.length_name, false}},
                            {}};
  for (const char* name : {"K1", "K2", "K3"}) {
    table.columns.push_back({name, K, false});
    table.columns.push_back({"+-", K, false});
  }
  for (const FrontResult& front : session.current_result().fronts) {
    const auto [least, most] = extremes(front);
    for (const auto& [what, place] : {std::pair("smallest", least), std::pair("largest", most)}) {
      if (place == nullptr) {
        continue;
      }
      std::vector<std::string> row{front.name, what, std::to_string(place->number)};
      for (const double x : place->x) {
        row.push_back(fmt::format("{:.6g}", std::abs(x) < 1e-12 * front.length ? 0.0 : x));
      }
      const std::array<double, 3> of{place->K1, place->K2, place->K3};
      for (std::size_t mode = 0; mode < of.size(); ++mode) {
        row.push_back(fmt::format("{:.7g}", of[mode]));
        row.push_back(results::has_error_bar(front) ? fmt::format("{:.2g}", place->bar[mode].size())
                                                    : std::string("-"));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return report::to_text(table);
}

} // namespace

std::string front_reply(const ShellSession& session, const std::string& only) {
  if (only.empty()) {
    return summary(session);
  }
  std::string text;
  const std::vector<report::ReportTable> tables =
      report::front_tables(session.displayed_model(), fronts_alone(session, only));
  for (const report::ReportTable& table : tables) {
    text += report::to_text(tables.size() == 1 ? report::untitled(table) : table);
  }
  return text;
}

std::string front_k_concerns(const ShellSession& session) {
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    if (!front.invalid_reason.empty()) {
      text += fmt::format("warning: {}: {}\n", front.name, front.invalid_reason);
    }
  }
  return text;
}

std::string front_notes(const ShellSession& session, const std::string& only) {
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    if (!is_of_crack(front.name, only)) {
      continue;
    }
    if (!front.invalid_reason.empty()) {
      text += fmt::format("warning: {}: {}\n", front.name, front.invalid_reason);
    }
    const auto closed = std::ranges::count_if(front.points, &FrontPointResult::closed);
    if (closed > 0) {
      text += fmt::format("note: {}: the crack's faces touch at {} of {} points, K1 is 0 there\n",
                          front.name, closed, front.points.size());
    }
    if (!front.no_bar.empty()) {
      text += fmt::format("note: {}: no error bar: {}\n", front.name, front.no_bar);
    }
  }
  return text;
}

std::string fronts_state(const ShellSession& session) {
  const std::string K = session.model().units.stress_intensity_name();
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    const auto [least, most] = extremes(front);
    if (least != nullptr) {
      text += fmt::format("{:<12} a = {:<10.6g} K1 = {:.7g} .. {:.7g} {}\n", front.name, front.a,
                          least->K1, most->K1, K);
    }
  }
  return text;
}

std::vector<MappedFrontPoint> mapped_points(const results::LoadPathResult& path) {
  std::vector<MappedFrontPoint> out;
  if (path.t.empty()) {
    return out;
  }
  for (const results::LoadPathFront& front : path.fronts) {
    const FrontResult at_end = front.at(path.t.back());
    const auto [least, most] = extremes(at_end);
    std::vector<int> numbers;
    for (const FrontPointResult* place : {least, most}) {
      if (place != nullptr && std::ranges::find(numbers, place->number) == numbers.end()) {
        numbers.push_back(place->number);
      }
    }
    for (const results::LoadPathFrontPoint& point : front.points) {
      if (std::ranges::find(numbers, point.is.number) != numbers.end()) {
        out.push_back({fmt::format("{} point {}", front.is.name, point.is.number), &point.K[0]});
      }
    }
  }
  return out;
}

} // namespace spricka::program
