// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_path_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/topics/dimension_columns.hpp"
#include "report/topics/result_rows.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>

namespace spricka::report {

namespace {

/// A row of either file: a load path at one of its knots, of a front at a point.
struct PathRow {
  const results::CrackLengthResult& increment;
  const results::LoadPathResult& path;
  std::size_t knot = 0;
  const results::LoadPathFront* front = nullptr;
  const results::LoadPathFrontPoint* point = nullptr;
};

// "-PIN@152.3 +BUSH@90": pairs that open and close at this t; between solids "-PIN@36/0/7", the
// node's place.
std::string changes_at(const PathRow& row, const base::OutputUnit& length) {
  const model::Mesh& mesh = row.increment.mesh;
  const results::LoadPathResult& path = row.path;
  const double t = path.t[row.knot];
  std::string text;
  for (const results::ContactStatusChange& change : path.changes) {
    if (change.t != t) {
      continue;
    }
    std::vector<double> place{change.place};
    if (!dimension_columns.at(mesh.dim).arcs) {
      const base::Vec3& x = mesh.x[change.node.index()];
      place = {length.from_deck(x[0]), length.from_deck(x[1]), length.from_deck(x[2])};
    } else if (const auto* contact = results::find_contact(path, change.contact)) {
      place = {contact_place_as_written(*contact, change.place, length)};
    }
    text += fmt::format("{}{}{}@{:.6g}", text.empty() ? "" : " ", change.closes ? '+' : '-',
                        change.contact, fmt::join(place, "/"));
  }
  return text;
}

Columns<PathRow> knot_columns() {
  Columns<PathRow> columns;
  columns.exact("increment", [](const PathRow& row) { return row.increment.number; });
  columns.exact("path", [](const PathRow& row) { return row.path.name; });
  columns.exact("t", [](const PathRow& row) { return row.path.t[row.knot]; });
  return columns;
}

/// The first modes of K at a knot, then their slopes before and behind it; point_of: the point of a
/// row, or null.
template <class PointOf>
void add_k_columns(Columns<PathRow>& columns, const std::string& prefix, std::size_t modes,
                   const base::OutputUnit& unit, const PointOf& point_of) {
  columns.fill_only_if([=](const PathRow& row) { return point_of(row) != nullptr; });
  for (std::size_t k = 0; k < modes; ++k) {
    columns.exact(fmt::format("{}K{}", prefix, k + 1), unit,
                  [=](const PathRow& row) { return point_of(row)->K[k].value_at_knot(row.knot); });
  }
  for (std::size_t k = 0; k < modes; ++k) {
    columns.exact(fmt::format("{}dK{}_before", prefix, k + 1), unit,
                  [=](const PathRow& row) { return point_of(row)->K[k].slope_before(row.knot); });
    columns.exact(fmt::format("{}dK{}_after", prefix, k + 1), unit,
                  [=](const PathRow& row) { return point_of(row)->K[k].slope_after(row.knot); });
  }
  columns.fill_only_if({});
}

void add_contact_columns(Columns<PathRow>& columns, const std::string& name,
                         const base::OutputUnit& length) {
  const auto found = [name](const PathRow& row) { return results::find_contact(row.path, name); };
  columns.fill_only_if([=](const PathRow& row) { return found(row) != nullptr; });
  columns.exact(name + ".closed", [=](const PathRow& row) { return found(row)->closed[row.knot]; });
  columns.fill_only_if([=](const PathRow& row) { // solids have no arcs
    const results::LoadPathContact* const contact = found(row);
    return contact != nullptr && contact->closed[row.knot] > 0 &&
           dimension_columns.at(row.increment.mesh.dim).arcs;
  });
  columns.exact(name + ".from", [=](const PathRow& row) {
    return contact_place_as_written(*found(row), found(row)->from[row.knot], length);
  });
  columns.exact(name + ".to", [=](const PathRow& row) {
    return contact_place_as_written(*found(row), found(row)->to[row.knot], length);
  });
}

std::vector<PathRow> knot_rows(const results::RunResult& run) {
  std::vector<PathRow> rows;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (std::size_t k = 0; k < path.t.size(); ++k) {
        rows.push_back({.increment = increment, .path = path, .knot = k});
      }
    }
  }
  return rows;
}

