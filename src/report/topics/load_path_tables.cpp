// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_path_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace spricka::report {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

double in_print(const results::PathContact& contact, double place) {
  return contact.round ? place * degrees : place;
}

// "-PIN@152.3 +BUSH@90": pairs that open and close at this t; between solids "-PIN@36/0/7", the
// node's place.
std::string changes_at(const model::Mesh& mesh, const results::LoadPath& path, double t) {
  std::string text;
  for (const results::PathChange& change : path.changes) {
    if (change.t != t) {
      continue;
    }
    if (mesh.dim == 3) {
      const base::Vec3& x = mesh.x[change.node.index()];
      text += fmt::format("{}{}{}@{:.6g}/{:.6g}/{:.6g}", text.empty() ? "" : " ",
                          change.closes ? '+' : '-', change.contact, x.x(), x.y(), x.z());
      continue;
    }
    const results::PathContact* contact = results::find_contact(path, change.contact);
    text += fmt::format("{}{}{}@{:.6g}", text.empty() ? "" : " ", change.closes ? '+' : '-',
                        change.contact,
                        contact == nullptr ? change.place : in_print(*contact, change.place));
  }
  return text;
}

struct PathPlace {
  std::size_t knot = 0;
  bool space = false;
};

void add_row(std::string& text, const std::vector<std::string>& contacts,
             const results::LoadPath& path, const PathPlace& at,
             const std::vector<std::string>& tips) {
  const std::size_t k = at.knot;
  auto out = std::back_inserter(text);
  for (const std::string& name : tips) {
    const results::PathTip* tip = results::find_tip(path, name);
    if (tip == nullptr) {
      text += ",,,,,,";
      continue;
    }
    fmt::format_to(out, ",{},{},{},{},{},{}", tip->K1.at_knot(k), tip->K2.at_knot(k),
                   tip->K1.slope_before(k), tip->K1.slope_after(k), tip->K2.slope_before(k),
                   tip->K2.slope_after(k));
  }
  for (const std::string& name : contacts) {
    const results::PathContact* contact = results::find_contact(path, name);
    if (contact == nullptr) {
      text += ",,,";
      continue;
    }
    fmt::format_to(out, ",{}", contact->closed[k]);
    if (contact->closed[k] > 0 && !at.space) { // solids have no arcs
      fmt::format_to(out, ",{},{}", in_print(*contact, contact->from[k]),
                     in_print(*contact, contact->to[k]));
    } else {
      text += ",,";
    }
  }
  text += '\n';
}

std::vector<std::string> path_tip_names(const results::Run& run) {
  std::vector<std::string> names;
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPath& path : increment.paths) {
      for (const results::PathTip& tip : path.tips) {
        if (std::ranges::find(names, tip.name) == names.end()) {
          names.push_back(tip.name);
        }
      }
    }
  }
  return names;
}

// The deck's contacts, and the faces of its cracks where they touch.
std::vector<std::string> contact_names(const model::Model& model, const results::Run& run) {
  std::vector<std::string> names;
  for (const model::Contact& contact : model.contacts) {
    names.push_back(contact.name);
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPath& path : increment.paths) {
      for (const results::PathContact& contact : path.contacts) {
        if (std::ranges::find(names, contact.name) == names.end()) {
          names.push_back(contact.name);
        }
      }
    }
  }
  return names;
}

/// The knot where the slope jumps most, and by how much.
struct Kink {
  std::size_t knot = 0;
  double jump = 0.0;
  double largest_slope = 0.0;
};
Kink sharpest(const base::PiecewiseLinear& K) {
  Kink kink;
  for (std::size_t s = 0; s < K.segments(); ++s) {
    kink.largest_slope = std::max(kink.largest_slope, std::abs(K.slope(s)));
    const double jump = s > 0 ? std::abs(K.slope(s) - K.slope(s - 1)) : 0.0;
    if (jump > kink.jump) {
      kink.jump = jump;
      kink.knot = s;
    }
  }
  return kink;
}

std::string arc(const results::PathContact& contact, std::size_t k) {
  if (contact.closed[k] == 0) {
    return "open";
  }
  return fmt::format("{:.4g} .. {:.4g}{}", in_print(contact, contact.from[k]),
                     in_print(contact, contact.to[k]), contact.round ? " deg" : "");
}

