// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile_report.hpp"

#include "base/csv.hpp"
#include "program/profile/profile_sums.hpp"
#include "report/drawing/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

  std::string operator()(const std::optional<double>& value) const {
    return value ? fmt::format(form, scale * *value) : unknown;
  }
};
constexpr ColumnForm seconds{"{:.3f}"};
constexpr ColumnForm number{"{:.3g}"};
constexpr ColumnForm whole{"{:.0f}"};
constexpr ColumnForm mebibytes{"{:.0f}", 1.0 / 1048576.0}; // of bytes
constexpr ColumnForm percent{"{:.1f}", 100.0};
constexpr ColumnForm gigaflops{"{:.2f}", 1e-9}; // of flops a second

std::optional<double> as_number(const std::optional<std::size_t>& count) {
  return count ? std::optional(static_cast<double>(*count)) : std::nullopt;
}

std::optional<double> share_of(const std::optional<double>& part, double all) {
  return part && all > 0.0 ? std::optional(*part / all) : std::nullopt;
}

// Of time that is too short for its clock there is no rate.
std::optional<double> rate(const std::optional<double>& flops, double cpu) {
  return flops && *flops > 0.0 && cpu > 1e-6 ? std::optional(*flops / cpu) : std::nullopt;
}

ReportTable processor_table(const ProcessorCostTable& sums) {
  ReportTable table = report::make_table("Profile by processor",
                                         "<|calls|cpu [s]|wall [s]|share [%]|flops|rate [Gflop/s]|"
                                         "resident [MiB]|peak [MiB]|raised [MiB]");
  const double all = sums.total_cpu();
  for (const ProcessorCostSum& row : sums.rows) {
    const std::string at_least = row.flops && !row.all_counted ? ">" : "";
    table.rows.push_back({row.processor, fmt::format("{}", row.calls), seconds(row.cpu),
                          seconds(row.wall), percent(share_of(row.cpu, all)),
                          at_least + number(row.flops), gigaflops(rate(row.flops, row.counted_cpu)),
                          mebibytes(as_number(row.resident)), mebibytes(as_number(row.peak)),
                          mebibytes(as_number(row.raised))});
  }
  table.rows.push_back({"not accounted for", "", seconds(sums.cpu_rest), seconds(sums.wall_rest),
                        percent(share_of(sums.cpu_rest, all)), "", "", "", "", ""});
  table.rows.push_back({"all", "", (sums.mesher_cpu ? "" : ">") + seconds(all), seconds(sums.wall),
                        "100.0", "", "", "", mebibytes(as_number(sums.peak)), ""});
  return table;
}

ReportTable net_table(const std::vector<NetCostSum>& nets) {
  ReportTable table =
      report::make_table("Nets", "<|freedoms|externals|nonzeros|condensed|reused|flops|"
                                 "stiffness [s]|analysis [s]|numeric [s]|rate [Gflop/s]");
  for (const NetCostSum& net : nets) {
    table.rows.push_back({net.name, fmt::format("{}", net.freedoms),
                          fmt::format("{}", net.externals), number(net.entries),
                          fmt::format("{}", net.condensed), fmt::format("{}", net.reused),
                          number(net.flops), seconds(net.stiffness_cpu), seconds(net.analysis_cpu),
                          seconds(net.numeric_cpu), gigaflops(rate(net.flops, net.numeric_cpu))});
  }
  return table;
}

// The first of them, each once.
std::string names(std::vector<std::string> list) {
  constexpr std::size_t most = 4;
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end()); // clang 14 lacks the range's
  const auto shown = list.begin() + static_cast<std::ptrdiff_t>(std::min(most, list.size()));
  const std::string text = fmt::format("{}", fmt::join(list.begin(), shown, ", "));
  return list.size() > most ? fmt::format("{}, {} more", text, list.size() - most) : text;
}

ReportTable length_table(const std::vector<CrackLengthCostSum>& lengths) {
  ReportTable table = report::make_table(
      "Crack lengths", "<|a|cpu [s]|wall [s]|mesher [s]|flops|<condensed|<reused");
  for (const CrackLengthCostSum& sum : lengths) {
    const results::CrackLengthCost& work = *sum.work;
    table.rows.push_back({sum.label, work.a ? report::six_digits(*work.a) : unknown,
                          seconds(work.cpu), seconds(work.end - work.begin),
                          seconds(sum.mesher_cpu), number(sum.flops), names(sum.condensed),
                          names(sum.reused)});
  }
  return table;
}

std::string bytes(std::uintmax_t count) {
  const auto value = static_cast<double>(count);
  return value < 1e6 ? fmt::format("{:.1f} kB", 1e-3 * value)
                     : fmt::format("{:.1f} MB", 1e-6 * value);
}

std::string floor_text(const ProfileRecord& record) {
  const CostFloor& floor = record.floor;
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

void add_processors(const ProfileRecord& record, base::CsvTable& csv) {
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
  for (const CrackLengthCostSum& sum : length_costs(profile)) {
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

void add_floor(const CostFloor& floor, base::CsvTable& csv) {
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

double cost_over_floor(const ProfileRecord& record) {
  double cpu = record.profile.cpu;
  for (const results::MesherCost& work : record.profile.mesher) {
    cpu += work.cpu.value_or(0.0);
  }
  return record.floor.why_not.empty() && record.floor.seconds_without_assembly() > 0.0
             ? cpu / record.floor.seconds_without_assembly()
             : std::numeric_limits<double>::quiet_NaN();
}

std::string profile_text(const ProfileRecord& record) {
  std::string text = "\n" + report::to_text(processor_table(processor_costs(record.profile)));
  for (const ReportTable& table :
       {net_table(net_costs(record.profile)), length_table(length_costs(record.profile))}) {
    text += table.rows.empty() ? "" : "\n" + report::to_text(table);
  }
  return text + "\n" + floor_text(record);
}

std::string profile_csv(const ProfileRecord& record) {
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
