// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile_tables.hpp"

#include "program/profile/profile_sums.hpp"
#include "report/drawing/table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using report::ReportTable;

constexpr const char* unknown = "unknown";
constexpr double mebi = 1048576.0;

std::string seconds(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : unknown;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : unknown;
}

std::string mebibytes(const std::optional<std::size_t>& value) {
  return value ? fmt::format("{:.0f}", static_cast<double>(*value) / mebi) : unknown;
}

std::string percent(const std::optional<double>& part, double whole) {
  return part && whole > 0.0 ? fmt::format("{:.1f}", 100.0 * *part / whole) : unknown;
}

// Of time that is too short for its clock there is no rate.
std::string rate(const std::optional<double>& flops, double cpu) {
  return flops && *flops > 0.0 && cpu > 1e-6 ? fmt::format("{:.2f}", 1e-9 * *flops / cpu) : unknown;
}

ReportTable processor_table(const ProcessorCostTable& sums) {
  ReportTable table{"Profile by processor",
                    {{"", "", true},
                     {"calls", "", false},
                     {"cpu", "s", false},
                     {"wall", "s", false},
                     {"share", "%", false},
                     {"flops", "", false},
                     {"rate", "Gflop/s", false},
                     {"resident", "MiB", false},
                     {"peak", "MiB", false},
                     {"raised", "MiB", false}},
                    {}};
  const double all = sums.total_cpu();
  for (const ProcessorCostSum& row : sums.rows) {
    const std::string at_least = row.flops && !row.all_counted ? ">" : "";
    table.rows.push_back({row.processor, fmt::format("{}", row.calls), seconds(row.cpu),
                          seconds(row.wall), percent(row.cpu, all), at_least + number(row.flops),
                          rate(row.flops, row.counted_cpu), mebibytes(row.resident),
                          mebibytes(row.peak), mebibytes(row.raised)});
  }
  table.rows.push_back({"not accounted for", "", seconds(sums.cpu_rest), seconds(sums.wall_rest),
                        percent(sums.cpu_rest, all), "", "", "", "", ""});
  table.rows.push_back({"all", "", (sums.mesher_cpu ? "" : ">") + seconds(all), seconds(sums.wall),
                        "100.0", "", "", "", mebibytes(sums.peak), ""});
  return table;
}

ReportTable net_table(const std::vector<NetCostSum>& nets) {
  ReportTable table{"Nets",
                    {{"", "", true},
                     {"freedoms", "", false},
                     {"externals", "", false},
                     {"nonzeros", "", false},
                     {"condensed", "", false},
                     {"reused", "", false},
                     {"flops", "", false},
                     {"stiffness", "s", false},
                     {"analysis", "s", false},
                     {"numeric", "s", false},
                     {"rate", "Gflop/s", false}},
                    {}};
  for (const NetCostSum& net : nets) {
    table.rows.push_back({net.name, fmt::format("{}", net.freedoms),
                          fmt::format("{}", net.externals), number(net.entries),
                          fmt::format("{}", net.condensed), fmt::format("{}", net.reused),
                          number(net.flops), seconds(net.stiffness_cpu), seconds(net.analysis_cpu),
                          seconds(net.numeric_cpu), rate(net.flops, net.numeric_cpu)});
  }
  return table;
}

// The first of them, each once.
std::string names(std::vector<std::string> list) {
  constexpr std::size_t most = 4;
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end()); // clang 14 lacks the range's
  std::string text;
  for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
    text += (i == 0 ? "" : ", ") + list[i];
  }
  return list.size() > most ? fmt::format("{}, {} more", text, list.size() - most) : text;
}

ReportTable length_table(const std::vector<CrackLengthCostSum>& lengths) {
  ReportTable table{"Crack lengths",
                    {{"", "", true},
                     {"a", "", false},
                     {"cpu", "s", false},
                     {"wall", "s", false},
                     {"mesher", "s", false},
                     {"flops", "", false},
                     {"condensed", "", true},
                     {"reused", "", true}},
                    {}};
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
        floor.equations, floor.entries, floor.flops, rate(floor.flops, floor.numeric),
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

} // namespace

std::string profile_text(const ProfileRecord& record) {
  std::string text = "\n" + report::to_text(processor_table(processor_costs(record.profile)));
  if (const std::vector<NetCostSum> nets = net_costs(record.profile); !nets.empty()) {
    text += "\n" + report::to_text(net_table(nets));
  }
  if (const std::vector<CrackLengthCostSum> lengths = length_costs(record.profile);
      !lengths.empty()) {
    text += "\n" + report::to_text(length_table(lengths));
  }
  return text + "\n" + floor_text(record);
}

} // namespace spricka::program