// The slope as steps.
std::vector<Point> slopes(const base::PiecewiseLinear& K) {
  std::vector<Point> points;
  for (std::size_t s = 0; s < K.segments(); ++s) {
    points.push_back({K.knots()[s], K.slope(s)});
    points.push_back({K.knots()[s + 1], K.slope(s)});
  }
  return points;
}

std::vector<Point> values(const base::PiecewiseLinear& K) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < K.knots().size(); ++k) {
    points.push_back({K.knots()[k], K.at_knot(k)});
  }
  return points;
}

// Error bars of K1 at the ends of the path, which are ends of steps: elsewhere none is worked out.
Series end_bars(const results::Increment& increment, const results::LoadPath& path,
                const results::PathTip& tip, const std::string& colour) {
  Series series;
  series.joined = false;
  series.colour = colour;
  for (const Point& point : values(tip.K1)) {
    if (point.x != 0.0 && point.x != 1.0) {
      continue;
    }
    const results::StepResult* const at =
        results::find_step(increment, point.x == 0.0 ? path.from : path.to);
    const results::TipResult* const found =
        at == nullptr ? nullptr : results::find_tip(*at, tip.name);
    series.points.push_back(point);
    series.bars.push_back(found != nullptr && found->no_bar.empty() ? found->bar[0].size()
                                                                    : no_bar);
  }
  return series;
}

// Where contacts begin to open, as marks on the curve of a tip.
void add_openings(Plot& plot, const results::LoadPath& path, const results::PathTip& tip,
                  bool named) {
  constexpr std::array<Marker, 4> shapes{Marker::diamond, Marker::triangle, Marker::plus,
                                         Marker::cross};
  std::size_t shape = 0;
  for (const results::PathContact& contact : path.contacts) {
    const Marker marker = shapes[shape++ % shapes.size()];
    if (contact.opening) {
      Series series;
      series.name = named ? fmt::format("{} begins to open", contact.name) : std::string();
      series.points = {{*contact.opening, tip.K1(*contact.opening)}};
      series.joined = false;
      series.marker = marker;
      plot.series.push_back(series);
    }
  }
}

Figure figure_of(const model::Model& model, const results::Run& run, std::size_t p) {
  const std::string unit = print_unit(model.units.stress_intensity_name());
  const std::string x_name = "t";
  Plot value{
      "Stress intensity factor over the load path", x_name, fmt::format("K₁  [{}]", unit), {}};
  Plot slope{"Its slope", x_name, fmt::format("dK₁/dt  [{}]", unit), {}};
  value.legend_below = slope.legend_below = true;
  std::size_t ink = 0;
  const auto increments = chosen_increments(run, 6);
  for (const results::Increment* increment : increments) {
    const results::LoadPath& path = increment->paths[p];
    std::size_t pattern = 0;
    for (const results::PathTip& tip : path.tips) {
      Series series;
      series.name =
          fmt::format("{}a = {:.4g} {}", path.tips.size() > 1 ? tip.name + ", " : std::string(),
                      tip.a, model.units.length_name);
      series.colour = colour(ink);
      series.dash = dash(pattern++);
      series.points = values(tip.K1);
      value.series.push_back(series);
      value.series.push_back(end_bars(*increment, path, tip, series.colour));
      series.points = slopes(tip.K1);
      slope.series.push_back(series);
    }
    ++ink;
  }
  for (const results::Increment* increment : increments) {
    const results::LoadPath& path = increment->paths[p];
    if (!path.tips.empty()) {
      add_openings(value, path, path.tips.front(), increment == increments.front());
    }
  }
  const results::LoadPath& path = increments.front()->paths[p];
  return {{draw(value), draw(slope)},
          "",
          fmt::format("Load path {}: K₁ under the loads and fits (1 − t) {} + t {}, and its slope. "
                      "K₁ is a line between the breakpoints, where a pair opens or closes; marks: "
                      "the first of a contact.{}",
                      path.name, path.from, path.to, bar_words(value.series))};
}

} // namespace

