// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/plots.hpp"

#include "base/diagnostics.hpp"
#include "model/model.hpp"
#include "program/shell/trouble.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/front_section.hpp"
#include "report/topics/load_path_tables.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The number of an attribute of the drawing's own element.
double attribute(const std::string& svg, const char* name) {
  const std::string head = svg.substr(0, svg.find('>'));
  const std::string key = fmt::format(" {}=\"", name);
  const std::size_t at = head.find(key);
  double value = 0.0;
  if (at != std::string::npos) {
    const char* first = head.data() + at + key.size();
    std::from_chars(first, head.data() + head.size(), value);
  }
  return value;
}

// Drawings one below the other on white paper; tables of a page are left out.
std::string stacked(const std::vector<report::Figure>& figures) {
  std::vector<std::string> drawings;
  const auto add = [&](const std::string& text) {
    if (text.starts_with("<svg")) {
      drawings.push_back(text);
    }
  };
  for (const report::Figure& figure : figures) {
    std::ranges::for_each(figure.drawings, add);
    add(figure.legend);
  }
  double width = 0.0;
  double height = 0.0;
  std::string body;
  for (const std::string& drawing : drawings) {
    body += fmt::format("<svg y=\"{:.2f}\"{}", height, drawing.substr(4));
    width = std::max(width, attribute(drawing, "width"));
    height += attribute(drawing, "height");
  }
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.2f}\" "
                     "height=\"{1:.2f}\" viewBox=\"0 0 {0:.2f} {1:.2f}\">\n"
                     "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
                     width, height, body);
}

// The path alone as the report draws it, t from 0 to 1.
std::vector<report::Figure> path_figures(const ShellSession& session,
                                         const results::LoadPathResult& path) {
  model::Model model; // what the drawing asks for
  model.units = session.model().units;
  model.load_paths.emplace_back().name = path.name;
  results::RunResult run;
  run.increments.emplace_back().paths = {path};
  return report::load_path_figures(model, run);
}

// The sizes tried with these loads and fits as steps of one increment, each front a figure.
std::vector<report::Figure> k_along_fronts(const ShellSession& session) {
  const base::OutputUnit length = session.model().units.output_length();
  results::CrackLengthResult sizes;
  std::vector<std::string> names;
  for (FrontsAtSize& tried : session.fronts_by_size()) {
    results::LoadStepResult& step = sizes.steps.emplace_back();
    step.step = fmt::format("a = {:.5g}", length.from_deck(tried.size.a));
    step.step +=
        tried.size.c > 0.0 ? fmt::format(", c = {:.5g}", length.from_deck(tried.size.c)) : "";
    step.fronts = std::move(tried.fronts);
    for (const results::FrontResult& front : step.fronts) {
      if (std::ranges::find(names, front.name) == names.end()) {
        names.push_back(front.name);
      }
    }
  }
  std::vector<report::Figure> figures;
  figures.reserve(names.size());
  for (const std::string& name : names) {
    figures.push_back(
        report::k_along_front_figure(session.solver().displayed_model(), sizes, name));
  }
  return figures;
}

// The same as increments of a run, for K over the length of tips.
results::RunResult run_of_sizes(const ShellSession& session) {
  results::RunResult run;
  for (FrontsAtSize& tried : session.fronts_by_size()) {
    results::CrackLengthResult& increment = run.increments.emplace_back();
    increment.number = static_cast<int>(run.increments.size());
    increment.a = tried.a;
    increment.steps.emplace_back().step = "NOW";
    increment.steps.back().fronts = std::move(tried.fronts);
  }
  return run;
}

} // namespace

std::vector<std::string> picture_kinds() {
  return {"k", "pressure", "mesh", "path"};
}

base::OptionalFailure draw_picture(const ShellSession& session, const std::string& kind,
                                   std::string& svg) {
  const std::vector<results::FrontResult>& fronts = session.current_result().fronts;
  if (kind == "k" && !fronts.empty() && !fronts.front().is_tip()) {
    svg = stacked(k_along_fronts(session));
  } else if (kind == "k") {
    const std::optional<report::Figure> figure = report::k_over_crack_length_figure(
        session.solver().displayed_model(), run_of_sizes(session));
    if (!figure) {
      return invalid_input("K over the crack length needs two lengths with these loads and fits",
                           "$CRACK NAME=C A0=5 tries another one");
    }
    svg = stacked({*figure});
  } else if (kind == "pressure") {
    const std::vector<report::Figure> figures =
        report::pressure_figures(session.solver().displayed_model(), session.run_results());
    if (figures.empty()) {
      return invalid_input("no contact is mounted");
    }
    svg = stacked(figures);
  } else if (kind == "mesh") {
    svg = stacked(report::mesh_figures(session.solver().displayed_model(), session.run_results()));
  } else if (kind == "path") {
    const results::LoadPathResult* path = session.last_followed_path();
    if (path == nullptr || path->fronts.empty()) {
      return invalid_input("there is no map at this state", "map CASE 0 1.5, or map LOADPATH");
    }
    svg = stacked(path_figures(session, *path));
  } else {
    return invalid_input(fmt::format("there is no picture of '{}'", kind),
                         base::make_spelling_hint(kind, picture_kinds()));
  }
  return {};
}

} // namespace spricka::program
