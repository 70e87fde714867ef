// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/check_listing.hpp"

#include "base/by_dimension.hpp"
#include "base/printable.hpp"
#include "report/drawing/columns.hpp"
#include "report/topics/model_tables.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace spricka::report {

namespace {

using results::DeckPreview;

constexpr const char* four = "{:.4g}"; // digits

std::string percent(double part) {
  return part < 5e-4 ? "-" : fmt::format("{:.1f} %", 100.0 * part);
}

std::string place(const base::Vec3& x, int dim, const base::OutputUnit& unit) {
  const double size = x.norm(); // what is round-off of the other coordinate is 0
  const auto tidy = [&](double v) { return std::abs(v) < 1e-9 * size ? 0.0 : unit.from_deck(v); };
  const base::Vec3 shown = x.unaryExpr(tidy);
  return fmt::format("({:.5g})",
                     fmt::join(std::span(shown.data(), static_cast<std::size_t>(dim)), ", "));
}

std::string megabytes(double bytes) {
  return fmt::format("{:.0f}", bytes / 1e6);
}

ReportTable nets(const DeckPreview& p) {
  using Net = results::NetPreview;
  Columns<Net> columns;
  columns.words("net", &Net::name)
      .number("nodes", "", &Net::nodes)
      .number("elements", "", &Net::elements)
      .number("local", "", &Net::local)
      .number("external", "", &Net::external)
      .number("suppressed", "", &Net::suppressed)
      .number("prescribed", "", &Net::prescribed);
  if (std::ranges::any_of(p.nets, [](const Net& net) { return net.dependent > 0; })) {
    columns.number("dependent", "", &Net::dependent);
  }
  columns.words("of type", [](const Net& net) {
    std::string types;
    for (const auto& [type, elements] : net.types) {
      types += fmt::format("{}{} {}", types.empty() ? "" : ", ", elements, type);
    }
    return types;
  });
  return columns.table("Nets, freedoms by class", p.nets);
}

ReportTable quality(const DeckPreview& p) {
  using Quality = results::WorstElementPreview;
  const base::OutputUnit length = p.units.output_length();
  Columns<Quality> columns;
  columns.words("of", &Quality::where)
      .words("measure", &Quality::measure)
      .number("value", "",
              [](const Quality& q) {
                const bool angle = q.measure.ends_with("angle");
                return cell_text(q.value, angle ? "{:.1f} deg" : four);
              })
      .words("net", &Quality::net)
      .number("element", "", &Quality::element)
      .words(
          "at", [=, dim = p.dim](const Quality& q) { return place(q.at, dim, length); },
          length.name);
  return columns.table("Worst elements", p.quality);
}

ReportTable pairs(const DeckPreview& p) {
  using Pair = results::ContactPairPreview;
  const base::OutputUnit length = p.units.output_length();
  const auto faces = [](std::size_t facing, std::size_t edges) {
    return facing == edges ? cell_text(edges) : fmt::format("{} of {}", facing, edges);
  };
  Columns<Pair> columns;
  columns.words("contact", &Pair::name)
      .number("smallest", length, &Pair::gap_low, four)
      .number("mean", length, &Pair::gap_mean, four)
      .number("largest", length, &Pair::gap_high, four)
      .number("declared", length.name,
              [length](const Pair& c) {
                return c.declared ? cell_text(length.from_deck(c.declared_gap), four) : "measured";
              })
      .number("normals", "deg", &Pair::angle, "{:.2f}")
      .number("slave", "faces", [=](const Pair& c) { return faces(c.slave_facing, c.slave_edges); })
      .number(
          "master", "faces",
          [=](const Pair& c) { return c.rigid ? "rigid" : faces(c.master_facing, c.master_edges); })
      .number("slave", "overhang", [](const Pair& c) { return percent(c.slave_overhang); })
      .number("master", "overhang",
              [](const Pair& c) { return c.rigid ? "" : percent(c.master_overhang); })
      .number("rows", "", &Pair::rows)
      .words("multipliers on", &Pair::choice);
  return columns.table("Contact pairs: gaps as measured along the normals", p.pairs);
}

ReportTable bodies(const DeckPreview& p) {
  using Body = results::BodyRestraintPreview;
  Columns<Body> columns;
  columns.words("body", &Body::name)
      .number("nodes", "", &Body::nodes)
      .number("elements", "", &Body::elements)
      .number("modes", "", &Body::modes)
      .number("supports", "", &Body::by_supports)
      .number("contact", "", &Body::by_contact)
      .number("nothing", "", [](const Body& body) { return body.by_nothing.size(); })
      .words("free as to",
             [](const Body& body) { return fmt::format("{}", fmt::join(body.by_nothing, ", ")); });
  return columns.table("Bodies: what holds their rigid modes", p.bodies);
}

/// A crack of one length; all of a length stand in one mesh, whose elements the first names.
struct CrackRow {
  const results::CrackLengthPreview& length;
  const results::FrontPreview& front;
};

auto number_of(double results::FrontPreview::*member) {
  return [=](const CrackRow& row) { return row.front.*member; };
}

template <int dim>
auto place_of(base::Vec3 results::FrontPreview::*member, const base::OutputUnit& length) {
  return [=](const CrackRow& row) { return place(row.front.*member, dim, length); };
}

void add_tip_columns(Columns<CrackRow>& columns, const base::OutputUnit& unit) {
  columns.number("a", unit, number_of(&results::FrontPreview::a), four)
      .words("mouth", place_of<2>(&results::FrontPreview::mouth, unit), unit.name)
      .words("tip at", place_of<2>(&results::FrontPreview::at, unit), unit.name);
}

void add_front_columns(Columns<CrackRow>& columns, const base::OutputUnit& unit) {
  columns.words("kind", [](const CrackRow& row) { return row.front.kind; })
      .number("as a circle of", unit, number_of(&results::FrontPreview::a), four)
      .number("length of front", unit, number_of(&results::FrontPreview::length), four)
      .words("half way at", place_of<3>(&results::FrontPreview::at, unit), unit.name)
      .number("elements", "", [](const CrackRow& row) { return row.front.elements; });
}

/// How cracks are listed.
struct CrackListing {
  const char* front;
  const char* patch;
  void (*add)(Columns<CrackRow>&, const base::OutputUnit& unit);
  bool notes; ///< rings and sectors, patches that are shared, ties
};
constexpr base::ByDimension<CrackListing> crack_listings{
    {"tip", "rosette", add_tip_columns, false}, {"front", "tube", add_front_columns, true}};

ReportTable cracks(const DeckPreview& p) {
  const base::OutputUnit unit = p.units.output_length();
  const CrackListing& listing = crack_listings.at(p.dim);
  Columns<CrackRow> columns;
  columns.number("length", "", [](const CrackRow& row) { return row.length.number; });
  columns.words(listing.front, [](const CrackRow& row) { return row.front.name; });
  listing.add(columns, unit);
  columns.number(listing.patch, unit, number_of(&results::FrontPreview::radius), four)
      .number("tip element", unit, number_of(&results::FrontPreview::size), four)
      .fill_only_if([](const CrackRow& row) { return &row.front == row.length.fronts.data(); })
      .number("elements cut", "", [](const CrackRow& row) { return row.length.replaced; })
      .number("elements new", "", [](const CrackRow& row) { return row.length.fresh; });
  std::vector<CrackRow> rows;
  for (const results::CrackLengthPreview& length : p.lengths) {
    for (const results::FrontPreview& front : length.fronts) {
      rows.push_back({length, front});
    }
  }
  return columns.table("Cracks", rows);
}

ReportTable forecast(const DeckPreview& p) {
  using Length = results::CrackLengthPreview;
  Columns<Length> columns;
  columns.number("length", "", &Length::number)
      .number("nodes", "", &Length::nodes)
      .number("contact rows", "", &Length::rows)
      .number("nets new", "", &Length::condensed)
      .number("reused", "", &Length::reused)
      .number("unknowns new", "", &Length::unknowns)
      .number("nnz(L)", "", &Length::factor_entries, p.exact ? "{:.3g}" : "{:.2g}")
      .number("flops", "", &Length::flops, p.exact ? "{:.3g}" : "{:.2g}")
      .number("memory", "MB", [](const Length& length) { return megabytes(length.memory); })
      .number("CPU", "s", &Length::seconds, "{:.2f}");
  return columns.table(p.exact ? "Forecast" : "Rough forecast", p.lengths);
}

std::string mirror_line(const results::SymmetryPlanePreview& mirror,
                        const base::OutputUnit& length) {
  const char axis = "xyz"[mirror.axis];
  const std::string plane = fmt::format("{} = {:.5g}", axis, length.from_deck(mirror.at));
  return mirror.against.empty()
             ? fmt::format(
                   "  {} is a plane of symmetry: half of the model, $SYMMETRY NORMAL={}, has the "
                   "same answer{}\n",
                   plane, "XYZ"[mirror.axis],
                   mirror.no_half.empty() ? "" : ", but " + mirror.no_half)
             : fmt::format("  {} is a plane of symmetry of the bodies, but {}\n", plane,
                           mirror.against);
}

// What solves nets that Cholesky in core does not: at the first length that has such, as others do
// alike.
std::string engine_lines(const DeckPreview& p) {
  std::string lines;
  for (const results::CrackLengthPreview& length : p.lengths) {
    for (const std::string& engine : length.engines) {
      lines += fmt::format("  {}\n", engine);
    }
    if (!lines.empty()) {
      return "\n" + lines;
    }
  }
  return lines;
}

// What the whole run needs.
std::string run_line(const DeckPreview& p) {
  const bool fits = p.memory <= p.machine_memory;
  const std::string machine = megabytes(p.machine_memory);
  const std::string time =
      fmt::format("about {:.2g} s CPU at {:.3g} Gflop/s", p.seconds, 1e-9 * p.flop_rate);
  return p.exact
             ? fmt::format("\n  run: at most {} MB of the machine's {}, {:.3g} flops to factorise, "
                           "{}\n{}",
                           megabytes(p.memory), machine, p.flops, time,
                           fits ? "" : "  the run will not fit into this machine's memory\n")
             : fmt::format(
                   "\n  run: some {} MB of the machine's {}, {:.2g} flops to factorise, {}\n"
                   "  a rough forecast, by the number of unknowns and the shape of the "
                   "bodies; --forecast analyses the matrices\n{}",
                   megabytes(p.memory), machine, p.flops, time,
                   fits ? ""
                        : "  the run will hardly fit into this machine's memory: "
                          "--forecast tells\n");
}

} // namespace