void write_load_path_csv(const std::filesystem::path& file, const model::Model& model,
                         const results::Run& run) {
  if (model.load_paths.empty()) {
    return;
  }
  const std::vector<std::string> tips = path_tip_names(run);
  std::string text = fmt::format(
      "# units: K1 K2 and slopes by t [{}], from to [deg] on circles, else [{}], t [1]\n"
      "increment,path,t,changes",
      model.units.stress_intensity_name(), model.units.length_name);
  for (const std::string& tip : tips) {
    text += fmt::format(",{0}.K1,{0}.K2,{0}.dK1_before,{0}.dK1_after,{0}.dK2_before,{0}.dK2_after",
                        tip);
  }
  const std::vector<std::string> contacts = contact_names(model, run);
  for (const std::string& contact : contacts) {
    text += fmt::format(",{0}.closed,{0}.from,{0}.to", contact);
  }
  text += '\n';
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPath& path : increment.paths) {
      for (std::size_t k = 0; k < path.t.size(); ++k) {
        text += fmt::format("{},{},{},{}", increment.number, path.name, path.t[k],
                            changes_at(increment.mesh, path, path.t[k]));
        add_row(text, contacts, path, {k, increment.mesh.dim == 3}, tips);
      }
    }
  }
  write_file(file, text);
}

Table load_path_table(const model::Model& model, const results::Increment& increment) {
  const std::string unit = model.units.stress_intensity_name();
  Table table{"Load paths: K1 over t",
              {{"path", "", true},
               {"from", "", true},
               {"to", "", true},
               {"tip", "", true},
               {"breakpoints", "", false},
               {"t end", "", false},
               {"K1 begin", unit, false},
               {"K1 end", unit, false},
               {"slope begin", unit, false},
               {"slope end", unit, false},
               {"largest jump", "%", false},
               {"at t", "", false}},
              {}};
  for (const results::LoadPath& path : increment.paths) {
    for (const results::PathTip& tip : path.tips) {
      const Kink kink = sharpest(tip.K1);
      const bool kinked = kink.jump > 0.0 && kink.largest_slope > 0.0;
      table.rows.push_back(
          {path.name, path.from, path.to, tip.name, fmt::format("{}", path.t.size() - 2),
           six_digits(path.t.back()), six_digits(tip.K1.at_knot(0)),
           six_digits(tip.K1.at_knot(tip.K1.segments())), six_digits(tip.K1.slope_after(0)),
           six_digits(tip.K1.slope_before(tip.K1.segments())),
           kinked ? fmt::format("{:.2f}", 100.0 * kink.jump / kink.largest_slope) : "",
           kinked ? six_digits(tip.K1.knots()[kink.knot]) : ""});
    }
  }
  return table;
}

Table opening_table(const results::Increment& increment) {
  const bool arcs = increment.mesh.dim == 2;
  Table table{"Load paths: contact",
              {{"path", "", true},
               {"contact", "", true},
               {"first pair opens at t", "", false},
               {"closed at begin", "", false},
               {"at end", "", false},
               {"of", "", false}},
              {}};
  if (arcs) {
    table.columns.push_back({"arc at begin", "", false});
    table.columns.push_back({"arc at end", "", false});
  }
  for (const results::LoadPath& path : increment.paths) {
    for (const results::PathContact& contact : path.contacts) {
      const std::size_t last = contact.closed.size() - 1;
      std::vector<std::string> row{path.name,
                                   contact.name,
                                   contact.opening ? six_digits(*contact.opening) : "none",
                                   fmt::format("{}", contact.closed.front()),
                                   fmt::format("{}", contact.closed[last]),
                                   fmt::format("{}", contact.rows)};
      if (arcs) {
        row.push_back(arc(contact, 0));
        row.push_back(arc(contact, last));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<Figure> load_path_figures(const model::Model& model, const results::Run& run) {
  std::vector<Figure> figures;
  for (std::size_t p = 0; p < model.load_paths.size(); ++p) {
    const bool drawn = !run.increments.empty() &&
                       std::ranges::all_of(run.increments, [&](const results::Increment& i) {
                         return p < i.paths.size() && !i.paths[p].tips.empty();
                       });
    if (drawn) {
      figures.push_back(figure_of(model, run, p));
    }
  }
  return figures;
}

} // namespace spricka::report
