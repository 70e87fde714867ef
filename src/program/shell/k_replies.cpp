// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/k_replies.hpp"

#include "base/quantity.hpp"
#include "model/model.hpp"
#include "program/shell/known_names.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/front_section.hpp"
#include "results/k_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using report::ReportTable;
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

bool are_tips(const std::vector<FrontResult>& fronts) {
  return std::ranges::all_of(fronts, &FrontResult::is_tip);
}

// In space all points of the fronts.
std::string points_reply(const ShellSession& session, const std::string& only) {
  std::string text;
  const std::vector<ReportTable> tables =
      report::front_tables(session.displayed_model(), fronts_alone(session, only));
  for (const ReportTable& table : tables) {
    text += report::to_text(tables.size() == 1 ? report::untitled(table) : table);
  }
  return text;
}

ReportTable empty_k_table(const base::UnitSystem& units, bool tips) {
  const std::string& length = units.length_name;
  ReportTable table{"", {{tips ? "tip" : "front", "", true}}, {}};
  if (!tips) {
    table.columns.insert(table.columns.end(), {{"K1", "", true},
                                               {"point", "", false},
                                               {"x", length, false},
                                               {"y", length, false},
                                               {"z", length, false}});
  }
  for (const results::KQuantity& q : results::k_quantities) {
    if (!q.appears_in(results::in_shell, tips ? 2 : 3)) {
      continue;
    }
    table.columns.push_back({q.name, base::unit_name(units, q.kind), false});
    if (q.is_k()) {
      table.columns.push_back({"+-", base::unit_name(units, q.kind), false});
    }
  }
  return table;
}

// A row of it; `named`: what tells the point.
std::vector<std::string> k_row(std::vector<std::string> named, const FrontResult& front,
                               const FrontPointResult& point) {
  std::vector<std::string> row = std::move(named);
  for (const results::KQuantity& q : results::k_quantities) {
    if (!q.appears_in(results::in_shell, front.is_tip() ? 2 : 3)) {
      continue;
    }
    const bool given = q.is_given(front);
    row.push_back(given ? fmt::format("{:.{}g}", q.extract_value(front, point), q.shell_digits)
                        : "");
    if (q.is_k() && given) {
      const results::KErrorBar& bar = point.bar[static_cast<std::size_t>(q.mode)];
      row.push_back(front.has_error_bar() ? fmt::format("{:.2g}", bar.size()) : "-");
    } else if (q.is_k()) {
      row.emplace_back();
    }
  }
  return row;
}

void add_extremes(const FrontResult& front, ReportTable& table) {
  const auto [least, most] = extremes(front);
  for (const auto& [what, point] : {std::pair("smallest", least), std::pair("largest", most)}) {
    if (point == nullptr) {
      continue;
    }
    std::vector<std::string> named{front.name, what, std::to_string(point->number)};
    for (const double x : point->x) {
      named.push_back(fmt::format("{:.6g}", std::abs(x) < 1e-12 * front.length ? 0.0 : x));
    }
    table.rows.push_back(k_row(std::move(named), front, *point));
  }
}

std::string invalid_reason_note(const FrontResult& front) {
  return front.invalid_reason.empty()
             ? std::string()
             : fmt::format("warning: {}: {}\n", front.name, front.invalid_reason);
}

std::string touching_note(const FrontResult& front) {
  const auto closed = std::ranges::count_if(front.points, &FrontPointResult::closed);
  if (closed == 0) {
    return {};
  }
  return front.is_tip()
             ? fmt::format("note: {}: the crack's faces touch at the tip, K1 is 0\n", front.name)
             : fmt::format("note: {}: the crack's faces touch at {} of {} points, K1 is 0 there\n",
                           front.name, closed, front.points.size());
}

} // namespace