std::vector<std::string> path_tip_names(const results::RunResult& run) {
  std::vector<std::string> names;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (const results::LoadPathFront& front : path.fronts) {
        if (front.is_tip()) {
          add_unique(names, front.front_without_points.name);
        }
      }
    }
  }
  return names;
}

// The deck's contacts, and the faces of its cracks where they touch.
std::vector<std::string> contact_names(const model::Model& model, const results::RunResult& run) {
  std::vector<std::string> names;
  std::ranges::transform(model.contacts, std::back_inserter(names), &model::Contact::name);
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (const results::LoadPathContact& contact : path.contacts) {
        add_unique(names, contact.name);
      }
    }
  }
  return names;
}

} // namespace

double contact_place_as_written(const results::LoadPathContact& contact, double place,
                                const base::OutputUnit& length) {
  return contact.round ? place * degrees_per_radian : length.from_deck(place);
}

void write_K_along_load_path_csv(const std::filesystem::path& file, const model::Model& model,
                                 const results::RunResult& run) {
  if (model.load_paths.empty()) {
    return;
  }
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Columns<PathRow> columns = knot_columns();
  columns.exact("changes", [&](const PathRow& row) { return changes_at(row, length); });
  for (const std::string& name : path_tip_names(run)) {
    add_k_columns(columns, name + ".", 2, unit, [name](const PathRow& row) {
      const results::LoadPathFront* const front = results::find_front(row.path, name);
      return front == nullptr ? nullptr : &front->single_point();
    });
  }
  for (const std::string& name : contact_names(model, run)) {
    add_contact_columns(columns, name, length);
  }
  const std::string units =
      fmt::format("K1 K2 and slopes by t [{}], from to [deg] on circles, else [{}], t [1]",
                  unit.name, length.name);
  write_file(file, columns.csv(units, knot_rows(run)));
}

void write_load_path_fronts_csv(const std::filesystem::path& file, const model::Model& model,
                                const results::RunResult& run) {
  if (model.load_paths.empty() || model.cracks.empty() ||
      !dimension_columns.at(model.mesh.dim).points) {
    return;
  }
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Columns<PathRow> columns = knot_columns();
  columns.exact("crack", [](const PathRow& row) { return row.front->front_without_points.name; });
  columns.exact("point", [](const PathRow& row) { return row.point->point_at_start.number; });
  columns.exact("at_surface",
                [](const PathRow& row) { return row.point->point_at_start.at_surface ? 1 : 0; });
  columns.exact("s", length, [](const PathRow& row) { return row.point->point_at_start.s; });
  columns.fill_only_if(
      [](const PathRow& row) { return row.front->front_without_points.has_angles; });
  columns.exact(
      "phi", [](const PathRow& row) { return row.point->point_at_start.phi * degrees_per_radian; });
  columns.fill_only_if({});
  for (const Eigen::Index c : {0, 1, 2}) {
    columns.exact(std::string(1, "xyz"[c]), length,
                  [c](const PathRow& row) { return row.point->point_at_start.x[c]; });
  }
  add_k_columns(columns, "", 3, unit, [](const PathRow& row) { return row.point; });
  std::vector<PathRow> rows;
  for (const PathRow& knot : knot_rows(run)) {
    for (const results::LoadPathFront& front : knot.path.fronts) {
      for (const results::LoadPathFrontPoint& point : front.points) {
        rows.push_back({knot.increment, knot.path, knot.knot, &front, &point});
      }
    }
  }
  const std::string units = fmt::format(
      "K1 K2 K3 and slopes by t [{}], s x y z [{}], phi [deg], t [1]", unit.name, length.name);
  write_file(file, columns.csv(units, rows));
}

} // namespace spricka::report
