// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/front_marks.hpp"

#include "model/model.hpp"
#include "report/drawing/beach_marks.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::report {

namespace {

// The fronts of a crack in a solution; those of all steps lie at the same places.
std::vector<std::vector<base::Vec3>> fronts_of(const results::Increment& increment,
                                               const std::string& crack) {
  std::vector<std::vector<base::Vec3>> fronts;
  if (increment.steps.empty()) {
    return fronts;
  }
  for (const results::FrontResult& front : increment.steps.front().fronts) {
    if (front.name != crack && !front.name.starts_with(crack + ".")) {
      continue;
    }
    std::vector<base::Vec3>& points = fronts.emplace_back();
    for (const results::FrontPointResult& place : front.points) {
      points.push_back(place.x);
    }
    if (front.is_loop && !points.empty()) {
      points.push_back(points.front());
    }
  }
  return fronts;
}

} // namespace

std::vector<Figure> beach_mark_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  if (!run.growth || model.mesh.dim != 3) {
    return figures;
  }
  const std::vector<results::GrowthStation>& stations = run.growth->stations;
  for (const model::CrackDefinition& crack : model.cracks) {
    BeachMarkView view;
    view.title = fmt::format("Fronts of {}", crack.name);
    view.right = crack.plane.along;
    view.up = crack.plane.transverse_axis();
    view.length_name = model.units.length_name;
    for (std::size_t i = 0; i < std::min(stations.size(), run.increments.size()); ++i) {
      BeachMark mark{.fronts = fronts_of(run.increments[i], crack.name),
                     .cycles = stations[i].cycles};
      if (!mark.fronts.empty()) {
        view.marks.push_back(std::move(mark));
      }
    }
    if (view.marks.size() < 2) {
      continue;
    }
    figures.push_back({{draw_svg(view)},
                       "",
                       fmt::format("Where the front of {} was solved, seen along the crack's "
                                   "normal; N in {}.",
                                   crack.name, run.growth->unit == "pass" ? "passes" : "cycles")});
  }
  return figures;
}

} // namespace spricka::report