std::string deck_preview_listing(const DeckPreview& preview) {
  std::string out = preview.deck + (preview.title.empty() ? "" : ": " + preview.title) + "\n";
  for (const ReportTable& table :
       {nets(preview), quality(preview), pairs(preview), bodies(preview),
        load_total_table(preview.loads, preview.units, preview.dim), cracks(preview)}) {
    out += to_text_after_blank_line(table);
  }
  out += imported_geometry_section(preview.geometry, preview.units.output_length());
  for (const results::CrackLengthPreview& length : preview.lengths) {
    if (crack_listings.at(preview.dim).notes) {
      for (const std::string& note : length.notes) {
        out += fmt::format("\n  note: {}", note);
      }
    }
  }
  out += fmt::format("\n  {} elements turned inside out\n", preview.inside_out);
  for (const results::SymmetryPlanePreview& mirror : preview.mirrors) {
    out += mirror_line(mirror, preview.units.output_length());
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
  out += "\n" + table_to_text(forecast(preview));
  out += engine_lines(preview);
  out += run_line(preview);
  for (const std::string& warning : preview.warnings) {
    out += "  warning: " + warning + "\n";
  }
  return base::make_lines_printable(out);
}

std::string imported_geometry_listing(const results::ReportedGeometry& geometry,
                                      const base::OutputUnit& length) {
  return imported_geometry_section(geometry, length);
}

} // namespace spricka::report
