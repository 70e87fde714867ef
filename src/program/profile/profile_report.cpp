// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile_report.hpp"

#include "base/csv.hpp"
#include "program/profile/profile_sums.hpp"
#include "report/drawing/columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using report::ReportTable;

constexpr const char* unknown = "unknown";

/// How the numbers of a kind of column are printed.
struct ColumnForm {
  fmt::format_string<double> form;
  double scale = 1.0;

  template <class Value> std::string operator()(const std::optional<Value>& value) const {
    return value ? fmt::format(form, scale * static_cast<double>(*value)) : unknown;
  }
  std::string operator()(double value) const { return fmt::format(form, scale * value); }
};
constexpr ColumnForm seconds{"{:.3f}"};
constexpr ColumnForm number{"{:.3g}"};
constexpr ColumnForm mebibytes{"{:.0f}", 1.0 / 1048576.0}; // of bytes
constexpr ColumnForm percent{"{:.1f}", 100.0};
constexpr ColumnForm gigaflops{"{:.2f}", 1e-9}; // of flops a second

std::optional<double> share_of(const std::optional<double>& part, double all) {
  return part && all > 0.0 ? std::optional(*part / all) : std::nullopt;
}

// Of time that is too short for its clock there is no rate.
std::optional<double> rate(const std::optional<double>& flops, double cpu) {
  return flops && *flops > 0.0 && cpu > 1e-6 ? std::optional(*flops / cpu) : std::nullopt;
}

ReportTable processor_table(const ProcessorCostTable& sums) {
  using Row = ProcessorCostSum;
  const double all = sums.total_cpu();
  ReportTable table =
      report::Columns<Row>()
          .words("", &Row::processor)
          .number("calls", "", &Row::calls)
          .number("cpu", "s", [](const Row& row) { return seconds(row.cpu); })
          .number("wall", "s", [](const Row& row) { return seconds(row.wall); })
          .number("share", "%", [=](const Row& row) { return percent(share_of(row.cpu, all)); })
          .number("flops", "",
                  [](const Row& row) {
                    return (row.flops && !row.all_counted ? ">" : "") + number(row.flops);
                  })
          .number("rate", "Gflop/s",
                  [](const Row& row) { return gigaflops(rate(row.flops, row.counted_cpu)); })
          .number("resident", "MiB", [](const Row& row) { return mebibytes(row.resident); })
          .number("peak", "MiB", [](const Row& row) { return mebibytes(row.peak); })
          .number("raised", "MiB", [](const Row& row) { return mebibytes(row.raised); })
          .table("Profile by processor", sums.rows);
  table.rows.push_back({"not accounted for", "", seconds(sums.cpu_rest), seconds(sums.wall_rest),
                        percent(share_of(sums.cpu_rest, all)), "", "", "", "", ""});
  table.rows.push_back({"all", "", (sums.mesher_cpu ? "" : ">") + seconds(all), seconds(sums.wall),
                        "100.0", "", "", "", mebibytes(sums.peak), ""});
  return table;
}

ReportTable net_size_table(const std::vector<NetCostSum>& nets) {
  using Row = NetCostSum;
  return report::Columns<Row>()
      .words("", &Row::name)
      .number("freedoms", "", &Row::freedoms)
      .number("externals", "", &Row::externals)
      .number("nonzeros", "", [](const Row& row) { return number(row.entries); })
      .number("condensed", "", &Row::condensed)
      .number("reused", "", &Row::reused)
      .number("flops", "", [](const Row& row) { return number(row.flops); })
      .number("stiffness", "s", &Row::stiffness_cpu, "{:.3f}")
      .number("analysis", "s", &Row::analysis_cpu, "{:.3f}")
      .number("numeric", "s", &Row::numeric_cpu, "{:.3f}")
      .number("rate", "Gflop/s",
              [](const Row& row) { return gigaflops(rate(row.flops, row.numeric_cpu)); })
      .table("Nets", nets);
}

