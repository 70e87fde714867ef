// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/profile_csv.hpp"

#include "program/profile/profile_sums.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr std::array<std::string_view, 26> columns{
    "kind",          "name",         "length",        "a",
    "calls",         "cpu",          "wall",          "share",
    "flops",         "flops_all",    "resident",      "peak",
    "raised",        "freedoms",     "externals",     "nonzeros",
    "condensed",     "reused",       "stiffness_cpu", "analysis_cpu",
    "numeric_cpu",   "solution_cpu", "floors",        "bytes_read",
    "bytes_written", "why"};

/// One row, its cells by the names of their columns.
class ProfileCsvRow {
public:
  ProfileCsvRow(const char* kind, const std::string& name) {
    cells_["kind"] = kind;
    cells_["name"] = quoted(name);
  }
  template <typename T> ProfileCsvRow& set(std::string_view column, const T& value) {
    cells_[column] = fmt::format("{}", value);
    return *this;
  }
  template <typename T> ProfileCsvRow& set(std::string_view column, const std::optional<T>& value) {
    if (value) {
      set(column, *value);
    }
    return *this;
  }
  ProfileCsvRow& words(std::string_view column, const std::string& text) {
    cells_[column] = quoted(text);
    return *this;
  }
  [[nodiscard]] std::string text() const {
    std::string line;
    for (const std::string_view column : columns) {
      const auto cell = cells_.find(column);
      line += (line.empty() ? "" : ",") + (cell == cells_.end() ? std::string() : cell->second);
    }
    return line + "\n";
  }

private:
  static std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
      return text;
    }
    std::string out = "\"";
    for (const char c : text) {
      out += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return out + "\"";
  }
  std::map<std::string_view, std::string> cells_;
};

std::string processor_rows(const ProfileRecord& record) {
  const ProcessorCostTable sums = processor_costs(record.profile);
  const double all = sums.total_cpu();
  const auto share = [all](std::optional<double> cpu) {
    return cpu && all > 0.0 ? std::optional(*cpu / all) : std::nullopt;
  };
  std::string text;
  for (const ProcessorCostSum& row : sums.rows) {
    ProfileCsvRow line("processor", row.processor);
    line.set("calls", row.calls).set("cpu", row.cpu).set("wall", row.wall);
    line.set("share", share(row.cpu)).set("flops", row.flops);
    if (row.flops) {
      line.set("flops_all", row.all_counted ? 1 : 0);
    }
    line.set("resident", row.resident).set("peak", row.peak).set("raised", row.raised);
    text += line.text();
  }
  text += ProfileCsvRow("processor", "not accounted for")
              .set("cpu", sums.cpu_rest)
              .set("wall", sums.wall_rest)
              .set("share", share(sums.cpu_rest))
              .text();
  ProfileCsvRow whole("all", "run");
  whole.set("cpu", sums.mesher_cpu ? std::optional(all) : std::nullopt);
  whole.set("wall", sums.wall).set("peak", sums.peak);
  if (const double times = cost_over_floor(record); !std::isnan(times)) {
    whole.set("floors", times);
  }
  whole.set("bytes_read", record.bytes_read).set("bytes_written", record.bytes_written);
  return text + whole.text();
}

// Lengths count from 1 in the order in which they were worked on, those that were tried too.
std::optional<std::size_t> counted(const std::optional<std::size_t>& length) {
  return length ? std::optional(*length + 1) : std::nullopt;
}

std::string net_rows(const results::RunProfile& profile) {
  std::string text;
  for (const results::NetCost& net : profile.nets) {
    ProfileCsvRow row("net", net.name);
    row.set("length", counted(net.length));
    if (net.length && *net.length < profile.lengths.size()) {
      row.set("a", profile.lengths[*net.length].a);
    }
    row.set("freedoms", net.freedoms).set("externals", net.externals);
    row.set("nonzeros", net.entries);
    row.set("condensed", net.reused ? 0 : 1).set("reused", net.reused ? 1 : 0);
    if (!net.reused) {
      row.set("cpu", net.stiffness_cpu + net.analysis_cpu + net.numeric_cpu);
      row.set("wall", net.end - net.begin).set("flops", net.flops);
      row.set("stiffness_cpu", net.stiffness_cpu).set("analysis_cpu", net.analysis_cpu);
      row.set("numeric_cpu", net.numeric_cpu);
    }
    text += row.text();
  }
  return text;
}

std::string length_rows(const results::RunProfile& profile) {
  std::string text;
  std::size_t number = 0;
  for (const CrackLengthCostSum& sum : length_costs(profile)) {
    ProfileCsvRow row("length", sum.label);
    row.set("length", ++number).set("a", sum.work->a).set("cpu", sum.work->cpu);
    row.set("wall", sum.work->end - sum.work->begin).set("flops", sum.flops);
    row.set("condensed", sum.condensed.size()).set("reused", sum.reused.size());
    text += row.text();
  }
  return text;
}

std::string floor_row(const CostFloor& floor) {
  ProfileCsvRow row("floor", "plain factorisation");
  if (!floor.why_not.empty()) {
    return row.words("why", floor.why_not).text();
  }
  row.set("calls", floor.times)
      .set("cpu", floor.seconds_without_assembly())
      .set("flops", floor.flops);
  row.set("freedoms", floor.equations).set("externals", 0).set("nonzeros", floor.entries);
  row.set("stiffness_cpu", floor.assembly).set("analysis_cpu", floor.analysis);
  return row.set("numeric_cpu", floor.numeric).set("solution_cpu", floor.solution).text();
}

} // namespace

std::string profile_csv(const ProfileRecord& record) {
  std::string text = "# cpu, wall: s; share: of all cpu; resident, peak, raised: bytes; a: length "
                     "unit of the deck; empty: unknown, or no matter of the row\n";
  for (std::size_t c = 0; c < columns.size(); ++c) {
    text += fmt::format("{}{}", c == 0 ? "" : ",", columns[c]);
  }
  return text + "\n" + processor_rows(record) + net_rows(record.profile) +
         length_rows(record.profile) + floor_row(record.floor);
}

} // namespace spricka::program
