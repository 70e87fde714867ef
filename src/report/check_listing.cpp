// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/check_listing.hpp"

#include "report/drawing/table.hpp"
#include "report/topics/load_table.hpp"
#include "report/topics/script_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::report {

namespace {

using results::DeckPreview;

std::string number(double v) {
  return fmt::format("{:.4g}", v);
}

std::string count(std::size_t n) {
  return fmt::format("{}", n);
}

std::string percent(double part) {
  return part < 5e-4 ? "-" : fmt::format("{:.1f} %", 100.0 * part);
}

std::string place(const base::Vec3& x, int dim) {
  const double size = x.norm(); // what is round-off of the other coordinate is 0
  const auto tidy = [size](double v) { return std::abs(v) < 1e-9 * size ? 0.0 : v; };
  const std::string plane = fmt::format("{:.5g}, {:.5g}", tidy(x.x()), tidy(x.y()));
  return dim == 3 ? fmt::format("({}, {:.5g})", plane, tidy(x.z())) : "(" + plane + ")";
}

std::string megabytes(double bytes) {
  return fmt::format("{:.0f}", bytes / 1e6);
}

ReportTable nets(const DeckPreview& p) {
  ReportTable table = make_table("Nets, freedoms by class", "<net|nodes|elements|local|external|"
                                                            "suppressed|prescribed");
  const bool tied = std::ranges::any_of(p.nets, [](const auto& net) { return net.dependent > 0; });
  if (tied) {
    table.columns.push_back({"dependent", "", false});
  }
  table.columns.push_back({"of type", "", true});
  for (const results::NetPreview& net : p.nets) {
    std::string types;
    for (const auto& [type, elements] : net.types) {
      types += fmt::format("{}{} {}", types.empty() ? "" : ", ", elements, type);
    }
    table.rows.push_back({net.name, count(net.nodes), count(net.elements), count(net.local),
                          count(net.external), count(net.suppressed), count(net.prescribed)});
    if (tied) {
      table.rows.back().push_back(count(net.dependent));
    }
    table.rows.back().push_back(types);
  }
  return table;
}

ReportTable quality(const DeckPreview& p) {
  ReportTable table = make_table(
      "Worst elements", fmt::format("<of|<measure|value|<net|element|<at [{}]", p.length_unit));
  for (const results::MeshQualityPreview& q : p.quality) {
    const bool angle = q.measure.ends_with("angle");
    table.rows.push_back({q.where, q.measure,
                          angle ? fmt::format("{:.1f} deg", q.value) : number(q.value), q.net,
                          fmt::format("{}", q.element), place(q.at, p.dim)});
  }
  return table;
}

ReportTable pairs(const DeckPreview& p) {
  ReportTable table = make_table(
      "Contact pairs: gaps as measured along the normals",
      fmt::format("<contact|smallest [{0}]|mean [{0}]|largest [{0}]|declared [{0}]|normals [deg]|"
                  "slave [faces]|master [faces]|slave [overhang]|master [overhang]|rows|"
                  "<multipliers on",
                  p.length_unit));
  const auto faces = [](std::size_t facing, std::size_t edges) {
    return facing == edges ? count(edges) : fmt::format("{} of {}", facing, edges);
  };
  for (const results::ContactPairPreview& c : p.pairs) {
    table.rows.push_back({c.name, number(c.gap_low), number(c.gap_mean), number(c.gap_high),
                          c.declared ? number(c.declared_gap) : "measured",
                          fmt::format("{:.2f}", c.angle), faces(c.slave_facing, c.slave_edges),
                          c.rigid ? "rigid" : faces(c.master_facing, c.master_edges),
                          percent(c.slave_overhang), c.rigid ? "" : percent(c.master_overhang),
                          count(c.rows), c.choice});
  }
  return table;
}

ReportTable bodies(const DeckPreview& p) {
  ReportTable table = make_table("Bodies: what holds their rigid modes",
                                 "<body|nodes|elements|modes|supports|contact|nothing|<free as to");
  for (const results::BodyPreview& body : p.bodies) {
    table.rows.push_back({body.name, count(body.nodes), count(body.elements),
                          fmt::format("{}", body.modes), fmt::format("{}", body.by_supports),
                          fmt::format("{}", body.by_contact), count(body.by_nothing.size()),
                          fmt::format("{}", fmt::join(body.by_nothing, ", "))});
  }
  return table;
}

/// The cells of the tips and fronts of one length.
std::vector<std::vector<std::string>> crack_cells(const results::CrackLengthPreview& length,
                                                  int dim) {
  std::vector<std::vector<std::string>> cells;
  for (const results::TipPreview& tip : length.tips) {
    cells.push_back({tip.name, number(tip.a), place(tip.mouth, dim), place(tip.tip, dim),
                     number(tip.radius), number(tip.size)});
  }
  for (const results::FrontPreview& front : length.fronts) {
    cells.push_back({front.name, front.kind, number(front.a), number(front.length),
                     place(front.at, dim), count(front.elements), number(front.radius),
                     number(front.size)});
  }
  return cells;
}

ReportTable cracks(const DeckPreview& p) {
  const char* const tip = "<tip|a [{0}]|<mouth [{0}]|<tip at [{0}]|rosette [{0}]|tip element [{0}]";
  const char* const front = "<front|<kind|as a circle of [{0}]|length of front [{0}]|"
                            "<half way at [{0}]|elements|tube [{0}]|tip element [{0}]";
  ReportTable table = make_table(
      "Cracks", fmt::format(fmt::runtime(fmt::format("length|{}|elements cut|elements new",
                                                     p.dim == 3 ? front : tip)),
                            p.length_unit));
  for (const results::CrackLengthPreview& length : p.lengths) {
    bool first = true; // all of a length stand in one mesh
    for (std::vector<std::string>& row : crack_cells(length, p.dim)) {
      row.insert(row.begin(), fmt::format("{}", length.number));
      row.push_back(first ? count(length.replaced) : "");
      row.push_back(first ? count(length.fresh) : "");
      table.rows.push_back(std::move(row));
      first = false;
    }
  }
  return table;
}

ReportTable forecast(const DeckPreview& p) {
  ReportTable table =
      make_table("Forecast", "length|nodes|contact rows|nets new|reused|unknowns new|nnz(L)|flops|"
                             "memory [MB]|CPU [s]");
  for (const results::CrackLengthPreview& length : p.lengths) {
    table.rows.push_back({fmt::format("{}", length.number), count(length.nodes), count(length.rows),
                          fmt::format("{}", length.condensed), fmt::format("{}", length.reused),
                          count(length.unknowns), fmt::format("{:.3g}", length.factor_entries),
                          fmt::format("{:.3g}", length.flops), megabytes(length.memory),
                          fmt::format("{:.2f}", length.seconds)});
  }
  return table;
}

std::string mirror_line(const results::SymmetryPlanePreview& mirror) {
  const char axis = "xyz"[mirror.axis];
  const std::string plane = fmt::format("{} = {:.5g}", axis, mirror.at);
  return mirror.against.empty()
             ? fmt::format(
                   "  {} is a plane of symmetry: half of the model, $SYMMETRY NORMAL={}, has the "
                   "same answer{}\n",
                   plane, "XYZ"[mirror.axis],
                   mirror.no_half.empty() ? "" : ", but " + mirror.no_half)
             : fmt::format("  {} is a plane of symmetry of the bodies, but {}\n", plane,
                           mirror.against);
}

} // namespace