// The first of them, each once.
std::string names(const std::vector<std::string>& list) {
  const std::set<std::string> all(list.begin(), list.end());
  constexpr std::size_t most = 4;
  const auto end = std::next(all.begin(), static_cast<std::ptrdiff_t>(std::min(most, all.size())));
  const std::string text = fmt::format("{}", fmt::join(all.begin(), end, ", "));
  return all.size() > most ? fmt::format("{}, {} more", text, all.size() - most) : text;
}

ReportTable length_table(const std::vector<CrackLengthCostSum>& lengths) {
  using Row = CrackLengthCostSum;
  return report::Columns<Row>()
      .words("", &Row::label)
      .number("a", "",
              [](const Row& row) {
                return row.work->a ? report::format_six_digits(*row.work->a) : unknown;
              })
      .number("cpu", "s", [](const Row& row) { return seconds(row.work->cpu); })
      .number("wall", "s", [](const Row& row) { return seconds(row.work->end - row.work->begin); })
      .number("mesher", "s", [](const Row& row) { return seconds(row.mesher_cpu); })
      .number("flops", "", [](const Row& row) { return number(row.flops); })
      .words("condensed", [](const Row& row) { return names(row.condensed); })
      .words("reused", [](const Row& row) { return names(row.reused); })
      .table("Crack lengths", lengths);
}

std::string bytes(std::uintmax_t count) {
  const auto value = static_cast<double>(count);
  return value < 1e6 ? fmt::format("{:.1f} kB", 1e-3 * value)
                     : fmt::format("{:.1f} MB", 1e-6 * value);
}

std::string floor_text(const ProfileWithCostFloor& record) {
  const FactorisationCostFloor& floor = record.floor;
  std::string text =
      "The floor: one plain factorisation of the stiffness of all bodies at the first length, "
      "without contact\n";
  if (!floor.why_not.empty()) {
    text += fmt::format("  {}: {}\n", unknown, floor.why_not);
  } else {
    text += fmt::format(
        "  {} equations, {:.3g} nonzeros of the factor, {:.3g} flops, {} Gflop/s\n"
        "  analysis {:.4f} s, numeric {:.4f} s, one solution {:.4f} s: {:.4f} s CPU; its assembly "
        "{:.4f} s\n",
        floor.equations, floor.entries, floor.flops, gigaflops(rate(floor.flops, floor.numeric)),
        floor.analysis, floor.numeric, floor.solution, floor.seconds_without_assembly(),
        floor.assembly);
  }
  text += fmt::format("  read {} of deck and meshes, written {} into the run folder\n",
                      bytes(record.bytes_read), bytes(record.bytes_written));
  const double times = cost_over_floor(record);
  if (std::isnan(times)) {
    return text + "How many plain factorisations the run took is unknown.\n";
  }
  const auto lengths = static_cast<double>(record.profile.lengths.size());
  text += fmt::format("The run took {:.3g} plain factorisations", times);
  return text + (lengths > 1.0 ? fmt::format(", {:.3g} for each of its {} crack lengths.\n",
                                             times / lengths, lengths)
                               : ".\n");
}

void add_processors(const ProfileWithCostFloor& record, base::CsvTable& csv) {
  const ProcessorCostTable sums = processor_costs(record.profile);
  const double all = sums.total_cpu();
  for (const ProcessorCostSum& row : sums.rows) {
    csv.add_row({{"kind", "processor"},
                 {"name", row.processor},
                 {"calls", row.calls},
                 {"cpu", row.cpu},
                 {"wall", row.wall},
                 {"share", share_of(row.cpu, all)},
                 {"flops", row.flops},
                 {"flops_all", row.flops ? std::optional(row.all_counted) : std::nullopt},
                 {"resident", row.resident},
                 {"peak", row.peak},
                 {"raised", row.raised}});
  }
  csv.add_row({{"kind", "processor"},
               {"name", "not accounted for"},
               {"cpu", sums.cpu_rest},
               {"wall", sums.wall_rest},
               {"share", share_of(sums.cpu_rest, all)}});
  csv.add_row({{"kind", "all"},
               {"name", "run"},
               {"cpu", sums.mesher_cpu ? std::optional(all) : std::nullopt},
               {"wall", sums.wall},
               {"peak", sums.peak},
               {"floors", cost_over_floor(record)},
               {"bytes_read", record.bytes_read},
               {"bytes_written", record.bytes_written}});
}