std::string k_reply(const ShellSession& session, const std::string& only) {
  const std::vector<FrontResult>& fronts = session.current_result().fronts;
  const bool tips = are_tips(fronts);
  if (!tips && !only.empty()) {
    return points_reply(session, only);
  }
  ReportTable table = empty_k_table(session.model().units, tips);
  for (const FrontResult& front : fronts) {
    if (!tips) {
      add_extremes(front, table);
    } else if (is_of_crack(front.name, only)) {
      table.rows.push_back(k_row({front.name}, front, front.tip()));
    }
  }
  return report::to_text(table);
}

std::string k_notes(const ShellSession& session, const std::string& only) {
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    if (!is_of_crack(front.name, only)) {
      continue;
    }
    text += invalid_reason_note(front) + touching_note(front);
    if (!front.has_error_bar()) {
      text += fmt::format("note: {}: no error bar: {}\n", front.name, front.no_bar);
    }
  }
  return text;
}

std::string k_concerns(const ShellSession& session) {
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    text += invalid_reason_note(front);
  }
  return text;
}

std::string k_state(const ShellSession& session) {
  const std::string K = session.model().units.stress_intensity_name();
  std::string text;
  for (const FrontResult& front : session.current_result().fronts) {
    const auto [least, most] = extremes(front);
    if (least == nullptr) {
      continue;
    }
    text += fmt::format("{:<12} a = {:<10.6g} ", front.name, front.a);
    if (front.two_materials) {
      text += fmt::format("G = {:.7g}\n", least->G);
    } else if (front.is_tip()) {
      text += fmt::format("K1 = {:<12.7g} K2 = {:<12.7g} {}\n", least->K1, least->K2, K);
    } else {
      text += fmt::format("K1 = {:.7g} .. {:.7g} {}\n", least->K1, most->K1, K);
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
    for (const FrontPointResult* point : {least, most}) {
      if (point != nullptr && std::ranges::find(numbers, point->number) == numbers.end()) {
        numbers.push_back(point->number);
      }
    }
    for (const results::LoadPathFrontPoint& point : front.points) {
      if (std::ranges::find(numbers, point.is.number) != numbers.end()) {
        const std::string name = at_end.is_tip()
                                     ? front.is.name
                                     : fmt::format("{} point {}", front.is.name, point.is.number);
        out.push_back({name, &point, at_end.is_tip()});
      }
    }
  }
  return out;
}

std::string map_reply(const ShellSession& session) {
  const results::LoadPathResult& path = *session.last_mapped_path();
  const MapRange& range = session.map_range();
  const std::string K = session.model().units.stress_intensity_name();
  ReportTable table{"", {{range.what, "", false}}, {}};
  const std::vector<MappedFrontPoint> points = mapped_points(path);
  for (const MappedFrontPoint& mapped : points) {
    const bool alone = mapped.is_tip && points.size() == 1;
    const std::string of = alone ? std::string() : " " + mapped.name;
    table.columns.push_back({"K1" + of, K, false});
    table.columns.push_back({fmt::format("dK1/d{}{}", range.what, of), K, false});
    if (mapped.is_tip) {
      table.columns.push_back({"K2" + of, K, false});
    }
  }
  for (const results::LoadPathContact& contact : path.contacts) {
    table.columns.push_back({contact.name, "closed", false});
  }
  const double width = range.to - range.from;
  const auto number = [](double value) { return fmt::format("{:.7g}", value); };
  for (std::size_t k = 0; k < path.t.size(); ++k) {
    std::vector<std::string> row{number(range.from + width * path.t[k])};
    for (const MappedFrontPoint& mapped : points) {
      const auto& [K1, K2, K3] = mapped.point->K;
      row.push_back(number(K1.at_knot(k)));
      row.push_back(number(K1.slope_after(k) / width));
      if (mapped.is_tip) {
        row.push_back(number(K2.at_knot(k)));
      }
    }
    for (const results::LoadPathContact& contact : path.contacts) {
      row.push_back(fmt::format("{}/{}", contact.closed[k], contact.rows));
    }
    table.rows.push_back(std::move(row));
  }
  return report::to_text(table);
}

} // namespace spricka::program