std::string check_listing(const DeckPreview& preview) {
  std::string out = preview.deck + (preview.title.empty() ? "" : ": " + preview.title) + "\n";
  for (const ReportTable& table :
       {nets(preview), quality(preview), pairs(preview), bodies(preview),
        load_table(preview.loads, {preview.length_unit, preview.force_unit, preview.dim}),
        cracks(preview)}) {
    if (!table.rows.empty()) {
      out += "\n" + to_text(table);
    }
  }
  if (!preview.scripts.empty()) {
    out += "\n" + to_text(script_table(preview.scripts));
  }
  // Of cracks in space notes tell more: rings and sectors, patches that are shared, ties.
  for (const results::CrackLengthPreview& length : preview.lengths) {
    for (const std::string& note : preview.dim == 3 ? length.notes : std::vector<std::string>()) {
      out += fmt::format("\n  note: {}", note);
    }
  }
  out += fmt::format("\n  {} elements turned inside out\n", preview.inside_out);
  for (const results::SymmetryPlanePreview& mirror : preview.mirrors) {
    out += mirror_line(mirror);
  }
  out += fmt::format("  steps: {}\n", fmt::join(preview.steps, " "));
  for (const auto& [contact, step] : preview.mounted_later) {
    out +=
        fmt::format("  contact {}: absent, with its fit, until step {} mounts it\n", contact, step);
  }
  if (!preview.sweep.empty()) {
    out += fmt::format("  sweep: {} points, {} .. {}; tables and forecast are of the deck's own "
                       "values\n",
                       preview.sweep.size(), preview.sweep.front(), preview.sweep.back());
  }
  out += "\n" + to_text(forecast(preview));
  out += fmt::format("\n  run: at most {} MB of the machine's {}, {:.3g} flops to factorise, "
                     "about {:.2g} s CPU at {:.3g} Gflop/s\n",
                     megabytes(preview.memory), megabytes(preview.machine_memory), preview.flops,
                     preview.seconds, 1e-9 * preview.flop_rate);
  if (preview.memory > preview.machine_memory) {
    out += "  the run will not fit into this machine's memory\n";
  }
  for (const std::string& warning : preview.warnings) {
    out += "  warning: " + warning + "\n";
  }
  return out;
}

} // namespace spricka::report