// Lengths count from 1 in the order in which they were worked on, those that were tried too.
void add_nets(const results::RunProfile& profile, base::CsvTable& csv) {
  for (const results::NetCost& net : profile.nets) {
    base::CsvRow row{{"kind", "net"},
                     {"name", net.name},
                     {"freedoms", net.freedoms},
                     {"externals", net.externals},
                     {"nonzeros", net.entries},
                     {"condensed", !net.reused},
                     {"reused", net.reused}};
    if (net.length) {
      row.emplace_back("length", *net.length + 1);
    }
    if (net.length && *net.length < profile.lengths.size()) {
      row.emplace_back("a", profile.lengths[*net.length].a);
    }
    const base::CsvRow work{{"cpu", net.stiffness_cpu + net.analysis_cpu + net.numeric_cpu},
                            {"wall", net.end - net.begin},
                            {"flops", net.flops},
                            {"stiffness_cpu", net.stiffness_cpu},
                            {"analysis_cpu", net.analysis_cpu},
                            {"numeric_cpu", net.numeric_cpu}};
    csv.add_row(row, net.reused ? base::CsvRow() : work);
  }
}

void add_lengths(const results::RunProfile& profile, base::CsvTable& csv) {
  std::size_t count = 0;
  for (const CrackLengthCostSum& sum : crack_length_costs(profile)) {
    csv.add_row({{"kind", "length"},
                 {"name", sum.label},
                 {"length", ++count},
                 {"a", sum.work->a},
                 {"cpu", sum.work->cpu},
                 {"wall", sum.work->end - sum.work->begin},
                 {"flops", sum.flops},
                 {"condensed", sum.condensed.size()},
                 {"reused", sum.reused.size()}});
  }
}

void add_floor(const FactorisationCostFloor& floor, base::CsvTable& csv) {
  const base::CsvRow work{{"calls", floor.times},
                          {"cpu", floor.seconds_without_assembly()},
                          {"flops", floor.flops},
                          {"freedoms", floor.equations},
                          {"externals", 0},
                          {"nonzeros", floor.entries},
                          {"stiffness_cpu", floor.assembly},
                          {"analysis_cpu", floor.analysis},
                          {"numeric_cpu", floor.numeric},
                          {"solution_cpu", floor.solution}};
  csv.add_row({{"kind", "floor"}, {"name", "plain factorisation"}, {"why", floor.why_not}},
              floor.why_not.empty() ? work : base::CsvRow());
}

} // namespace

double cost_over_floor(const ProfileWithCostFloor& record) {
  double cpu = record.profile.cpu;
  for (const results::MesherCost& work : record.profile.mesher) {
    cpu += work.cpu.value_or(0.0);
  }
  return record.floor.why_not.empty() && record.floor.seconds_without_assembly() > 0.0
             ? cpu / record.floor.seconds_without_assembly()
             : std::numeric_limits<double>::quiet_NaN();
}

std::string profile_text(const ProfileWithCostFloor& record) {
  std::string text = "\n" + report::table_to_text(processor_table(processor_costs(record.profile)));
  for (const ReportTable& table : {net_size_table(net_costs(record.profile)),
                                   length_table(crack_length_costs(record.profile))}) {
    text += table.rows.empty() ? "" : "\n" + report::table_to_text(table);
  }
  return text + "\n" + floor_text(record);
}

std::string profile_csv(const ProfileWithCostFloor& record) {
  base::CsvTable csv("kind,name,length,a,calls,cpu,wall,share,flops,flops_all,resident,peak,raised,"
                     "freedoms,externals,nonzeros,condensed,reused,stiffness_cpu,analysis_cpu,"
                     "numeric_cpu,solution_cpu,floors,bytes_read,bytes_written,why",
                     "# cpu, wall: s; share: of all cpu; resident, peak, raised: bytes; a: length "
                     "unit of the deck; empty: unknown, or no matter of the row");
  add_processors(record, csv);
  add_nets(record.profile, csv);
  add_lengths(record.profile, csv);
  add_floor(record.floor, csv);
  return csv.text();
}

} // namespace spricka::program
